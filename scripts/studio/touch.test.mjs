// On a phone: one finger drags a point, two fingers always move the view, and the stage has the larger part of the screen.

import assert from 'node:assert/strict';
import { beforeEach } from 'node:test';
import { atRest, onStage, points, request, showPanel, solved, test, useStudio } from './harness.mjs';

const studio = useStudio({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
let page, session;
beforeEach(async () => {
  page = studio.page;
  session = await studio.context.newCDPSession(page);
});

/** Fingers at places of the page. A finger that is left out has been lifted. */
const fingers = (type, ...places) => session.send('Input.dispatchTouchEvent', { type, touchPoints: places.map(([x, y], id) => ({ x, y, id })) });
/** Moves fingers from some places to others, in steps. */
async function slide(from, to, steps = 6) {
  for (let step = 1; step <= steps; step += 1) await fingers('touchMove', ...from.map(([x, y], i) => [x + ((to[i][0] - x) * step) / steps, y + ((to[i][1] - y) * step) / steps]));
}
const spread = (places) => Math.hypot(places[0].x - places[2].x, places[0].y - places[2].y);

test('one finger drags a point', async () => {
  await studio.open('tent');
  const before = await request(page);
  const [seen] = await points(page);
  const start = await onStage(page, seen);
  await fingers('touchStart', start);
  await slide([start], [[start[0] + 30, start[1] - 20]]);
  await fingers('touchEnd');
  await solved(page);
  const after = await request(page);
  assert.notDeepEqual(after.boundaries[0][0], before.boundaries[0][0]);
  assert.deepEqual(after.boundaries[0].slice(1), before.boundaries[0].slice(1));
});

test.quick('two fingers zoom the view, also if the first of them took hold of a point and moved it', async () => {
  await studio.open('tent');
  const before = await request(page);
  const seen = await points(page);
  const start = await onStage(page, seen[0]);
  await fingers('touchStart', start);
  const moved = [start[0] + 14, start[1] - 8];
  await slide([start], [moved]);
  assert.notDeepEqual(await request(page), before, 'the first finger drags the point');
  const second = [moved[0] + 60, moved[1] - 60];
  await fingers('touchStart', moved, second);
  assert.deepEqual(await request(page), before, 'the second finger gives the point back');
  await slide([moved, second], [moved, [second[0] + 60, second[1] - 60]]);
  await fingers('touchEnd');
  await atRest(page);
  assert.deepEqual(await request(page), before, 'no point was moved');
  assert.ok(spread(await points(page)) > 1.6 * spread(seen), `the view was zoomed: ${spread(seen)} px, then ${spread(await points(page))} px`);
  assert.equal(await page.isDisabled('#undo'), true, 'there is nothing to undo');
  await solved(page);
});

test('two fingers move the view while a line is drawn, and add no point', async () => {
  await studio.open('tent');
  await page.tap('#draw');
  const seen = await points(page);
  const centre = await onStage(page, { x: 195, y: 250 });
  const second = [centre[0] + 40, centre[1]];
  await fingers('touchStart', centre);
  await fingers('touchStart', centre, second);
  await slide([centre, second], [[centre[0], centre[1] + 50], [second[0], second[1] + 50]]);
  await fingers('touchEnd');
  await atRest(page);
  assert.deepEqual(await page.evaluate(() => window.studio.draft()), []);
  const now = await points(page);
  assert.ok(Math.abs(now[0].y - seen[0].y) > 20, 'the view was moved');
  // Two fingers that only touch the stage add no point either.
  await fingers('touchStart', centre);
  await fingers('touchStart', centre, second);
  await fingers('touchEnd');
  assert.deepEqual(await page.evaluate(() => window.studio.draft()), []);
  await fingers('touchStart', centre);
  await fingers('touchEnd');
  assert.equal((await page.evaluate(() => window.studio.draft())).length, 1, 'one finger does');
});

test('two fingers zoom the flat pattern', async () => {
  await studio.open('wavy-strip');
  await page.tap('[data-mode="flat"]');
  await page.waitForFunction(() => document.querySelector('#flat-image').offsetWidth > 0);
  const width = () => page.locator('#flat-image').evaluate((image) => image.offsetWidth);
  const before = await width();
  const [a, b] = [[150, 300], [250, 300]];
  await fingers('touchStart', a);
  await fingers('touchStart', a, b);
  await slide([a, b], [[100, 300], [300, 300]]);
  await fingers('touchEnd');
  assert.ok(Math.abs((await width()) / before - 2) < 0.1, `${before} px, then ${await width()} px`);
});

test('the hints speak of fingers, and the stage is tall and keeps its height', async () => {
  await studio.open('tent');
  const hint = await page.textContent('#hint');
  assert.match(hint, /finger/);
  assert.doesNotMatch(hint, /click|wheel|right-drag/i);
  const height = (selector) => page.locator(selector).evaluate((box) => box.getBoundingClientRect().height);
  const stage = await height('#stage');
  assert.ok(stage > 0.55 * 844, `the stage is ${stage} px high`);
  // The dock is as high as what it shows.
  assert.ok(await height('#dock') < await height('#hint') + 24, `the dock is ${await height('#dock')} px high`);
  await page.tap('#view', { position: (await points(page))[0] });
  assert.equal(await page.isVisible('#point'), true);
  assert.equal(await height('#stage'), stage, 'a selection leaves the stage as it was');
  await showPanel(page, 'setup');
  await page.tap('#draw');
  assert.match(await page.textContent('#drawing-hint'), /^Tap on the ground/);
  assert.equal(await height('#stage'), stage);
});
