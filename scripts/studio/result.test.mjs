// A result as an architect reads it: span, rise, area and forces first, reactions as a table and at their arrows, the
// solver's figures folded away, and a unit at every figure that has one.

import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { onStage, points, showPanel, solved, test, useStudio } from './harness.mjs';

const studio = useStudio();
const figures = (page) => page.locator('#figures .figure').evaluateAll((all) => Object.fromEntries(all.map((each) => [each.querySelector('.name').textContent, each.querySelector('.value').textContent])));
const job = async (page) => (await fetch(`${studio.url}/v1/jobs/${await page.evaluate(() => window.studio.shown().job)}`)).json();

test.quick('span, rise, area and forces come first, each with its unit, and the solver is folded up', async () => {
  const { page } = studio;
  await studio.open('four-point-sail');
  await showPanel(page, 'results');
  const found = await figures(page);
  const { statistics } = await job(page);
  const largest = Math.max(...statistics.reactions.map(({ force }) => Math.hypot(...force)));
  assert.deepEqual([found.Span, found.Rise, found.Area], ['10 × 10 m', '4 m', `${Number(statistics.area.toPrecision(4))} m²`]);
  assert.equal(found['Largest reaction'], `${Number(largest.toPrecision(4))} kN`);
  assert.match(found['Largest cable force: east'], /^[\d.]+ kN$/);
  for (const word of ['Residual', 'Iterations', 'Euler', 'eigenvalue', 'inertia']) assert.ok(!(await page.locator('#result').innerText()).includes(word), `${word} is folded up`);
  assert.equal(await page.isVisible('#charts'), false);
  await page.click('#numerics summary');
  assert.match(await page.locator('#numerics').innerText(), /Residual/);
});

test.quick('reactions are a table with components and resultant, a file, and labels at their arrows', async () => {
  const { page } = studio;
  await studio.open('four-point-sail');
  await showPanel(page, 'results');
  const { statistics: { reactions } } = await job(page);
  assert.equal(await page.textContent('#details h2'), 'Reactions in kN');
  const rows = await page.locator('#reactions tbody tr').evaluateAll((all) => all.map((row) => [...row.cells].map((cell) => cell.textContent.replace('−', '-'))));
  assert.deepEqual(rows, reactions.map(({ boundary, point, force }) => [`Boundary ${boundary + 1}, point ${point + 1}`, ...[...force, Math.hypot(...force)].map((value) => String(Number(value.toPrecision(3))))]));
  const [download] = await Promise.all([page.waitForEvent('download'), page.click('#reactions-csv')]);
  assert.match(download.suggestedFilename(), /-reactions\.csv$/);
  const [head, ...lines] = (await readFile(await download.path(), 'utf8')).trim().split('\n');
  assert.equal(head, 'Anchor,x [kN],y [kN],z [kN],Resultant [kN]');
  assert.deepEqual(lines.map((line) => line.split('",')[1].split(',').slice(0, 3).map(Number)), reactions.map(({ force }) => force));
  assert.equal(await page.locator('.tag').count(), 0);
  await page.click('#layers button:text-is("Reactions")');
  const sizes = reactions.map(({ force }) => `${Number(Math.hypot(...force).toPrecision(3))} kN`).sort();
  assert.deepEqual((await page.locator('.tag').allTextContents()).sort(), sizes);
  const stage = await page.locator('#stage').boundingBox();
  for (const tag of await page.locator('.tag:visible').all()) {
    const box = await tag.boundingBox();
    assert.ok(box.x > stage.x && box.x + box.width < stage.x + stage.width + 4 && box.y > stage.y, 'each label is on the stage');
  }
  assert.ok(await page.locator('.tag:visible').count() >= 3);
  await page.click('#layers button:text-is("Reactions")');
  assert.equal(await page.locator('.tag').count(), 0);
});

/** Figures without a unit: counts, ratios, angles whose title has the sign, and figures without a dimension. */
const BARE = /^(Triangles|Vertices|Nodes|Edges|Members|Bridges|Convex bridges|Convex bridge ratio|Crossing pairs of triangles|Boundary loops|Components|Euler characteristic|Genus|Residual.*|Iterations|Morse index|Lowest eigenvalue|Edges swapped|Flipped triangles|Degenerate triangles|Equal edges|Distinct lengths|Out of range edges|Count|Curvature|Optimised|Boundary|Rim|Deviation.*|Imbalance|Gradient|Gap|Bending energy|Total normal twist|Mean curvature variation|Normal variation|Objective value|Area error|Edge length error max|.*\(°\)|.*\(s\)|.*seconds.*)$/i;

test('every figure with a dimension has its unit, in each kind of result', async () => {
  const { page } = studio;
  for (const example of ['tent', 'wavy-strip', 'vault', 'four-point-sail', 'air-hall', 'four-cables']) {
    await studio.open(example);
    const bare = await page.locator('#statistics > table.plain tr, #numbers > table.plain tr').evaluateAll((rows) => rows.filter((row) => row.cells.length === 2 && /^[−\d]/.test(row.cells[1].textContent) && !/[a-z°²³]$/i.test(row.cells[1].textContent))
      .map((row) => row.cells[0].textContent));
    await showPanel(page, 'results');
    assert.doesNotMatch(await page.locator('#result').innerText(), /×10⁻/, `the rounding of ${example} is folded up`);
    assert.equal(await page.locator('#statistics > table.plain td:text-is("—")').count(), 0, `no figure of ${example} is empty`);
    assert.ok(bare.length > 2, example);
    assert.deepEqual(bare.filter((name) => !BARE.test(name)), [], example);
  }
});

test('sentences about places count from 1, also where the service says them', async () => {
  const { page } = studio;
  await studio.open('tent');
  await page.uncheck('#live');
  await page.route('**/v1/minimal-surfaces', (route) => route.fulfill({
    status: 422, contentType: 'application/problem+json',
    body: JSON.stringify({ type: '/problems/invalid-request', title: 'The request is invalid', detail: 'see errors', errors: [{ pointer: '/boundaries/0/1', detail: 'is too near to point 3 of boundary 0' }] }),
  }));
  await page.mouse.click(...await onStage(page, (await points(page))[0]));
  await page.locator('#view').focus();
  await page.keyboard.press('PageUp');
  await page.click('#solve');
  await page.locator('#problem').waitFor();
  assert.match(await page.textContent('#problem'), /Boundary 1, point 2 is too near to point 4 of boundary 1/);
  await page.unroute('**/v1/minimal-surfaces');
  await page.click('#solve');
  await solved(page);
});
