// Drawing and changing points, and the way back.

import assert from 'node:assert/strict';
import { apply, atRest, covered, drag, onStage, points, request, solved, test, useStudio } from './harness.mjs';

const studio = useStudio();

/** Clicks on the stage at fractions of its size. */
async function clicks(page, places) {
  const box = await page.locator('#view').boundingBox();
  for (const [x, y] of places) await page.mouse.click(box.x + x * box.width, box.y + y * box.height);
}
const SQUARE = [[0.35, 0.4], [0.6, 0.38], [0.65, 0.6], [0.36, 0.62]];

test.quick('a boundary is drawn by clicks, closed on its first point, and solved', async () => {
  const { page } = studio;
  await studio.open();
  await page.click('#intro-draw');
  await clicks(page, [...SQUARE, SQUARE[0]]);
  const { boundaries } = await request(page);
  assert.equal(boundaries.length, 1);
  assert.equal(boundaries[0].length, 4, 'the click on the first point ends the line');
  assert.ok(boundaries[0].every(([, , z]) => z === 0), 'drawn on the ground');
  await solved(page);
  assert.match(await page.textContent('#statistics'), /Boundary loops1/);
});

test('while a line is drawn, undo takes back its points one by one and never an earlier line', async () => {
  const { page } = studio;
  await studio.open();
  await page.uncheck('#live');
  await page.click('#intro-draw');
  await clicks(page, [...SQUARE, SQUARE[0]]);
  const whole = await request(page);
  await page.click('#draw');
  await clicks(page, [[0.45, 0.45], [0.5, 0.5]]);
  assert.equal((await page.evaluate(() => window.studio.draft())).length, 2);
  await page.keyboard.press('Control+z');
  assert.equal((await page.evaluate(() => window.studio.draft())).length, 1);
  assert.deepEqual(await request(page), whole, 'the first loop is still there');
  await page.keyboard.press('Control+z');
  await page.keyboard.press('Control+z');
  assert.deepEqual(await request(page), whole);
  assert.equal(await page.evaluate(() => window.studio.draft()), null);
  for (let i = 0; i < 3; i += 1) await page.keyboard.press('Control+Shift+z');
  assert.equal((await page.evaluate(() => window.studio.draft())).length, 2, 'redo brings the points back');
});

test('a line is drawn by typing lengths and coordinates', async () => {
  const { page } = studio;
  await studio.open();
  await page.uncheck('#live');
  await page.click('#intro-draw');
  for (const text of ['0, 0', '@4, 0', '@0, 3', '0, 3, 2']) {
    await page.keyboard.type(text);
    await page.keyboard.press('Enter');
  }
  assert.deepEqual(await page.evaluate(() => window.studio.draft()), [[0, 0, 0], [4, 0, 0], [4, 3, 0], [0, 3, 2]]);
  await page.keyboard.press('Enter');
  assert.deepEqual((await request(page)).boundaries, [[[0, 0, 0], [4, 0, 0], [4, 3, 0], [0, 3, 2]]]);
});

test('drawing shows a rubber band: the length beside the pointer', async () => {
  const { page } = studio;
  await studio.open();
  await page.click('#intro-draw');
  await clicks(page, [[0.35, 0.45]]);
  const box = await page.locator('#view').boundingBox();
  await page.mouse.move(box.x + 0.6 * box.width, box.y + 0.5 * box.height);
  assert.match(await page.textContent('#label'), /^[\d.]+ m/);
  assert.equal(await page.isVisible('#drawing-hint'), true);
  await studio.open('tent');
  await page.click('#draw');
  assert.ok(await covered(page) < 0.02, 'the film is a ghost, which hides nothing of the line');
  await page.click('#give-up');
  assert.ok(await covered(page) > 0.05, 'and comes back');
});

test.quick('a dragged point is solved live, along the ground, and undone in one step', async () => {
  const { page } = studio;
  await studio.open('tent');
  const [before, from] = [await request(page), (await points(page))[1]];
  await drag(page, from, { x: from.x - 50, y: from.y - 25 });
  await solved(page);
  const moved = await request(page);
  assert.notDeepEqual(moved.boundaries[0][1].slice(0, 2), before.boundaries[0][1].slice(0, 2), 'it moved along the ground');
  assert.equal(moved.boundaries[0][1][2], before.boundaries[0][1][2], 'its height stayed');
  assert.deepEqual(moved.boundaries[0][0], before.boundaries[0][0], 'its neighbour stayed');
  await page.click('#undo');
  assert.deepEqual(await request(page), before);
  await page.click('#redo');
  assert.deepEqual(await request(page), moved);
});

test('a lift shows its height, also from above', async () => {
  const { page } = studio;
  await studio.open('tent');
  await page.click('[data-view="top"]');
  await atRest(page);
  const before = (await request(page)).boundaries[0][0];
  await page.mouse.click(...await onStage(page, (await points(page))[0]));
  // The arrow of the selected point lifts it.
  const [grip] = await points(page);
  await page.mouse.move(...await onStage(page, { x: grip.x, y: grip.y - 40 }));
  await page.mouse.down();
  await page.mouse.move(...await onStage(page, { x: grip.x, y: grip.y - 90 }), { steps: 5 });
  assert.match(await page.textContent('#label'), /^z [\d.]+ m$/, 'the height stands beside the point');
  await page.mouse.up();
  const after = (await request(page)).boundaries[0][0];
  assert.ok(after[2] > before[2], 'it was lifted');
  assert.deepEqual(after.slice(0, 2), before.slice(0, 2), 'and stayed in its place');
});

test('a press on the handle in the middle of an edge adds a point there', async () => {
  const { page } = studio;
  await studio.open('tent');
  const before = (await request(page)).boundaries[0];
  const middle = await page.evaluate(([a, b]) => window.studio.project(a.map((value, axis) => (value + b[axis]) / 2)), before);
  await drag(page, middle, { x: middle.x + 12, y: middle.y - 30 });
  const [boundary] = (await request(page)).boundaries;
  assert.equal(boundary.length, before.length + 1);
  assert.deepEqual([boundary[0], boundary[2]], [before[0], before[1]]);
  await page.click('#undo');
  assert.deepEqual((await request(page)).boundaries[0], before, 'adding and moving was one step');
});

test('several points are selected, moved, set and deleted at once', async () => {
  const { page } = studio;
  await studio.open('tent');
  const before = (await request(page)).boundaries[0];
  const seen = await points(page);
  await page.mouse.click(...await onStage(page, seen[0]));
  await page.keyboard.down('Shift');
  await page.mouse.click(...await onStage(page, seen[1]));
  await page.keyboard.up('Shift');
  assert.equal(await page.textContent('#point-name'), '2 points');
  await page.fill('#point [data-axis="2"]', '1.25');
  await page.keyboard.press('Enter');
  assert.deepEqual((await request(page)).boundaries[0].map(([, , z]) => z), [1.25, 1.25, ...before.slice(2).map(([, , z]) => z)]);
  await page.locator('#view').focus();
  await page.keyboard.press('ArrowRight');
  const [boundary] = (await request(page)).boundaries;
  const step = boundary[0][0] - before[0][0];
  assert.ok(step > 0 && Math.abs(boundary[1][0] - before[1][0] - step) < 1e-9 && boundary[2][0] === before[2][0]);
});

test('points are moved, inserted, measured and deleted with the keyboard alone', async () => {
  const { page } = studio;
  await studio.open('tent');
  const before = await request(page);
  await page.locator('#view').focus();
  await page.keyboard.press(']');
  await page.keyboard.press('PageUp');
  await page.keyboard.press('ArrowRight');
  const moved = await request(page);
  assert.ok(moved.boundaries[0][0][2] > before.boundaries[0][0][2] && moved.boundaries[0][0][0] > before.boundaries[0][0][0]);
  await page.keyboard.press(']');
  await page.keyboard.press('Insert');
  assert.equal((await request(page)).boundaries[0].length, before.boundaries[0].length + 1);
  assert.match(await page.textContent('#point-name'), /Boundary 1, 3 of/);
  await page.keyboard.press('Delete');
  assert.deepEqual(await request(page), moved);
  await page.keyboard.press(']');
  const [a, b] = (await request(page)).boundaries[0].slice(1, 3);
  await page.fill('#edge', '7.5');
  await page.keyboard.press('Enter');
  const index = (await page.evaluate(() => window.studio.selection()))[0].point;
  const [line] = (await request(page)).boundaries;
  const length = Math.hypot(...line[index].map((value, axis) => value - line[index - 1][axis]));
  assert.ok(Math.abs(length - 7.5) < 1e-9, `${length}, from ${a} to ${b}`);
});

test('options, examples and kinds are steps of undo too', async () => {
  const { page } = studio;
  await studio.open('tent');
  const before = await request(page);
  assert.equal(await page.isDisabled('#undo'), true, 'nothing to undo yet');
  await page.selectOption('#options [name="objective"]', 'minimal_dirichlet_energy');
  await page.click('#undo');
  assert.deepEqual(await request(page), before);
  await page.locator('#view').focus();
  await page.keyboard.press(']');
  await page.keyboard.press('PageUp');
  const edited = await request(page);
  await page.click('#open-gallery');
  await page.click('#gallery [data-example="vault"]');
  await solved(page);
  await page.click('#undo');
  assert.deepEqual(await request(page), edited, 'choosing an example lost nothing');
  assert.equal(await page.isChecked('#kinds input[value="minimal_surface"]'), true);
});

test('fifty random edits, fifty times undo, fifty times redo, and a reload', async () => {
  const { page } = studio;
  await studio.open('tent');
  await page.uncheck('#live');
  const start = await request(page);
  let seed = 12345;
  const random = (n) => {
    seed = (seed * 1103515245 + 12345) % 2147483648;
    return Math.floor((seed / 2147483648) * n);
  };
  const edits = [
    async () => { for (let i = 0; i <= random(4); i += 1) await page.keyboard.press(']'); await page.keyboard.press('PageUp'); },
    async () => { await page.keyboard.press(']'); await page.keyboard.press('ArrowLeft'); },
    async () => { await page.keyboard.press('['); await page.keyboard.press('ArrowUp'); },
    async () => { await page.keyboard.press(']'); await page.keyboard.press('Insert'); },
    async () => { await page.fill('#options [name="resolution.value"]', String(200 + random(1e6))); await page.keyboard.press('Tab'); },
    async () => {
      const now = (await request(page)).units ?? 'm';
      await page.selectOption('#options [name="units"]', ['mm', 'cm', 'm', 'in', 'ft'].filter((unit) => unit !== now)[random(4)]);
    },
  ];
  await page.locator('#view').focus();
  for (let i = 0; i < 50; i += 1) {
    const before = JSON.stringify(await request(page));
    await edits[random(edits.length)]();
    assert.notEqual(JSON.stringify(await request(page)), before, `edit ${i} changed the request`);
    await page.locator('#view').focus();
  }
  const end = await request(page);
  for (let i = 0; i < 50; i += 1) await page.keyboard.press('Control+z');
  assert.deepEqual(await request(page), start);
  assert.equal(await page.isDisabled('#undo'), true);
  for (let i = 0; i < 50; i += 1) await page.keyboard.press('Control+y');
  assert.deepEqual(await request(page), end);
  await page.goto(`${studio.url}/`);
  await page.waitForFunction((text) => window.studio && JSON.stringify(window.studio.request()) === text, JSON.stringify(end));
});

test('normals come and go with the points of their rail', async () => {
  const { page } = studio;
  await studio.open('wang-tang-v');
  const before = await request(page);
  await page.locator('#view').focus();
  await page.keyboard.press(']');
  await page.keyboard.press('Insert');
  const { directrices, normals } = await request(page);
  assert.equal(directrices[0].length, before.directrices[0].length + 1);
  assert.deepEqual(normals.map((list) => list.length), directrices.map((list) => list.length));
});

test('each kind keeps its own drawing', async () => {
  const { page } = studio;
  await studio.open('tent');
  await page.locator('#view').focus();
  await page.keyboard.press(']');
  await page.keyboard.press('PageUp');
  const draft = await request(page);
  await page.check('#kinds input[value="ruled_surface"]', { force: true });
  await page.waitForFunction(() => 'directrices' in window.studio.request());
  await page.check('#kinds input[value="minimal_surface"]', { force: true });
  await page.waitForFunction(() => 'boundaries' in window.studio.request());
  assert.deepEqual(await request(page), draft);
});

test('survey coordinates are moved without losing a digit of the others', async () => {
  const { page } = studio;
  await studio.open('tent');
  const far = await request(page);
  far.boundaries = far.boundaries.map((line) => line.map(([x, y, z]) => [x + 10_000_123.456, y + 9_700_987.125, z]));
  await apply(page, far);
  await solved(page);
  await page.click('[data-view="fit"]');
  const from = (await points(page))[1];
  await drag(page, from, { x: from.x - 30, y: from.y - 20 });
  const [boundary] = (await request(page)).boundaries;
  assert.ok(Math.hypot(boundary[1][0] - far.boundaries[0][1][0], boundary[1][1] - far.boundaries[0][1][1]) < 5, `${boundary[1]}`);
  assert.deepEqual([boundary[0], boundary[2]], [far.boundaries[0][0], far.boundaries[0][2]]);
});

for (const moment of ['before', 'after']) {
  test(`the request is selected as soon as its box opens, and typed over ${moment} the event of the opening`, async () => {
    const { page } = studio;
    await studio.open('tent');
    const text = await page.evaluate(async (early) => {
      const box = document.querySelector('#request-box');
      const field = document.querySelector('#request');
      const type = () => document.execCommand('insertText', false, 'typed');
      const toggled = new Promise((done) => { box.addEventListener('toggle', done, { once: true }); });
      box.querySelector('summary').click();
      field.focus();
      field.select();
      if (early) type();
      await toggled;
      // The page's own listeners of the event have run by the next task.
      await new Promise((done) => { setTimeout(done); });
      if (!early) type();
      return field.value;
    }, moment === 'before');
    assert.equal(text, 'typed');
  });
}

test('the request box is filled before it opens, by the pointer and by a key, and also without either', async () => {
  const { page } = studio;
  await studio.open('tent');
  const before = await request(page);
  const shown = async () => JSON.parse(await page.inputValue('#request'));
  assert.deepEqual(await page.evaluate(() => {
    document.querySelector('#request-box summary').click();
    return JSON.parse(document.querySelector('#request').value);
  }), before, 'filled within the click');
  await page.click('#request-box summary');
  await page.selectOption('#options [name="objective"]', 'minimal_dirichlet_energy');
  await page.focus('#request-box summary');
  await page.keyboard.press('Enter');
  assert.deepEqual(await shown(), await request(page), 'opened by a key');
  assert.notDeepEqual(await shown(), before);
  await page.keyboard.press('Enter');
  await page.keyboard.press('Control+z');
  assert.deepEqual(await request(page), before);
  // Find-in-page opens the box in this way.
  await page.evaluate(() => { document.querySelector('#request-box').open = true; });
  await page.waitForFunction((text) => JSON.stringify(JSON.parse(document.querySelector('#request').value)) === text, JSON.stringify(before));
});

test('text in the request box stays while the drawing changes, until it is applied or discarded', async () => {
  const { page } = studio;
  await studio.open('tent');
  const shown = async () => JSON.parse(await page.inputValue('#request'));
  await page.click('#request-box summary');
  const [, corner] = await points(page);
  await drag(page, corner, { x: corner.x + 30, y: corner.y + 10 });
  const dragged = await request(page);
  assert.deepEqual(await shown(), dragged, 'the box follows the drawing while nothing is typed there');
  assert.equal(await page.isVisible('#discard-request'), false);

  await page.fill('#request', '{"boundaries": [');
  await page.click('#apply-request');
  assert.match(await page.textContent('#request-fault'), /this is not JSON/);
  const [, moved] = await points(page);
  await drag(page, moved, { x: moved.x - 20, y: moved.y + 10 });
  await solved(page);
  const latest = await request(page);
  assert.notDeepEqual(latest, dragged);
  await page.click('#request-box summary');
  await page.click('#request-box summary');
  assert.equal(await page.inputValue('#request'), '{"boundaries": [', 'the text is still there');
  assert.equal(await page.isVisible('#request-fault'), true, 'and what is wrong with it');

  await page.click('#discard-request');
  assert.deepEqual(await shown(), latest, 'without the text the box shows the drawing as it is now');
  assert.equal(await page.isVisible('#discard-request'), false);
  assert.equal(await page.isVisible('#request-fault'), false);

  await apply(page, { boundaries: [[[0, 0, 0], [4, 0, 1], [4, 4, 0], [0, 4, 1]]] });
  assert.equal(await page.isVisible('#discard-request'), false);
  await page.locator('#title').click();
  await page.keyboard.press('Control+z');
  assert.deepEqual(await shown(), latest, 'after it is applied, the box follows the drawing again');
});
