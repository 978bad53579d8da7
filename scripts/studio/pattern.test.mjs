// The flat pattern on the whole stage is the service's drawing. It has names, angles, sizes and a scale bar.
// Printing opens the service's PDF.

import assert from 'node:assert/strict';
import { showPanel, solved, test, useStudio } from './harness.mjs';

const studio = useStudio();
/** Waits for an answer of the pattern whose query has these values. */
const answer = (page, values) => page.waitForResponse((response) => {
  const { pathname, searchParams } = new URL(response.url());
  return pathname.endsWith('/pattern') && Object.entries(values).every(([name, value]) => searchParams.get(name) === value);
});
const job = async (page) => (await fetch(`${studio.url}/v1/jobs/${await page.evaluate(() => window.studio.shown().job)}`)).json();

async function openFlat(page, example) {
  await studio.open(example);
  const [drawing] = await Promise.all([answer(page, { format: 'svg' }), page.click('[data-mode="flat"]')]);
  await page.waitForFunction(() => document.querySelector('#flat-image').complete && document.querySelector('#flat-image').naturalWidth > 0);
  return drawing;
}

test.quick('the pattern is the service\'s drawing with names, angles, sizes and a scale bar, which can be read', async () => {
  const { page } = studio;
  const drawing = await openFlat(page, 'wavy-strip');
  const text = await drawing.text();
  const { statistics } = await job(page);
  const { width, height } = statistics.flat_pattern;
  for (const part of ['>strip 1<', `>${(1000 * width).toFixed(2)} mm<`, `>${(1000 * height).toFixed(2)} mm<`, 'class="scale_bar"', 'class="fold_mountain"', 'class="fold_valley"', `>${statistics.largest_fold_deg.toFixed(2)}<`]) {
    assert.ok(text.includes(part), part);
  }
  const said = await page.textContent('#pattern-size');
  assert.equal(said, `1 piece · ${Number(width.toPrecision(4))} × ${Number(height.toPrecision(4))} m · 137 folds, the largest of ${Number(statistics.largest_fold_deg.toPrecision(3))}°`);
  // The drawing fills the room between the bars, and its text is as large as small print.
  const [image, stage, bar] = await Promise.all(['#flat-image', '#stage', '#flat-bar'].map((selector) => page.locator(selector).boundingBox()));
  assert.ok(image.x >= stage.x && image.x + image.width <= stage.x + stage.width && image.y > stage.y && image.y + image.height <= bar.y, 'nothing of it is hidden');
  assert.ok(image.width > 0.6 * stage.width || image.height > 0.6 * (bar.y - stage.y - 60), `${image.width} × ${image.height}`);
  const wide = Number(/width="([\d.]+)mm"/.exec(text)[1]);
  const letters = (Number(new URL(drawing.url()).searchParams.get('text_height')) * image.width) / wide;
  assert.ok(letters > 5 && letters < 16, `capitals of ${letters} pixels`);
});

test.quick('Print and Ctrl P open the PDF of the service, true to scale, and the page itself is not printed', async () => {
  const { page } = studio;
  await page.addInitScript(() => {
    window.printed = 0;
    window.opened = [];
    window.print = () => { window.printed += 1; };
    window.open = (url) => { window.opened.push(url); return window; };
  });
  await openFlat(page, 'two-rails');
  for (const [press, paper] of [[() => page.click('#pattern-print'), null], [() => page.keyboard.press('Control+p'), 'a3']]) {
    if (paper) await page.selectOption('#pattern-paper', paper);
    const [pdf] = await Promise.all([answer(page, { format: 'pdf', profile: 'plain', paper }), press()]);
    assert.equal((await pdf.body()).subarray(0, 5).toString('latin1'), '%PDF-');
    await page.waitForFunction((n) => window.opened.length === n, paper ? 2 : 1);
  }
  assert.ok((await page.evaluate(() => window.opened)).every((url) => url.startsWith('blob:')));
  assert.equal(await page.evaluate(() => window.printed), 0);
  // A strip larger than a page is printed reduced, as the drawing alone.
  await page.selectOption('#pattern-paper', '');
  await page.evaluate(() => window.studio.openExample('wavy-strip'));
  await solved(page);
  await page.click('[data-mode="flat"]');
  await page.waitForFunction(() => document.querySelector('#pattern-paper').value === 'fit');
  await page.click('#pattern-print');
  assert.equal(await page.evaluate(() => window.printed), 1);
  await page.emulateMedia({ media: 'print' });
  for (const id of ['header', '#setup', '#results', '#dock', '#bar', '#flat-bar', '#view']) assert.equal(await page.locator(id).first().isVisible(), false, id);
  assert.equal(await page.isVisible('#flat-image'), true);
});

test('sheet metal is drawn with its thickness, and values that cannot be made are said beside the fields', async () => {
  const { page } = studio;
  await openFlat(page, 'two-rails');
  const [metal] = await Promise.all([answer(page, { profile: 'sheet-metal', thickness: '1', format: 'svg' }), page.selectOption('#pattern-profile', 'sheet-metal')]);
  assert.match(await metal.text(), /class="bend_(up|down)"/);
  await page.fill('#pattern-radius', '0,1');
  await page.keyboard.press('Tab');
  await page.locator('#pattern-fault').waitFor();
  assert.match(await page.textContent('#pattern-fault'), /radius: must be at least half the thickness/);
  assert.equal(await page.isVisible('#problem'), false);
  assert.equal(await page.isVisible('#flat-image'), true, 'the last drawing stays');
  await page.fill('#pattern-radius', '3');
  await Promise.all([answer(page, { radius: '3' }), page.keyboard.press('Tab')]);
  await page.locator('#pattern-fault').waitFor({ state: 'hidden' });
  const [file] = await Promise.all([page.waitForEvent('download'), page.click('#flat-bar [data-format="zip"]')]);
  assert.match(file.suggestedFilename(), /-pattern\.zip$/);
});

test('a result of the page has the page\'s pattern until the service has it too', async () => {
  const { page } = studio;
  await openFlat(page, 'two-rails');
  await page.click('[data-mode="model"]');
  // The service takes nothing over for now.
  await page.route('**/v1/ruled-surfaces', (route) => route.abort());
  await showPanel(page, 'setup');
  await page.locator('#view').focus();
  await page.keyboard.press(']');
  await page.keyboard.press('PageUp');
  await solved(page);
  assert.match(await page.evaluate(() => window.studio.shown().job), /^page-/);
  await page.click('[data-mode="flat"]');
  await page.waitForFunction(() => !document.querySelector('#flat').hidden);
  assert.equal(await page.isVisible('#pattern-profile'), false, 'no choice that only the service has');
  assert.equal(await page.isVisible('#flat-image'), true);
  await page.unroute('**/v1/ruled-surfaces');
  await page.locator('#pattern-profile').waitFor();
  assert.equal((await job(page)).status, 'succeeded');
  assert.equal(await page.isVisible('#unkept'), false);
});

test('the name of each flat piece stands on its piece, or a leader goes from it into its piece', async () => {
  const { page } = studio;
  const named = { on: 0, beside: 0 };
  for (const example of ['contour-stack', 'wang-tang-v', 'two-rails', 'wavy-strip']) {
    const text = await (await openFlat(page, example)).text();
    const pieces = await page.evaluate((source) => {
      const drawing = document.importNode(new DOMParser().parseFromString(source.replace(/<style>.*?<\/style>/s, ''), 'image/svg+xml').documentElement, true);
      document.body.append(drawing);
      const found = [...drawing.querySelectorAll('g[id^="piece-"]')].filter((piece) => piece.querySelector('path.cut')).map((piece) => {
        const title = piece.querySelector('title').textContent;
        const cut = piece.querySelector('path.cut');
        const name = [...piece.querySelectorAll('text')].find((each) => each.textContent === title);
        if (!name) return { title, named: 'no name' };
        const { x, y, width, height } = name.getBBox();
        const matrix = name.transform.baseVal.consolidate()?.matrix ?? drawing.createSVGMatrix();
        const corners = [[x, y], [x + width, y], [x, y + height], [x + width, y + height], [x + width / 2, y + height / 2]];
        // The box of a text has room for letters that reach below the line; the name has none.
        const outside = corners.filter(([cx, cy]) => !cut.isPointInFill(drawing.createSVGPoint().matrixTransform(matrix.translate(cx, y + height / 2 + (cy - y - height / 2) * 0.7))));
        if (outside.length === 0) return { title, named: 'on' };
        const corner = ([cx, cy]) => drawing.createSVGPoint().matrixTransform(matrix.translate(cx, cy));
        const [low, high] = [corner([x, y]), corner([x + width, y + height])];
        const leads = [...piece.querySelectorAll('line.mark')].some((leader) => {
          const [x1, y1, x2, y2] = ['x1', 'y1', 'x2', 'y2'].map((end) => leader[end].baseVal.value);
          const gap = Math.hypot(Math.max(low.x - x1, x1 - high.x, 0), Math.max(low.y - y1, y1 - high.y, 0));
          const end = Object.assign(drawing.createSVGPoint(), { x: x2, y: y2 });
          return gap < 2 * height && cut.isPointInFill(end);
        });
        return { title, named: outside.length === corners.length && leads ? 'beside' : 'off' };
      });
      drawing.remove();
      return found;
    }, text);
    assert.ok(pieces.length > 0, example);
    assert.deepEqual(pieces.filter(({ named }) => named !== 'on' && named !== 'beside'), [], example);
    pieces.forEach((piece) => { named[piece.named] += 1; });
    await page.click('[data-mode="model"]');
  }
  assert.ok(named.on >= 1 && named.on + named.beside >= 7, JSON.stringify(named));
});

test('the pattern has room between its bars in every window', async () => {
  const { page } = studio;
  await openFlat(page, 'wavy-strip');
  for (const [width, height, least] of [[1440, 860, 400], [820, 700, 250], [390, 844, 150], [844, 390, 90]]) {
    await page.setViewportSize({ width, height });
    await page.waitForFunction(() => {
      const [image, stage] = ['#flat-image', '#stage'].map((selector) => document.querySelector(selector).getBoundingClientRect());
      return image.left >= stage.left && image.right <= stage.right && image.bottom <= stage.bottom;
    });
    const [image, stage, bar, top] = await Promise.all(['#flat-image', '#stage', '#flat-bar', '#modes'].map((selector) => page.locator(selector).boundingBox()));
    assert.ok(bar.x >= stage.x && bar.x + bar.width <= stage.x + stage.width && bar.y + bar.height <= stage.y + stage.height, `the controls are on the stage at ${width} × ${height}`);
    assert.ok(bar.y > top.y + top.height, `the bars do not overlap at ${width} × ${height}`);
    assert.ok(image.height >= least && image.y + image.height <= bar.y + 1, `${image.height} pixels above the controls at ${width} × ${height}`);
    if (process.env.SHOT) await page.screenshot({ path: `${process.env.SHOT}${width}.png` });
  }
});
