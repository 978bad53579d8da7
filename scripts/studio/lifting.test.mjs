// Lifting a corner: the arrow, the keys, the dock that stays where it is, and the edges that add no point by accident.

import assert from 'node:assert/strict';
import { drag, onStage, pixels, points, request, solved, test, useStudio } from './harness.mjs';

const studio = useStudio();
const SQUARE = [[0.35, 0.4], [0.6, 0.38], [0.65, 0.6], [0.36, 0.62], [0.35, 0.4]];
const HEIGHTS = { 1440: 900, 1280: 720, 820: 700 };

async function drawSquare(page) {
  await page.click('#intro-draw');
  const box = await page.locator('#view').boundingBox();
  for (const [x, y] of SQUARE) await page.mouse.click(box.x + x * box.width, box.y + y * box.height);
}
/** Pixels of the arrow's colour, which nothing else on the stage has. */
const arrowPixels = async (page) => (await pixels(page)).filter(([r, g, b]) => r > 160 && g > 60 && g < 120 && b < 70).length;

test.quick('the first closed loop asks for a lift, and the words at the arrow stay while the film follows', async () => {
  const { page } = studio;
  await studio.open();
  await drawSquare(page);
  await solved(page);
  assert.equal(await page.textContent('#label'), 'Pull this corner up');
  assert.equal(await page.isVisible('#label'), true, 'the film did not take it away');
  assert.ok(await arrowPixels(page) > 20, 'the arrow is bold, in a colour of its own');
  const [{ point }] = await page.evaluate(() => window.studio.selection());
  const grip = (await points(page))[point];
  await page.mouse.move(...await onStage(page, { x: grip.x, y: grip.y - 42 }));
  await page.mouse.down();
  await page.mouse.move(...await onStage(page, { x: grip.x, y: grip.y - 110 }), { steps: 6 });
  await solved(page);
  assert.match(await page.textContent('#label'), /^z [\d.]+ m$/);
  assert.equal(await page.isVisible('#label'), true, 'the height stays beside the point through a live solve');
  await page.mouse.up();
  await solved(page);
  const { boundaries: [boundary] } = await request(page);
  assert.deepEqual(boundary.map(([, , z]) => z > 0), boundary.map((_, i) => i === point), 'one corner is lifted');
  assert.match(await page.textContent('#announcement'), /^boundary 1, point \d: moved to .* m$/);
});

test('Shift lifts a point whether it is held before the press or after it, and no other point moves', async () => {
  const { page } = studio;
  await studio.open('tent');
  const before = (await request(page)).boundaries[0];
  const seen = await points(page);
  await page.mouse.click(...await onStage(page, seen[0]));
  await drag(page, seen[2], { x: seen[2].x, y: seen[2].y - 60 }, { keys: ['Shift'] });
  const first = (await request(page)).boundaries[0];
  assert.deepEqual(first.map((point, i) => JSON.stringify(point) !== JSON.stringify(before[i])), before.map((_, i) => i === 2), 'only the point under the pointer moves');
  assert.ok(first[2][2] > before[2][2]);
  assert.deepEqual(first[2].slice(0, 2), before[2].slice(0, 2), 'straight up');

  const [, at] = await points(page);
  await page.mouse.move(...await onStage(page, at));
  await page.mouse.down();
  await page.keyboard.down('Shift');
  await page.mouse.move(...await onStage(page, { x: at.x, y: at.y - 60 }), { steps: 5 });
  await page.mouse.up();
  await page.keyboard.up('Shift');
  const second = (await request(page)).boundaries[0];
  assert.ok(second[1][2] > before[1][2]);
  assert.deepEqual(second[1].slice(0, 2), before[1].slice(0, 2));
});

test('a click or a drag beside the handle of an edge adds no point', async () => {
  const { page } = studio;
  await studio.open('tent');
  const before = await request(page);
  const on = (t) => page.evaluate(([a, b, share]) => window.studio.project(a.map((value, axis) => value + share * (b[axis] - value))), [...before.boundaries[0].slice(0, 2), t]);
  const quarter = await on(0.22);
  await page.mouse.click(...await onStage(page, quarter));
  const seen = await points(page);
  await drag(page, quarter, { x: quarter.x + 60, y: quarter.y });
  assert.deepEqual(await request(page), before);
  const turned = await points(page);
  assert.ok(Math.hypot(turned[0].x - seen[0].x, turned[0].y - seen[0].y) > 5, 'the drag orbits');
});

test('the dock keeps its height, and the model its place, whatever is chosen', async () => {
  const { page } = studio;
  for (const width of [1440, 1280, 820]) {
    await page.setViewportSize({ width, height: HEIGHTS[width] });
    await studio.open('tent');
    const places = async () => ({ dock: await page.locator('#dock').boundingBox(), point: (await points(page))[1] });
    const before = await places();
    await page.mouse.click(...await onStage(page, before.point));
    assert.deepEqual(await places(), before, `a chosen point at ${width}`);
    await page.click('#draw');
    assert.deepEqual((await places()).dock, before.dock, `drawing at ${width}`);
    await page.click('#give-up');
    for (const part of await page.locator('#dock button:visible').all()) {
      const { y, height } = await part.boundingBox();
      assert.ok(y >= before.dock.y && y + height <= before.dock.y + before.dock.height, 'every button is seen');
    }
  }
});

test('the keyboard stays at the stage after a line and after Escape, and an edge of no length is refused', async () => {
  const { page } = studio;
  const focused = () => page.evaluate(() => document.activeElement.id);
  await studio.open();
  await page.uncheck('#live');
  await page.click('#intro-draw');
  for (const text of ['0, 0', '@4, 0', '@0, 3']) {
    await page.keyboard.type(text);
    await page.keyboard.press('Enter');
  }
  await page.keyboard.press('Enter');
  assert.equal(await focused(), 'view', 'after Enter');
  await page.keyboard.press('Escape');
  assert.equal(await focused(), 'view');
  assert.deepEqual(await page.evaluate(() => window.studio.selection()), []);
  await page.keyboard.press(']');
  await page.keyboard.press('PageUp');
  assert.match(await page.textContent('#announcement'), /^boundary 1, point 1: moved to 0, 0, [\d.]+ m$/);
  const before = await request(page);
  for (const text of ['-5', '0']) {
    await page.fill('#edge', text);
    await page.keyboard.press('Enter');
    assert.match(await page.textContent('#toast'), new RegExp(`must be longer than 0, and "${text}" is not`));
    assert.notEqual(await page.inputValue('#edge'), text, 'the field shows the length again');
    assert.deepEqual(await request(page), before);
  }
  await page.focus('#point [data-axis="0"]');
  await page.keyboard.press('Escape');
  assert.equal(await focused(), 'view');
});
