// Rectangles, circles, arcs and curves through points are drawn by a few clicks or by typing, as one step of undo for
// the last of them.

import assert from 'node:assert/strict';
import { onStage, request, solved, test, useStudio } from './harness.mjs';

const studio = useStudio();

async function draw(page, shape, places) {
  if (!await page.isVisible('#drawing')) await page.click('#draw');
  await page.selectOption('#shape', shape);
  for (const place of places) {
    await page.keyboard.type(place);
    await page.keyboard.press('Enter');
  }
}
const near = (point, [x, y]) => Math.hypot(point[0] - x, point[1] - y) < 1e-6;

test.quick('a rectangle and a circle take two points each, and the film between them is solved', async () => {
  const { page } = studio;
  await studio.open();
  await page.click('#intro-draw');
  await page.selectOption('#shape', 'rectangle');
  assert.match(await page.textContent('#drawing-hint'), /Click a corner of the rectangle/);
  // By clicks: two opposite corners.
  const { width, height } = await page.locator('#view').boundingBox();
  await page.mouse.click(...await onStage(page, { x: 0.35 * width, y: 0.4 * height }));
  assert.match(await page.textContent('#drawing-hint'), /opposite corner/);
  await page.mouse.click(...await onStage(page, { x: 0.6 * width, y: 0.6 * height }));
  const [[a, b, c, d]] = (await request(page)).boundaries;
  assert.deepEqual([b, d], [[c[0], a[1], 0], [a[0], c[1], 0]]);
  await solved(page);
  await page.click('#undo');
  assert.equal((await page.evaluate(() => window.studio.draft())).length, 1, 'undo takes the last corner back');
  await page.click('#give-up');
  await page.uncheck('#live');
  await draw(page, 'circle', ['1, 2', '4, 6']);
  const [circle] = (await request(page)).boundaries;
  assert.equal(circle.length, 32);
  assert.ok(near(circle[0], [4, 6]), 'it begins at the second point');
  for (const [x, y] of circle) assert.ok(Math.abs(Math.hypot(x - 1, y - 2) - 5) < 1e-6);
});

test('an arc passes its three points, and a curve all of its points, for loops and for rails', async () => {
  const { page } = studio;
  await studio.open();
  await page.uncheck('#live');
  await page.click('#intro-draw');
  await draw(page, 'arc', ['5, 0', '0, 5', '-5, 0']);
  const [arc] = (await request(page)).boundaries;
  assert.ok(near(arc[0], [5, 0]) && near(arc.at(-1), [-5, 0]) && arc.length > 12);
  for (const [x, y] of arc) assert.ok(Math.abs(Math.hypot(x, y) - 5) < 1e-6 && y > -1e-6, 'on the side of the middle point');
  await draw(page, 'curve', ['0, 0', '6, 0', '6, 4', '0, 4']);
  await page.keyboard.press('Enter');
  const curve = (await request(page)).boundaries[1];
  assert.equal(curve.length, 24);
  for (const corner of [[0, 0], [6, 0], [6, 4], [0, 4]]) assert.ok(curve.some((point) => near(point, corner)), `through ${corner}`);

  await studio.open('two-rails');
  await page.click('#draw');
  assert.deepEqual(await page.locator('#shape option:not([hidden])').allTextContents(), ['Points', 'Curve', 'Arc'], 'a rail is open');
  const { length } = (await request(page)).directrices;
  await draw(page, 'curve', ['0, 30', '5, 32', '10, 30']);
  await page.keyboard.press('Enter');
  const rail = (await request(page)).directrices[length];
  assert.equal(rail.length, 13);
  assert.ok(near(rail[0], [0, 30]) && near(rail[6], [5, 32]) && near(rail[12], [10, 30]));
});

test('a curve through points at uneven distances has no loop and keeps close to them', async () => {
  const { page } = studio;
  await studio.open();
  await page.uncheck('#live');
  await page.click('#intro-draw');
  await draw(page, 'curve', ['0, 0', '10, 0', '10.4, 0.4', '10.4, 10']);
  await page.keyboard.press('Enter');
  const [curve] = (await request(page)).boundaries;
  const side = ([px, py], [qx, qy], [rx, ry]) => Math.sign((qx - px) * (ry - py) - (qy - py) * (rx - px));
  const crossings = curve.flatMap((a, i) => curve.slice(i + 2).filter((c, j) => {
    const [b, d] = [curve[i + 1], curve[i + j + 3]];
    return d && side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
  }));
  assert.deepEqual(crossings, []);
  await draw(page, 'curve', ['0, 20', '10, 20', '10, 20.5', '0, 20.5']);
  await page.keyboard.press('Enter');
  const loop = (await request(page)).boundaries[1];
  assert.ok(loop.every(([x]) => x > -0.25 && x < 10.25), 'no farther out than half of its width');
});
