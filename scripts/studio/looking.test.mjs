// Looking at a result: parallel views, colours in which the largest force is seen best, lines that say one thing
// each, and panels that cut nothing off and hide nothing of the model.

import assert from 'node:assert/strict';
import { apply, atRest, drag, onStage, points, request, showPanel, solved, test, useStudio } from './harness.mjs';

const studio = useStudio();
/** Pixels from which on a dark patch of a surface is a side of it, and no dot. */
const LARGEST_DOT = 60;

/** How far apart two places of equal plan are seen, 3 m one above the other. */
const parallax = (page) => page.evaluate(() => {
  const [a, b] = [[1, 1, 0], [1, 1, 3]].map((place) => window.studio.project(place));
  return Math.hypot(a.x - b.x, a.y - b.y);
});
const luminance = ([r, g, b]) => [r, g, b].map((value) => value / 255).map((c) => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4)).reduce((sum, c, i) => sum + c * [0.2126, 0.7152, 0.0722][i], 0);
const contrast = (a, b) => {
  const [low, high] = [luminance(a), luminance(b)].sort((x, y) => x - y);
  return (high + 0.05) / (low + 0.05);
};
/** Pixels of the stage of nearly one colour. */
const count = (page, colour) => page.evaluate(([r, g, b]) => {
  window.studio.draw();
  const view = document.querySelector('#view');
  const copy = Object.assign(document.createElement('canvas'), { width: view.width, height: view.height });
  const context = copy.getContext('2d', { willReadFrequently: true });
  context.drawImage(view, 0, 0);
  const { data } = context.getImageData(0, 0, view.width, view.height);
  let found = 0;
  for (let i = 0; i < data.length; i += 4) if (data[i + 3] > 250 && Math.abs(data[i] - r) + Math.abs(data[i + 1] - g) + Math.abs(data[i + 2] - b) < 24) found += 1;
  return found;
}, colour);

test.quick('Top, Front and Side are parallel projections, until the view is turned', async () => {
  const { page } = studio;
  await studio.open('tent');
  assert.ok(await parallax(page) > 20);
  await page.click('[data-view="top"]');
  await atRest(page);
  assert.ok(await parallax(page) < 1, 'points of equal plan lie on one pixel');
  await page.click('[data-view="front"]');
  await atRest(page);
  const seen = await points(page);
  const width = Math.max(...seen.map(({ x }) => x)) - Math.min(...seen.map(({ x }) => x));
  const [low, high] = await page.evaluate(() => [[0, 0, 1], [0, 8, 1]].map((place) => window.studio.project(place)));
  assert.ok(Math.abs(low.x - high.x) < 1 && Math.abs(low.y - high.y) < 1, 'depth is not seen');
  await drag(page, { x: 40, y: 400 }, { x: 140, y: 340 });
  await atRest(page);
  assert.equal(await page.evaluate(() => window.studio.isParallel()), false);
  const extent = async () => {
    const xs = (await points(page)).map(({ x }) => x);
    return [Math.min(...xs), Math.max(...xs)];
  };
  const [left, right] = await extent();
  assert.ok(right - left > 0.5 * width && right - left < 2 * width, `as large as before, ${right - left} of ${width} pixels`);
  assert.ok((left + right) / 2 > 300 && (left + right) / 2 < 660, 'in the middle of the stage');
  // The next visit shows as much from the same side, in perspective.
  await page.click('[data-view="front"]');
  await atRest(page);
  await page.goto(`${studio.url}/`);
  await solved(page);
  const [from, to] = await extent();
  assert.ok(Math.abs((to - from) / width - 1) < 0.35, `${to - from} of ${width} pixels`);
});

test('a lift in a parallel view follows the pointer', async () => {
  const { page } = studio;
  await studio.open('tent');
  await page.click('[data-view="front"]');
  await atRest(page);
  const seen = await points(page);
  // The upper corner on the left, whose arrow lies beside no other control.
  const top = seen.findIndex(({ x, y }) => x < 400 && y < 250);
  await page.mouse.click(...await onStage(page, seen[top]));
  const [{ point }] = await page.evaluate(() => window.studio.selection());
  const grip = (await points(page))[point];
  await drag(page, { x: grip.x, y: grip.y - 42 }, { x: grip.x, y: grip.y - 82 });
  await solved(page);
  const after = (await points(page))[point];
  assert.ok(Math.abs(grip.y - after.y - 40) < 3, `${grip.y - after.y} pixels`);
});

test('the largest force is the line that is seen best, before a bright ground and a dark one', async () => {
  const { page } = studio;
  await studio.open('four-point-sail');
  const ends = () => page.evaluate(() => [...document.querySelector('#scale-bar').style.background.matchAll(/rgb\((\d+),? (\d+),? (\d+)\)/g)].map(([, ...rgb]) => rgb.map(Number)));
  for (const [grounds, theme] of [[[[242, 238, 230], [238, 240, 238]], 'light'], [[[26, 32, 35]], 'dark']]) {
    if (theme === 'dark') await page.click('#theme');
    const colours = await ends();
    for (const ground of grounds) {
      const [low, high] = [contrast(colours[0], ground), contrast(colours.at(-1), ground)];
      assert.ok(high > 4.5 && high > low, `${theme}: ${high.toFixed(2)} for the largest force, ${low.toFixed(2)} for the smallest`);
    }
  }
});

test('cables are drawn as the curves that they are, and where they were given as thin dashes', async () => {
  const { page } = studio;
  await studio.open('four-point-sail');
  const orange = await count(page, [180, 86, 31]), teal = await count(page, [10, 108, 126]);
  assert.ok(orange > 50, 'the dashes are seen');
  assert.ok(orange < 1500, `${orange} pixels: thin dashes`);
  assert.ok(teal < 600, `${teal} pixels of the boundary's colour: the rims of the points`);
});

test('an edge that is held is drawn once', async () => {
  const { page } = studio;
  await studio.open('tent');
  await apply(page, { kind: 'tensile_structure', boundaries: [[[0, 0, 0], [10, 0, 3], [10, 10, 0], [0, 10, 3]]], film: { tension: 1 }, resolution: { triangles: 300 } });
  await solved(page);
  await atRest(page);
  assert.equal(await count(page, [180, 86, 31]), 0, 'no other colour shines through the line of the boundary');
  assert.ok(await count(page, [10, 108, 126]) > 800, 'the boundary is seen');
});

/** The stage without the lines: its red values, row by row, and where the surface is. */
const shades = (page) => page.evaluate(() => {
  for (const name of ['Lines', 'Drawing']) [...document.querySelectorAll('#layers button')].find((each) => each.textContent === name && each.getAttribute('aria-pressed') === 'true')?.click();
  window.studio.draw();
  const view = document.querySelector('#view');
  const { width, height } = view;
  const context = Object.assign(document.createElement('canvas'), { width, height }).getContext('2d', { willReadFrequently: true });
  context.drawImage(view, 0, 0);
  const { data } = context.getImageData(0, 0, width, height);
  const each = (channel) => Array.from({ length: width * height }, (_, i) => data[4 * i + channel]);
  return { width, height, reds: each(0), solid: each(3).map((alpha) => alpha > 250) };
});

test('the silhouette of a smooth surface has no dark dots', async () => {
  const { page } = studio;
  for (const example of ['air-hall', 'conic-tent', 'catenoid']) {
    await studio.open(example);
    await page.selectOption('#quantity', 'plain');
    await atRest(page);
    const { width, height, reds, solid } = await shades(page);
    const around = (i) => [-1, 1, -width, width, -width - 1, -width + 1, width - 1, width + 1].map((step) => i + step);
    // Patches of a few pixels that are much darker than the surface around them, with neighbours that are no surface. A
    // side of the surface that lies in the shade is a larger patch.
    let dots = 0, edge = 0;
    const seen = new Set();
    for (let i = width + 1; i < width * (height - 1) - 1; i += 1) {
      const beside = around(i).filter((each) => solid[each]);
      if (!solid[i] || beside.length > 7 || beside.length < 1) continue;
      edge += 1;
      if (seen.has(i) || reds[i] >= Math.max(...beside.map((each) => reds[each])) - 90) continue;
      const patch = new Set([i]);
      for (const pixel of patch) {
        for (const next of around(pixel)) if (patch.size < LARGEST_DOT && solid[next] && reds[next] < reds[i] + 40) patch.add(next);
      }
      for (const pixel of patch) seen.add(pixel);
      if (patch.size < LARGEST_DOT) dots += 1;
    }
    assert.ok(edge > 400, `${example}: the silhouette is seen`);
    assert.ok(dots <= 4, `${example}: ${dots} dark dots along ${edge} pixels`);
  }
});

test('a smooth film looks the same whichever way round its boundary is drawn, without facets', async () => {
  const { page } = studio;
  await studio.open('catenoid');
  await atRest(page);
  const there = await shades(page);
  const { boundaries, ...rest } = await request(page);
  await apply(page, { ...rest, boundaries: boundaries.map((boundary) => boundary.toReversed()) });
  await solved(page);
  await atRest(page);
  const back = await shades(page);
  const both = there.reds.flatMap((red, i) => (there.solid[i] && back.solid[i] ? [Math.abs(red - back.reds[i])] : []));
  assert.ok(both.length > 50_000, 'the film is seen');
  const share = both.filter((difference) => difference > 40).length / both.length;
  assert.ok(share < 0.004, `${(100 * share).toFixed(2)} % of the film is lit from its other side`);
  // Neighbouring pixels of a smooth film differ by little, except where one part of it lies before another.
  const steps = there.reds.filter((red, i) => there.solid[i] && there.solid[i + 1] && Math.abs(red - there.reds[i + 1]) > 3).length / both.length;
  assert.ok(steps < 0.015, `${(100 * steps).toFixed(2)} % of the film has steps`);
});

test('no choice is cut off, and the legend leaves the model free', async () => {
  const { page } = studio;
  for (const [width, height] of [[1440, 900], [1280, 720], [390, 844]]) {
    await page.setViewportSize({ width, height });
    for (const example of ['four-point-sail', 'tent']) {
      await studio.open(example);
      await showPanel(page, 'setup');
      await page.selectOption('#quantity', { index: 1 });
      await atRest(page);
      const cut = await page.locator('select:visible').evaluateAll((selects) => selects.filter((select) => {
        const context = document.createElement('canvas').getContext('2d');
        const style = getComputedStyle(select);
        context.font = style.font;
        // The arrow takes 18 pixels.
        return context.measureText(select.selectedOptions[0]?.text ?? '').width > select.clientWidth - parseFloat(style.paddingLeft) - 18;
      }).map((select) => `${select.id || select.name} “${select.selectedOptions[0].text}”`));
      assert.deepEqual(cut, [], `${example} at ${width}`);
      const [look, view] = [await page.locator('#look').boundingBox(), await page.locator('#view').boundingBox()];
      const under = (await points(page)).filter(({ x, y }) => x + view.x > look.x && x + view.x < look.x + look.width && y + view.y > look.y);
      assert.equal(under.length, 0, `${under.length} points of ${example} lie under the legend at ${width}`);
    }
  }
  await page.setViewportSize({ width: 1440, height: 900 });
  await studio.open('four-point-sail');
  const [bar, card] = [await page.locator('#scale-bar').boundingBox(), await page.locator('#look').boundingBox()];
  assert.ok(bar.width > card.width - 40, 'the scale fills its card');
  // The ring of this tent has reactions of many digits.
  await studio.open('conic-tent');
  const widths = await page.locator('.wide:has(#reactions)').evaluate((region) => [region.scrollWidth, region.clientWidth]);
  assert.ok(widths[0] <= widths[1], `the reactions take ${widths[0]} of ${widths[1]} pixels`);
});

test.quick('the scale bar is as long as it says, in every view', async () => {
  const { page } = studio;
  await studio.open('tent');
  for (const view of ['top', 'fit']) {
    await page.click(`[data-view="${view}"]`);
    await atRest(page);
    const [, length, unit] = /^([\d.,]+) (\w+)$/.exec(await page.textContent('#scale-line'));
    assert.equal(unit, 'm');
    const { width } = await page.locator('#scale-line').boundingBox();
    assert.ok(width > 40 && width < 132);
    if (view === 'fit') continue;
    const scale = await page.evaluate(() => window.studio.project([8, 4, 0]).x - window.studio.project([0, 4, 0]).x) / 8;
    assert.ok(Math.abs(width / (Number(length) * scale) - 1) < 0.02, `${length} m in ${width} pixels`);
  }
  for (const size of [{ width: 390, height: 844 }, { width: 960, height: 800 }, { width: 1280, height: 720 }]) {
    await page.setViewportSize(size);
    await page.selectOption('#quantity', { index: 1 });
    await atRest(page);
    const [bar, look] = [await page.locator('#scale-line').boundingBox(), await page.locator('#look').boundingBox()];
    assert.ok(bar.x > look.x + look.width || bar.y + bar.height < look.y, `clear of the legend at ${size.width}`);
  }
});

test('two clicks measure a distance, which stays when the view turns, and Escape ends it', async () => {
  const { page } = studio;
  await studio.open('tent');
  const before = JSON.stringify(await page.evaluate(() => window.studio.request()));
  await page.click('#measure');
  assert.match(await page.textContent('#hint'), /distance stands between them/);
  const seen = await points(page);
  await page.mouse.click(...await onStage(page, seen[0]));
  await page.mouse.click(...await onStage(page, seen[1]));
  assert.match(await page.textContent('#label'), /^8\.544 m \(x 8, y 0, z 3\)$/);
  assert.equal(await page.textContent('#announcement'), '8.544 m');
  await drag(page, { x: 40, y: 300 }, { x: 90, y: 300 });
  assert.equal(await page.isVisible('#label'), true);
  await page.keyboard.press('Escape');
  assert.equal(await page.isVisible('#label'), false);
  assert.equal(await page.getAttribute('#measure', 'aria-pressed'), 'false');
  assert.equal(JSON.stringify(await page.evaluate(() => window.studio.request())), before, 'nothing is changed by it');
});

test('a narrow window and a phone have the measure and the box too', async () => {
  const { page } = studio;
  for (const viewport of [{ width: 1024, height: 768 }, { width: 390, height: 844 }]) {
    await page.setViewportSize(viewport);
    await studio.open('tent');
    await page.click('#box');
    assert.equal((await page.locator('.tag:visible').all()).length, 3, `box at ${viewport.width}`);
    await page.click('#box');
    await page.click('#measure');
    const seen = await points(page);
    for (const point of seen.slice(0, 2)) await page.mouse.click(...await onStage(page, point));
    assert.match(await page.textContent('#label'), /^8\.544 m/, `measure at ${viewport.width}`);
    await page.click('#measure');
    assert.equal(await page.isVisible('#label'), false);
  }
  await page.setViewportSize({ width: 1280, height: 720 });
});

test('a box around the result says its sizes, also after a change', async () => {
  const { page } = studio;
  await studio.open('tent');
  await page.locator('#box').click();
  const sizes = async () => (await page.locator('.tag').allTextContents()).sort();
  assert.deepEqual(await sizes(), ['3 m', '8 m', '8 m']);
  await atRest(page);
  const [stage, tags] = [await page.locator('#stage').boundingBox(), await page.locator('.tag:visible').all()];
  assert.equal(tags.length, 3);
  for (const tag of tags) {
    const box = await tag.boundingBox();
    assert.ok(box.x >= stage.x && box.y >= stage.y && box.x + box.width <= stage.x + stage.width && box.y + box.height <= stage.y + stage.height);
  }
  await page.locator('#view').focus();
  await page.keyboard.press(']');
  await page.keyboard.press(']');
  await page.fill('#point [data-axis="2"]', '4');
  await page.keyboard.press('Enter');
  await solved(page);
  assert.deepEqual(await sizes(), ['4 m', '8 m', '8 m']);
  await page.locator('#box').click();
  assert.deepEqual(await sizes(), []);
});
