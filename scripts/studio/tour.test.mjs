// The tour of five tasks: open a survey file, lift a corner, hang a sail on two masts, read the anchors, compare two
// objectives. It is made by pointer and by keyboard alone, in windows of three widths.

import assert from 'node:assert/strict';
import { atRest, drag, onStage, points, request, solved, test, useStudio } from './harness.mjs';

const studio = useStudio();
/** A square plot in survey coordinates, in metres. */
const SURVEY = 'x;y;z\n2683120.4;1247030.2;408.5\n2683132.4;1247030.2;408.5\n2683132.4;1247042.2;411\n2683120.4;1247042.2;408.5\n';
const MOST_TABS = 90;
const job = async (page) => (await fetch(`${studio.url}/v1/jobs/${await page.evaluate(() => window.studio.shown().job)}`)).json();
const kept = (page) => page.waitForFunction(() => !window.studio.shown().job.startsWith('page-'));
const visible = async (page, selector) => page.locator(selector).first().isVisible();

/** Steps with Tab until a control has the focus. */
async function tabTo(page, selector) {
  for (let presses = 0; presses < MOST_TABS; presses += 1) {
    if (await page.evaluate((wanted) => document.activeElement.matches(wanted), selector)) return;
    await page.keyboard.press('Tab');
  }
  assert.fail(`${selector} is not reached by ${MOST_TABS} presses of Tab`);
}
/** Steps on the stage to a point of the first line. */
async function stepTo(page, point) {
  await tabTo(page, '#view');
  for (let presses = 0; presses < 40; presses += 1) {
    await page.keyboard.press(']');
    const [chosen] = await page.evaluate(() => window.studio.selection());
    if (chosen.line === 0 && chosen.point === point) return;
  }
  assert.fail(`point ${point} is not reached`);
}

const WAYS = {
  pointer: {
    press: (page, selector) => page.locator(selector).first().click(),
    lift: async (page, point) => {
      await page.mouse.click(...await onStage(page, (await points(page))[point]));
      await atRest(page);
      const { x, y } = (await points(page))[point];
      await drag(page, { x, y: y - 42 }, { x, y: y - 72 });
    },
    take: async (page, point) => page.mouse.click(...await onStage(page, (await points(page))[point])),
    kind: (page, kind) => page.locator(`#kinds label:has([value="${kind}"])`).click(),
  },
  keyboard: {
    press: async (page, selector) => {
      await tabTo(page, selector);
      await page.keyboard.press('Enter');
    },
    lift: async (page, point) => {
      await stepTo(page, point);
      await page.keyboard.press('PageUp');
    },
    take: async (page, point) => {
      await stepTo(page, point);
      await page.keyboard.press('Enter');
    },
    // The arrow keys choose among the kinds.
    kind: async (page, kind) => {
      await tabTo(page, '#kinds input');
      for (let presses = 0; presses < 5 && await page.evaluate(() => document.activeElement.value) !== kind; presses += 1) await page.keyboard.press('ArrowRight');
    },
  },
};

for (const [width, height] of [[1440, 900], [1280, 720], [390, 844]]) {
  for (const [way, { press, lift, take, kind }] of Object.entries(WAYS)) {
    (width === 1280 && way === 'pointer' ? test.quick : test)(`the tour of five tasks by ${way}, ${width} pixels wide`, async () => {
      const { page } = studio;
      await page.setViewportSize({ width, height });
      await studio.open('tent');
      await page.waitForFunction(() => document.querySelector('#kinds input') !== null);

      // A survey file.
      const [chooser] = await Promise.all([page.waitForEvent('filechooser'), press(page, '#open-file')]);
      await chooser.setFiles({ name: 'plot.csv', mimeType: 'text/csv', buffer: Buffer.from(SURVEY) });
      await page.locator('#card').waitFor();
      await solved(page);
      await atRest(page);
      assert.equal(await page.textContent('#card .size'), '12 by 12 m, 2.5 m high');
      const stage = await page.locator('#view').boundingBox();
      assert.ok((await points(page)).every(({ x, y }) => x > 0 && y > 0 && x < stage.width && y < stage.height), 'the plot is seen');

      // A corner is lifted.
      const before = (await request(page)).boundaries[0];
      await lift(page, 0);
      await solved(page);
      const after = (await request(page)).boundaries[0];
      assert.ok(after[0][2] > before[0][2], `${before[0]} was lifted to ${after[0]}`);
      assert.deepEqual([after[0][0], after[0][1]], [before[0][0], before[0][1]], 'straight up');

      // A sail on two masts.
      await kind(page, 'tensile_structure');
      await page.waitForFunction(() => window.studio.kind() === 'tensile_structure' && window.studio.request().boundaries?.length === 1);
      await solved(page);
      await atRest(page);
      await press(page, '#cabling');
      await press(page, '#rigs [data-rig="mast"]');
      for (const corner of [1, 3]) {
        await take(page, corner);
        await page.waitForFunction((n) => window.studio.request().masts?.length === n, corner === 1 ? 1 : 2);
        await solved(page);
        await atRest(page);
      }
      await page.keyboard.press('Escape');
      await kept(page);
      const { statistics } = await job(page);
      assert.ok(statistics.masts.length === 2 && statistics.masts.every(({ force }) => force > 0), JSON.stringify(statistics.masts));

      // The anchors are read: as a table, and at their arrows.
      if (await visible(page, '#tabs')) await press(page, '#tabs [data-panel="results"]');
      const rows = await page.locator('#reactions tbody tr').evaluateAll((all) => all.map((row) => [row.cells[0].textContent, row.cells[4].textContent]));
      assert.deepEqual(rows.map(([, size]) => size), statistics.reactions.map(({ force }) => String(Number(Math.hypot(...force).toPrecision(3)))));
      assert.deepEqual(rows.map(([name]) => name).filter((name) => !name.startsWith('Boundary')).sort(), ['Mast 1, foot', 'Mast 2, foot', ...[1, 2, 3, 4].map((n) => `Stay ${n}, anchor`)]);
      assert.ok(await visible(page, '#reactions'));
      await press(page, '#layers button:nth-of-type(4)');
      assert.ok(await page.locator('.tag').count() >= 4);

      // Two objectives are compared.
      if (await visible(page, '#tabs')) await press(page, '#tabs [data-panel="setup"]');
      await kind(page, 'ruled_surface');
      await page.waitForFunction(() => window.studio.kind() === 'ruled_surface');
      await solved(page);
      await press(page, '[data-mode="compare"]');
      await page.waitForFunction(() => document.querySelectorAll('.tile dl').length >= 5);
      const areas = await page.locator('.tile').evaluateAll((tiles) => Object.fromEntries(tiles.map((tile) => [tile.dataset.objective, Number(tile.querySelector('dd').textContent.split(' ')[0])])));
      assert.ok(areas.minimal_area < areas.minimal_bending_energy, JSON.stringify(areas));
      await press(page, '.tile[data-objective="minimal_bending_energy"] button');
      await solved(page);
      assert.equal((await request(page)).objective, 'minimal_bending_energy');
      assert.equal(await visible(page, '#problem'), false);
    });
  }
}
