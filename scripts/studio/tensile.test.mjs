// Cables: drawn by clicks on the boundary, coloured by their forces, and the reactions at their ends.

import assert from 'node:assert/strict';
import { createRequire } from 'node:module';
import { fileURLToPath } from 'node:url';
import { apply, onStage, pixels, points, request, showPanel, solved, test, useStudio } from './harness.mjs';

const studio = useStudio();
/** A square whose points the studio can be told apart by. */
const SAIL = {
  kind: 'tensile_structure', boundaries: [[[0, 0, 0], [10, 0, 3], [10, 10, 0], [0, 10, 3]]], film: { tension: 1 }, cables: [], resolution: { triangles: 300 },
};
const middle = (a, b) => ({ x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 });
const click = async (page, place) => page.mouse.click(...await onStage(page, place));

/** The job of the service with what is shown, which takes over a result of the page after a moment. */
async function job(page) {
  await page.waitForFunction(() => /^[0-9A-Z]{26}$/i.test(document.querySelector('#job-id').textContent));
  return (await fetch(`${studio.url}/v1/jobs/${await page.textContent('#job-id')}`)).json();
}

async function openSail(page, extra = {}) {
  await studio.open('plane-sail');
  await apply(page, { ...SAIL, ...extra });
  await solved(page);
}

test.quick('a click on a boundary hangs that edge on a cable, and its dock changes it', async () => {
  const { page } = studio;
  await openSail(page);
  await page.click('#cabling');
  assert.equal(await page.getAttribute('#cabling', 'aria-pressed'), 'true');
  const [a, b] = await points(page);
  await click(page, middle(a, b));
  assert.deepEqual((await request(page)).cables, [{ along: { boundary: 0, from: 0, to: 1 }, mode: 'force', value: 14 }]);
  await solved(page);
  assert.match(await page.textContent('#statistics'), /Cables \(1\)/);
  // The same edge again chooses the cable instead of making another.
  await click(page, middle(a, b));
  assert.equal((await request(page)).cables.length, 1);
  assert.equal(await page.textContent('#cable-name'), 'Cable 1');
  await page.fill('#cable-value', '20');
  await page.keyboard.press('Tab');
  assert.equal((await request(page)).cables[0].value, 20);
  await solved(page);
  // Another mode keeps the shape: its value is that of the result.
  const { length } = (await job(page)).statistics.cables[0];
  await page.selectOption('#cable-mode', 'length');
  const [cable] = (await request(page)).cables;
  assert.equal(cable.mode, 'length');
  assert.ok(Math.abs(cable.value / length - 1) < 1e-5, `${cable.value} ${length}`);
  assert.equal(await page.textContent('#cable-unit'), 'm');
  await solved(page);
  await page.click('#drop-cable');
  assert.deepEqual((await request(page)).cables, []);
  await page.keyboard.press('Control+z');
  assert.equal((await request(page)).cables.length, 1, 'removing is one step of undo');
  await page.keyboard.press('Escape');
  assert.equal(await page.getAttribute('#cabling', 'aria-pressed'), 'false');
});

test('four edges of unequal lengths are hung on cables by a click each, and are in equilibrium', async () => {
  const { page } = studio;
  await openSail(page, { boundaries: [[[0, 0, 0], [3, 0, 1], [12, 9, 0], [0, 10, 2]]] });
  await page.uncheck('#live');
  await page.click('#cabling');
  const places = await points(page);
  for (const edge of [0, 1, 2, 3]) await click(page, middle(places[edge], places[(edge + 1) % 4]));
  const { cables } = await request(page);
  assert.equal(cables.length, 4);
  assert.ok(cables[1].value > 3 * cables[0].value, 'a longer cable has a larger force');
  await page.click('#solve');
  await solved(page);
});

test('cables have values by which 100 drawn quadrilaterals and pentagons are in equilibrium', async () => {
  // The page's own function, without the page.
  const { build } = createRequire(new URL('../../web/package.json', import.meta.url))('esbuild');
  const entry = fileURLToPath(new URL('../../web/src/model/cables.ts', import.meta.url));
  const { outputFiles: [{ text }] } = await build({ entryPoints: [entry], bundle: true, format: 'esm', write: false });
  const { addCable } = await import(`data:text/javascript;base64,${Buffer.from(text).toString('base64')}`);
  let seed = 20;
  const random = () => {
    seed = (Math.imul(seed, 1_664_525) + 1_013_904_223) >>> 0;
    return seed / 2 ** 32;
  };
  // Corners around a centre at distances from 3 to 10, up to 4 high.
  const drawn = (corners) => Array.from({ length: corners }, (_, corner) => {
    const angle = (2 * Math.PI * (corner + 0.9 * (random() - 0.5))) / corners;
    const distance = 3 + 7 * random();
    return [distance * Math.cos(angle), distance * Math.sin(angle), 4 * random()].map((value) => Number(value.toFixed(2)));
  });
  const sags = [];
  const unsolved = [];
  for (let i = 0; i < 100; i += 1) {
    const boundary = drawn(4 + (i % 2));
    const wanted = { boundaries: [boundary], film: { tension: 1 + 4 * random() }, resolution: { triangles: 300 } };
    for (let from = 0; from < boundary.length; from += 1) addCable(wanted, 0, from, (from + 1) % boundary.length);
    const headers = { 'Content-Type': 'application/json', Prefer: 'wait=60' };
    const job = await (await fetch(`${studio.url}/v1/tensile-structures`, { method: 'POST', headers, body: JSON.stringify(wanted) })).json();
    if (job.status !== 'succeeded' || job.statistics.converged !== true) unsolved.push([JSON.stringify(boundary), job.error?.detail ?? job.status]);
    else sags.push(...job.statistics.cables.map(({ sag }, c) => sag / Math.hypot(...boundary[c].map((value, axis) => value - boundary[(c + 1) % boundary.length][axis]))));
  }
  assert.deepEqual(unsolved, []);
  sags.sort((a, b) => a - b);
  // Cables beside sharp corners sag less.
  assert.ok(Math.abs(sags[Math.floor(sags.length / 2)] - 0.1) < 0.005, `the middle of the sags is ${sags[Math.floor(sags.length / 2)]} of the chord`);
  assert.ok(sags.at(-1) < 0.11, `the largest sag is ${sags.at(-1)} of the chord`);
});

test('a structure without equilibrium offers to double the forces of its cables, which solves it', async () => {
  const { page } = studio;
  await studio.open('plane-sail');
  const cables = [0, 1, 2, 3].map((from) => ({ along: { from, to: (from + 1) % 4 }, value: 4 }));
  await apply(page, { ...SAIL, cables });
  await page.click('#problem .remedy:text-is("Double the forces of the cables")');
  assert.deepEqual((await request(page)).cables.map(({ value }) => value), [8, 8, 8, 8]);
  await solved(page);
  assert.equal(await page.isVisible('#problem'), false);
  await page.click('#undo');
  assert.deepEqual((await request(page)).cables, cables, 'the remedy is one step of undo');
});

test('two points make a cable along several edges, in the direction of the boundary', async () => {
  const { page } = studio;
  await openSail(page, { boundaries: [[[0, 0, 0], [5, 0, 1], [10, 0, 3], [10, 10, 0], [0, 10, 3]]] });
  await page.uncheck('#live');
  await page.click('#cabling');
  const places = await points(page);
  await click(page, places[2]);
  await click(page, places[0]);
  assert.deepEqual((await request(page)).cables.map(({ along }) => along), [{ boundary: 0, from: 0, to: 2 }]);
  // A cable in the way of another gives way.
  await click(page, places[1]);
  await click(page, places[3]);
  assert.deepEqual((await request(page)).cables.map(({ along }) => along), [{ boundary: 0, from: 1, to: 3 }]);
});

test('a selected point offers a cable to the next one, for the keyboard', async () => {
  const { page } = studio;
  await openSail(page);
  await page.uncheck('#live');
  await page.focus('#view');
  for (let i = 0; i < 4; i += 1) await page.keyboard.press(']');
  await page.click('#cable-from-point');
  assert.deepEqual((await request(page)).cables.map(({ along }) => along), [{ boundary: 0, from: 3, to: 0 }]);
  assert.ok(await page.isVisible('#cable'));
  await page.focus('#view');
  await page.keyboard.press('Delete');
  assert.deepEqual((await request(page)).cables, []);
});

test('cables follow points that are added and removed', async () => {
  const { page } = studio;
  const cables = [{ along: { from: 1, to: 2 }, value: 10 }, { along: { from: 3, to: 0 }, value: 10 }];
  await openSail(page, { cables });
  await page.uncheck('#live');
  await page.focus('#view');
  await page.keyboard.press(']');
  await page.keyboard.press('Insert');
  assert.deepEqual((await request(page)).cables.map(({ along }) => along), [{ from: 2, to: 3 }, { from: 4, to: 0 }]);
  await page.keyboard.press('Delete');
  assert.deepEqual((await request(page)).cables.map(({ along }) => along), [{ from: 1, to: 2 }, { from: 3, to: 0 }]);
  // The selection is now the point at which the first cable begins. A cable of one edge goes with its point.
  await page.keyboard.press('Delete');
  assert.deepEqual((await request(page)).cables.map(({ along }) => along), [{ from: 2, to: 0 }]);
});

test('cables are coloured by their forces with a legend, and reactions are arrows to be switched on', async () => {
  const { page } = studio;
  for (const name of ['four-point-sail', 'cable-net-by-targets']) {
    await studio.open(name);
    assert.equal(await page.inputValue('#quantity'), 'line:force', name);
    assert.match(await page.textContent('#scale-note'), /Force \[kN\]/);
    const off = page.locator('#layers button', { hasText: 'Reactions' });
    assert.equal(await off.getAttribute('aria-pressed'), 'false');
    // The arrows are pink, which the scale from violet to yellow is nowhere.
    const pink = async () => (await pixels(page)).filter(([r, g, b]) => r > g + 80 && b > g + 40).length;
    assert.equal(await pink(), 0, `${name}: no arrows before`);
    await off.click();
    assert.ok(await pink() > 5, `${name}: arrows`);
    await off.click();
    assert.equal(await pink(), 0, `${name}: no arrows after`);
  }
});

test('a click on a cable reads its force', async () => {
  const { page } = studio;
  await studio.open('four-cables');
  const { cables } = (await job(page)).statistics;
  assert.ok(Math.abs(cables[0].force - 5) < 1e-6 && Math.abs(cables[1].force - 6) < 1e-6, JSON.stringify(cables));
  const mesh = await (await fetch(`${studio.url}/v1/jobs/${(await job(page)).id}/mesh?format=json`)).json();
  const at = mesh.vertices[0].map((value, axis) => 0.6 * value + 0.4 * mesh.vertices[4][axis]);
  await click(page, await page.evaluate((point) => window.studio.project(point), at));
  assert.match(await page.textContent('#label'), /^Force 5 kN$/);
});

test.quick('a net is shown without triangles, its supports move, and none of its points is removed', async () => {
  const { page } = studio;
  await studio.open('four-cables');
  assert.match(await page.textContent('#status'), /4 edges/);
  assert.equal((await points(page)).length, 4, 'the free vertex is no handle');
  assert.ok(await page.isDisabled('#draw'));
  const layers = await page.locator('#layers button').allTextContents();
  assert.deepEqual(layers, ['Lines', 'Reactions', 'Drawing', 'Box']);
  await showPanel(page, 'results');
  assert.deepEqual(await page.locator('#downloads button').allTextContents(), ['GLB', 'GLTF', 'OBJ', 'PLY']);
  await page.focus('#view');
  await page.keyboard.press(']');
  assert.ok(await page.isDisabled('#delete-point') && await page.isDisabled('#insert-point'));
  await page.keyboard.press('Delete');
  assert.equal((await request(page)).vertices.length, 5);
  const before = (await request(page)).vertices[0];
  await page.keyboard.press('PageUp');
  assert.ok((await request(page)).vertices[0][2] > before[2]);
  await solved(page);
});

test('the panel begins with tension, pressure, weight and a table of the cables, and a value set there is solved', async () => {
  const { page } = studio;
  await studio.open('four-point-sail');
  const first = await page.locator('#options > *').evaluateAll((fields) => fields.slice(0, 4).map((field) => field.dataset.path ?? field.id));
  assert.deepEqual(first, ['film.tension', 'pressure', 'film.weight', 'cables']);
  assert.match(await page.textContent('#options [data-path="film.tension"]'), /Tension kN\/m/);
  const rows = page.locator('#cables tbody tr');
  assert.deepEqual(await rows.locator('th').allTextContents(), ['south', 'east', 'north', 'west']);
  await rows.nth(0).locator('input').fill('24');
  await page.keyboard.press('Tab');
  assert.equal((await request(page)).cables[0].value, 24);
  await solved(page);
  const statistics = async () => (await job(page)).statistics;
  assert.ok(Math.abs((await statistics()).cables[0].force - 24) < 0.5);
  // Another mode keeps the shape, as in the dock.
  const { sag } = (await statistics()).cables[0];
  await rows.nth(0).locator('select').selectOption('sag');
  assert.ok(Math.abs((await request(page)).cables[0].value / sag - 1) < 1e-5);
  assert.match(await rows.nth(0).textContent(), /m$/);
  await rows.nth(1).locator('button').click();
  assert.equal(await page.textContent('#cable-name'), 'east', 'a name leads to the cable on the stage');

  // The film's other options keep the tension that was set beside them.
  await page.fill('#options [name="film.tension"]', '3');
  await page.keyboard.press('Tab');
  await page.click('#options > details > summary');
  assert.deepEqual((await request(page)).film, { tension: 3, weight: 0.01 });
  await solved(page);
  assert.equal(await page.isVisible('#hang-all'), false, 'every edge has its cable');
  await page.focus('#view');
  await page.keyboard.press('Delete');
  await page.click('#hang-all');
  const { cables } = await request(page);
  assert.deepEqual(cables.map(({ along }) => along.from).sort(), [0, 1, 2, 3]);
});

test('the headlines are span and rise, the largest cable force, the largest reaction and the lengths of the cables', async () => {
  const { page } = studio;
  await openSail(page, { cables: [{ along: { from: 0, to: 1 }, value: 14 }, { along: { from: 1, to: 2 }, value: 17 }] });
  const { statistics } = await job(page);
  const figures = await page.locator('#figures .figure').evaluateAll((all) => all.map((figure) => [figure.querySelector('.name').textContent, figure.querySelector('.value').textContent]));
  const reaction = Math.max(...statistics.reactions.map(({ force }) => Math.hypot(...force)));
  const lengths = statistics.cables.map(({ length }) => Number(length.toPrecision(3))).sort((a, b) => a - b);
  assert.deepEqual(figures.slice(2, 5), [
    // The second cable: the page counts from 1.
    ['Largest cable force: cable 2', '17 kN'],
    ['Largest reaction', `${Number(reaction.toPrecision(4))} kN`],
    ['Cable lengths', `${lengths[0] === lengths[1] ? lengths[0] : lengths.join('–')} m`],
  ]);
  assert.doesNotMatch(await page.textContent('#figures'), /imbalance/i);
  assert.deepEqual(await page.locator('#details table.cables tbody tr').evaluateAll((rows) => rows.map((row) => row.cells[0].textContent)), ['cable 1', 'cable 2']);
});
