// Looking: camera, shading, colours and what is hidden.

import assert from 'node:assert/strict';
import { apply, atRest, covered, drag, onStage, pixels, points, request, showPanel, solved, test, useStudio, wheel } from './harness.mjs';

const studio = useStudio();
const disc = (n, radius = 5) => Array.from({ length: n }, (_, i) => [radius * Math.cos((2 * Math.PI * i) / n), radius * Math.sin((2 * Math.PI * i) / n), 0]);

test('the point under the cursor stays there while zooming', async () => {
  const { page } = studio;
  await studio.open('tent');
  for (const index of [0, 2]) {
    const point = (await request(page)).boundaries[0][index];
    const place = () => page.evaluate((each) => window.studio.project(each), point);
    const before = await place();
    await page.mouse.move(...await onStage(page, before));
    for (let i = 0; i < 5; i += 1) await wheel(page, -120);
    await atRest(page);
    const after = await place();
    assert.ok(Math.hypot(after.x - before.x, after.y - before.y) < 5, `${JSON.stringify(before)} ${JSON.stringify(after)}`);
    for (let i = 0; i < 5; i += 1) await wheel(page, 120);
    await atRest(page);
    const back = await place();
    assert.ok(Math.hypot(back.x - before.x, back.y - before.y) < 5);
  }
});

test('wheel and right-drag work over a point', async () => {
  const { page } = studio;
  await studio.open('tent');
  const [from, second] = await points(page);
  const before = await request(page);
  await page.mouse.move(...await onStage(page, from));
  await wheel(page, -120);
  await atRest(page);
  const [grip, next] = await points(page);
  assert.ok(Math.hypot(next.x - grip.x, next.y - grip.y) > 1.05 * Math.hypot(second.x - from.x, second.y - from.y), 'zoomed');
  await drag(page, grip, { x: grip.x + 60, y: grip.y + 20 }, { button: 'right' });
  await atRest(page);
  const [moved] = await points(page);
  assert.ok(Math.abs(moved.x - grip.x - 60) < 8 && Math.abs(moved.y - grip.y - 20) < 8, `${JSON.stringify(grip)} ${JSON.stringify(moved)}`);
  assert.deepEqual(await request(page), before, 'nothing was edited');
});

test('whatever the size of the window, all points are seen', async () => {
  const { page } = studio;
  await studio.open('tent');
  // Much wider than high: it fills the width of every window.
  await apply(page, { boundaries: [[[0, 0, 0], [24, 0, 1], [24, 2, 0], [0, 2, 1]]], resolution: { triangles: 300 } });
  await solved(page);
  await page.click('[data-view="front"]');
  for (const [width, height] of [[1280, 720], [820, 1180], [390, 844], [1920, 1080], [1024, 768]]) {
    await page.setViewportSize({ width, height });
    await page.waitForFunction(([wide, high]) => {
      const { clientWidth, clientHeight } = document.querySelector('#view');
      const inside = window.studio.points().every(({ x, y }) => x >= 0 && y >= 0 && x <= clientWidth && y <= clientHeight);
      return innerWidth === wide && innerHeight === high && inside;
    }, [width, height]);
  }
});

test('the stage keeps its size when a result comes', async () => {
  const { page } = studio;
  await page.setViewportSize({ width: 820, height: 1180 });
  await page.goto(`${studio.url}/?example=tent`);
  await page.waitForFunction(() => window.studio);
  const before = await page.locator('#stage').boundingBox();
  await solved(page);
  assert.deepEqual(await page.locator('#stage').boundingBox(), before);
});

test('a flat disc is one colour, and its mean curvature reads as zero', async () => {
  const { page } = studio;
  await studio.open('tent');
  await apply(page, { boundaries: [disc(48)], resolution: { triangles: 2000 } });
  await solved(page);
  await page.selectOption('#quantity', 'mean_curvature');
  assert.match(await page.textContent('#scale-middle'), /≈ 0/);
  assert.equal((await page.textContent('#scale-low')) + (await page.textContent('#scale-high')), '');
  await page.click('#layers button:text-is("Drawing")');
  await page.click('#layers button:text-is("Lines")');
  const oneColour = async (from) => {
    const seen = await pixels(page);
    assert.ok(seen.length > 2000, `${from}: ${seen.length} pixels`);
    for (const channel of [0, 1, 2]) {
      const values = seen.map((pixel) => pixel[channel]).sort((a, b) => a - b);
      // The rim is blended with what is behind it.
      assert.ok(values[Math.floor(values.length * 0.98)] - values[Math.floor(values.length * 0.02)] <= 3, `${from}, channel ${channel}: ${values[0]} to ${values.at(-1)}`);
    }
  };
  await oneColour('aslant');
  await page.click('[data-view="top"]');
  await atRest(page);
  await oneColour('from above');
  await page.mouse.click(...await onStage(page, await page.evaluate(() => window.studio.project([0.3, 0.2, 0]))));
  assert.match(await page.textContent('#label'), /≈ 0/);
});

test('a film that lies on the ground hides its own shadow and the grid', async () => {
  const { page } = studio;
  // At this size the surface's own offset is larger than the gap between film and ground.
  await page.setViewportSize({ width: 960, height: 540 });
  await studio.open('rings-14-best');
  const { boundaries } = await request(page);
  const ring = boundaries.reduce((low, each) => (each[0][2] < low[0][2] ? each : low));
  const centre = [0, 1, 2].map((axis) => ring.reduce((sum, point) => sum + point[axis], 0) / ring.length);
  for (const layer of ['Drawing', 'Lines']) await page.click(`#layers button:text-is("${layer}")`);
  const colours = await page.evaluate(([middle, rim]) => {
    window.studio.draw();
    const view = document.querySelector('#view');
    const copy = Object.assign(document.createElement('canvas'), { width: view.clientWidth, height: view.clientHeight }).getContext('2d', { willReadFrequently: true });
    copy.drawImage(view, 0, 0, view.clientWidth, view.clientHeight);
    // The half that is turned to the viewer: the rings above hide the other.
    const seen = rim.map((point) => window.studio.project(point.map((value, axis) => middle[axis] + 0.75 * (value - middle[axis])))).sort((a, b) => b.y - a.y);
    return seen.slice(0, Math.floor(rim.length / 3)).map(({ x, y }) => [...copy.getImageData(x, y, 1, 1).data]);
  }, [centre, ring]);
  for (const [r, g, b] of colours) assert.ok(Math.max(...[r, g, b].map((value, i) => Math.abs(value - colours[0][i]))) <= 4 && r > 170, `${colours.join(' ')}`);
});

test('plain shading is the default, and every quantity has a range and a reading', async () => {
  const { page } = studio;
  await studio.open('vault');
  assert.equal(await page.inputValue('#quantity'), 'plain');
  assert.equal(await page.isVisible('#scale'), false);
  const offered = await page.locator('#quantity option').evaluateAll((all) => all.map((each) => each.value));
  assert.ok(offered.includes('edge_length') && offered.includes('bending'), `${offered}`);
  for (const name of offered.filter((each) => each !== 'plain')) {
    await page.selectOption('#quantity', name);
    assert.match(await page.textContent('#scale-note'), /\w/);
    assert.match(await page.textContent('#scale .ends'), /\d/, name);
    const box = await page.locator('#view').boundingBox();
    await page.mouse.click(box.x + box.width * 0.5, box.y + box.height * 0.55);
    assert.match(await page.textContent('#label'), /\d/, name);
  }
});

test.quick('points behind the surface are hidden and cannot be gripped', async () => {
  const { page } = studio;
  await studio.open('tent');
  await apply(page, { boundaries: [[[0, 0, 6], [10, 0, 6], [10, 10, 6], [0, 10, 6]], [[4, 4, 0], [6, 4, 0], [6, 6, 0], [4, 6, 0]]], topology: 'best', resolution: { triangles: 800 } });
  await solved(page);
  await page.click('[data-view="top"]');
  await atRest(page);
  const seen = (await points(page)).at(-1);
  const hidden = await page.evaluate(({ x, y }) => window.studio.covers(x, y), seen);
  await page.mouse.move(...await onStage(page, seen));
  const cursor = await page.locator('#view').evaluate((view) => view.style.cursor);
  assert.equal(hidden, true, 'the upper film lies before the lower points');
  assert.notEqual(cursor, 'grab');
});

test('a picture is saved as PNG', async () => {
  const { page } = studio;
  await studio.open('tent');
  await page.click('#open-share');
  const waiting = page.waitForEvent('download');
  await page.click('#picture');
  assert.equal((await waiting).suggestedFilename(), 'a-tent-over-a-square-with-one-high-corner.png');
});

test.quick('layers are switched', async () => {
  const { page } = studio;
  await studio.open('vault');
  const before = await covered(page);
  await page.click('#layers button:text-is("Surface")');
  assert.ok(await covered(page) < 0.6 * before, 'without its surface a lattice is its members');
  await showPanel(page, 'results');
  assert.equal(await page.isVisible('#figures'), true);
});
