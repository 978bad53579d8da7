// What is wrong with a drawing is said once, counted from 1, and marked; the drawing stays.

import assert from 'node:assert/strict';
import { apply, request, showPanel, solved, test, useStudio } from './harness.mjs';

const studio = useStudio();
const at = { minimal_surface: (points) => ({ boundaries: [points] }), uniform_mesh: (points) => ({ domain: { polygon: points }, edge_length: 1 }) };
const faulty = (page) => page.evaluate(() => window.studio.faulty());

const CASES = {
  null: [[[0, 0, 0], [8, 0, null], [8, 8, 0], [0, 8, 0]], ['0/1']],
  string: [[[0, 0, 0], 'abc', [8, 8, 0], [0, 8, 0]], ['0/1']],
  collinear: [[[0, 0, 0], [4, 0, 0], [8, 0, 0]], ['0/0', '0/1', '0/2']],
  crossing: [[[0, 0, 0], [8, 8, 0], [8, 0, 0], [0, 8, 0]], ['0/0', '0/1', '0/2', '0/3']],
};

for (const [name, [points, marked]] of Object.entries(CASES)) {
  for (const kind of Object.keys(at)) {
    const register = name === 'crossing' && kind === 'minimal_surface' ? test.quick : test;
    register(`${name}, ${kind}: marked, said once, and the drawing is still there`, async () => {
      const { page } = studio;
      await studio.open('tent');
      await apply(page, at[kind](points));
      await page.locator('#problem').waitFor();
      assert.deepEqual((await faulty(page)).sort(), marked, 'the points are marked');
      const text = await page.textContent('#problem');
      assert.match(text, /point|edge|line/i);
      // Points are counted from 1. Only the example of a point contains a 0.
      assert.doesNotMatch(text.replaceAll('[0, 0, 1.5]', ''), /\/boundaries|\/domain|see errors|\b0\b(?! )/, text);
      const items = await page.locator('#problem li').allTextContents();
      assert.ok(items.length >= 1, text);
      for (const item of items) assert.equal(text.split(item).length - 1, 1, `said once: ${item}`);
      assert.equal((await page.evaluate(() => window.studio.points())).length, points.length, 'every point is drawn');
      assert.deepEqual(Object.values(await request(page))[0], Object.values(at[kind](points))[0], 'the request is as it was given');
      await page.locator('#problem li button').first().click();
      assert.equal(await page.isVisible('#point'), true, 'a press leads to the point');
    });
  }
}

test('equal neighbours are marked, and the warning reads well', async () => {
  const { page } = studio;
  await studio.open('tent');
  await apply(page, at.minimal_surface([[0, 0, 0], [8, 0, 0], [8, 0, 0], [8, 8, 0], [0, 8, 0]]));
  await solved(page);
  assert.deepEqual((await faulty(page)).sort(), ['0/1', '0/2']);
  await showPanel(page, 'results');
  const text = await page.textContent('#warnings');
  assert.doesNotMatch(text, /\b1 points\b/);
  assert.match(text, /1 point/);
});

test('warnings of a strip count from 1', async () => {
  const { page } = studio;
  await studio.open('two-rails');
  await apply(page, { directrices: [[[0, 0, 0], [4, 0, 0], [8, 0, 0]], [[0, 0, 0], [4, 0, 0], [8, 0, 5]]] });
  await solved(page);
  await showPanel(page, 'results');
  const text = await page.textContent('#warnings');
  assert.match(text, /strip 1/i);
  assert.doesNotMatch(text, /strip 0/i);
});

test('JSON that is none is refused with its line, and nothing changes', async () => {
  const { page } = studio;
  await studio.open('tent');
  const before = await request(page);
  await apply(page, '{\n "boundaries": [\n');
  assert.match(await page.textContent('#request-fault'), /Line 3: this is not JSON/);
  assert.deepEqual(await request(page), before);
  await apply(page, '{"kind": "teapot"}');
  assert.match(await page.textContent('#request-fault'), /no kind "teapot"/);
});

test('numbers and units read as people write them', async () => {
  const { page } = studio;
  await studio.open('tent');
  await page.locator('#view').focus();
  await page.keyboard.press(']');
  await page.fill('#point [data-axis="2"]', '1,5');
  await page.keyboard.press('Enter');
  assert.equal((await request(page)).boundaries[0][0][2], 1.5);
  await page.fill('#point [data-axis="2"]', 'high');
  await page.keyboard.press('Enter');
  assert.equal((await request(page)).boundaries[0][0][2], 1.5);
  assert.match(await page.textContent('#toast'), /"high" is not a number/);
});

test('rings that no film connects offer to let it come apart, by one press and one step of undo', async () => {
  const { page } = studio;
  await studio.open('tent');
  const ring = (z) => Array.from({ length: 24 }, (_, i) => [Math.cos((i * Math.PI) / 12), Math.sin((i * Math.PI) / 12), z]);
  const wanted = { boundaries: [ring(0), ring(6)], resolution: { triangles: 500 } };
  await apply(page, wanted);
  await page.click('#problem .remedy:text-is("Let the film come apart")');
  await solved(page);
  assert.equal(await page.isVisible('#problem'), false);
  await page.click('#undo');
  assert.deepEqual(await request(page), wanted);
});
