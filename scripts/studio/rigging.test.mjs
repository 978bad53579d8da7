// Tensile structures without JSON. Masts, stays, ridge cables and supports are placed on the stage, by pointer and by
// keyboard. They follow their corners, and their values stand in the panel.

import assert from 'node:assert/strict';
import { apply, atRest, onStage, points, request, showPanel, solved, test, useStudio } from './harness.mjs';

const studio = useStudio();
const SAIL = { kind: 'tensile_structure', boundaries: [[[0, 0, 0], [10, 0, 3], [10, 10, 0], [0, 10, 3]]], film: { tension: 1 }, resolution: { triangles: 300 } };
const job = async (page) => (await fetch(`${studio.url}/v1/jobs/${await page.evaluate(() => window.studio.shown().job)}`)).json();
const statistics = async (page) => {
  await page.waitForFunction(() => !window.studio.shown().job.startsWith('page-'));
  return (await job(page)).statistics;
};
const distance = ([a, b]) => Math.hypot(...a.map((value, axis) => value - b[axis]));

async function open(page, value = SAIL) {
  await studio.open('tent');
  await page.waitForFunction(() => document.querySelector('#options').childElementCount > 0);
  await apply(page, value);
  await solved(page);
  await atRest(page);
}

async function choose(page, rig) {
  if (await page.getAttribute('#cabling', 'aria-pressed') === 'false') await page.click('#cabling');
  await page.click(`#rigs [data-rig="${rig}"]`);
}

/** Clicks a point of the drawing. */
const clickPoint = async (page, point) => page.mouse.click(...await onStage(page, (await points(page))[point]));
/** Steps to a point and takes it, with the keys of the stage. */
async function takeByKeys(page, point) {
  await page.locator('#view').focus();
  for (let presses = 0; presses < 20 && (await page.evaluate(() => window.studio.selection()))[0]?.point !== point; presses += 1) await page.keyboard.press(']');
  await page.keyboard.press('Enter');
}

for (const [way, take] of [['pointer', clickPoint], ['keyboard', takeByKeys]]) {
  (way === 'pointer' ? test.quick : test)(`a sail is hung on two masts with their stays by ${way}, and stands as it was drawn`, async () => {
    const { page } = studio;
    await open(page);
    await choose(page, 'mast');
    for (const corner of [1, 3]) {
      await take(page, corner);
      await solved(page);
    }
    const { masts, cables, free_points: free } = await request(page);
    assert.deepEqual(masts.map(({ name, points: ends, mode, value }) => [name, ends, mode, value]), [
      ['mast 1', [[10, 0, 0], [10, 0, 3]], 'length', 3], ['mast 2', [[0, 10, 0], [0, 10, 3]], 'length', 3],
    ]);
    assert.deepEqual(free, [{ point: 1 }, { point: 3 }]);
    assert.equal(cables.filter(({ along }) => along).length, 4, 'the edges hang on cables');
    const stays = cables.filter(({ points: ends }) => ends);
    assert.deepEqual(stays.map(({ name }) => name), ['stay 1', 'stay 2', 'stay 3', 'stay 4']);
    for (const { points: [corner, anchor], value } of stays) {
      assert.equal(anchor[2], 0, 'stays end on the ground');
      assert.ok(Math.hypot(anchor[0] - 5, anchor[1] - 5) > Math.hypot(corner[0] - 5, corner[1] - 5), 'outside of the sail');
      assert.ok(Math.abs(value - distance([corner, anchor])) < 1e-9);
    }
    const found = await statistics(page);
    assert.ok(found.masts.every(({ force, length }) => force > 1 && Math.abs(length - 3) < 1e-6), JSON.stringify(found.masts));
    assert.ok(found.cables.every(({ force }) => force > 0), 'no cable is slack');
    assert.equal((await job(page)).warnings.length, 0);
    assert.deepEqual((await page.locator('#reactions tbody th').allTextContents()).filter((name) => !name.startsWith('Boundary')).sort(), ['Mast 1, foot', 'Mast 2, foot', 'Stay 1, anchor', 'Stay 2, anchor', 'Stay 3, anchor', 'Stay 4, anchor']);
  });
}

test('a mast and its stays follow their corner and their foot, and a foot takes its mast away', async () => {
  const { page } = studio;
  await open(page);
  await choose(page, 'mast');
  await clickPoint(page, 1);
  await solved(page);
  await page.keyboard.press('Escape');
  await page.locator('#view').focus();
  await page.keyboard.press(']');
  await page.keyboard.press(']');
  await page.keyboard.press('PageUp');
  let { boundaries: [[, corner]], masts: [mast], cables } = await request(page);
  assert.ok(corner[2] > 3);
  assert.deepEqual(mast.points, [[10, 0, 0], corner]);
  assert.equal(mast.value, corner[2]);
  for (const { points: ends, value } of cables.filter((each) => each.points)) assert.ok(Math.abs(value - distance(ends)) < 1e-9 && String(ends[0]) === String(corner));
  await solved(page);
  // The foot is the first point after those of the boundary.
  for (let presses = 0; presses < 3; presses += 1) await page.keyboard.press(']');
  assert.match(await page.textContent('#point-name'), /^Mast 1/);
  await page.fill('#point [data-axis="0"]', '10.5');
  await page.keyboard.press('Enter');
  ({ masts: [mast] } = await request(page));
  assert.deepEqual(mast.points, [[10.5, 0, 0], corner]);
  assert.ok(Math.abs(mast.value - distance(mast.points)) < 1e-9);
  await solved(page);
  await page.locator('#view').focus();
  await page.keyboard.press('Delete');
  assert.deepEqual((await request(page)).masts, []);
  await page.click('#undo');
  assert.equal((await request(page)).masts.length, 1);
  // The mast and the stays go with a corner that is deleted.
  await page.uncheck('#live');
  await page.locator('#view').focus();
  await page.keyboard.press('Escape');
  await page.keyboard.press(']');
  await page.keyboard.press(']');
  await page.keyboard.press('Delete');
  const left = await request(page);
  assert.deepEqual([left.boundaries[0].length, left.masts, left.cables.filter((each) => each.points)], [3, undefined, []]);
});

test('a stay ends where the ground is pressed, a ridge cable runs across the film, and a support is freed and held', async () => {
  const { page } = studio;
  await open(page);
  await choose(page, 'ridge');
  assert.match(await page.textContent('#hint'), /where the ridge cable begins/);
  await clickPoint(page, 1);
  assert.match(await page.textContent('#hint'), /where it ends/);
  await clickPoint(page, 2);
  assert.match(await page.textContent('#toast'), /no neighbour/);
  await clickPoint(page, 1);
  await clickPoint(page, 3);
  await solved(page);
  const [ridge] = (await request(page)).cables;
  assert.deepEqual([ridge.name, ridge.across], ['ridge 1', [[10, 0, 3], [0, 10, 3]]]);
  for (let presses = 0; presses < 6; presses += 1) await page.keyboard.press('-');
  await atRest(page);
  await choose(page, 'stay');
  await clickPoint(page, 1);
  const anchor = await page.evaluate(() => window.studio.project([12, -1, 0]));
  await page.mouse.click(...await onStage(page, anchor));
  await solved(page);
  const stay = (await request(page)).cables.find(({ name }) => name === 'stay 1');
  assert.deepEqual(stay.points[0], [10, 0, 3]);
  assert.ok(Math.hypot(stay.points[1][0] - 12, stay.points[1][1] + 1) < 0.1 && Math.abs(stay.points[1][2]) < 1e-6, String(stay.points[1]));
  assert.deepEqual((await request(page)).free_points, [{ point: 1 }]);
  await choose(page, 'hold');
  await clickPoint(page, 1);
  await solved(page);
  const held = await request(page);
  assert.equal(held.free_points, undefined);
  assert.equal(held.cables.some(({ name }) => name === 'stay 1'), false, 'a support needs no stay');
});

test('tension, pressure, weight and the masts stand beside, and a mast holds a force instead of its length', async () => {
  const { page } = studio;
  await open(page);
  await choose(page, 'mast');
  await clickPoint(page, 1);
  await solved(page);
  await showPanel(page, 'setup');
  const found = (await statistics(page)).masts[0];
  for (const path of ['film.tension', 'pressure', 'film.weight']) assert.equal(await page.isVisible(`#options [data-path="${path}"]`), true, path);
  const row = page.locator('#cables tr', { has: page.locator('button[title="mast 1"]') });
  for (const control of ['select', 'input']) {
    const [cable, mast] = await Promise.all([page.locator(`#cables tbody ${control}`).first(), row.locator(control)].map((each) => each.boundingBox()));
    assert.deepEqual([mast.x, mast.width], [cable.x, cable.width], `the ${control} is in line with those of the cables`);
  }
  await row.locator('select').selectOption('force');
  const { masts: [mast] } = await request(page);
  assert.equal(mast.mode, 'force');
  assert.ok(Math.abs(mast.value / found.force - 1) < 1e-4, 'the force that it had');
  await solved(page);
  await row.locator('button').click();
  assert.match(await page.textContent('#point-name'), /^Mast 1/);
  await page.fill('#options [name="film.weight"]', '0.02');
  await page.keyboard.press('Tab');
  assert.equal((await request(page)).film.weight, 0.02);
  await solved(page);
});
