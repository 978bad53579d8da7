// Nothing overlaps, nothing runs off, everything can be read by everyone; and it looks as it should.

import assert from 'node:assert/strict';
import { mkdir, readFile, writeFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { fileURLToPath } from 'node:url';
import { atRest, onStage, points, showPanel, solved, test, useStudio } from './harness.mjs';

const studio = useStudio();
const axe = await readFile(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');
const SIZES = [[1280, 720], [1920, 1080], [1024, 768], [820, 1180], [820, 700], [390, 844], [844, 390]];

/** Visible controls and texts that overlap, and boxes whose content is wider than they are. */
const faultsOfLayout = () => {
  const found = [];
  const shown = (element) => element.checkVisibility({ checkOpacity: true, checkVisibilityCSS: true }) && !element.closest('.unseen, .symbols');
  const leaves = [...document.querySelectorAll('button, a, input, select, textarea, summary, label > span, p, h1, h2, th, td, output, figcaption, .figure .value, .figure .name, #gizmo, .ends span')];
  const boxes = [];
  for (const element of leaves) {
    if (!shown(element) || (element.matches('p, th, td, span, output') && element.textContent.trim() === '') || element.matches('input[type="radio"]')) continue;
    let { left, top, right, bottom } = element.getBoundingClientRect();
    // What its scrolling or clipping ancestors do not show is not there.
    for (let box = element.parentElement; box; box = box.parentElement) {
      if (getComputedStyle(box).overflow === 'visible') continue;
      const clip = box.getBoundingClientRect();
      [left, top, right, bottom] = [Math.max(left, clip.left), Math.max(top, clip.top), Math.min(right, clip.right), Math.min(bottom, clip.bottom)];
    }
    if (right - left < 2 || bottom - top < 2) continue;
    boxes.push({ element, left, top, right, bottom });
  }
  const name = (element) => `${element.tagName.toLowerCase()}${element.id && `#${element.id}`} “${element.textContent.trim().slice(0, 20)}”`;
  for (let i = 0; i < boxes.length; i += 1) {
    for (let j = i + 1; j < boxes.length; j += 1) {
      const [a, b] = [boxes[i], boxes[j]];
      if (a.element.contains(b.element) || b.element.contains(a.element)) continue;
      const width = Math.min(a.right, b.right) - Math.max(a.left, b.left), height = Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top);
      if (width > 1.5 && height > 1.5) found.push(`${name(a.element)} overlaps ${name(b.element)}`);
    }
  }
  for (const panel of document.querySelectorAll('html, main > section, #dock, #dock > *, #bar, #look, .overlay, header, dialog[open] .body')) {
    if (shown(panel) && panel.scrollWidth > panel.clientWidth + 1) found.push(`${name(panel)} is ${panel.scrollWidth} px wide in ${panel.clientWidth}`);
  }
  for (const { element, left, right, top, bottom } of boxes) {
    if (left < -1 || right > innerWidth + 1 || top < -1 || bottom > innerHeight + 1) found.push(`${name(element)} is off the screen`);
  }
  return found.slice(0, 6);
};

/**
 * Examples whose figures, options and modes take the most room: films with and without ropes, a comparison, strips with
 * one and many pieces, lattices plane and curved, structures with a table of cables. `scripts/test --long` looks at
 * every example.
 */
const REPRESENTATIVE = ['tent', 'ridge-rope', 'rings-12-best', 'wavy-strip', 'wang-tang-v', 'vault', 'floor-fewest-nodes', 'four-point-sail', 'air-hall'];

/** The faults of layout at every size, of an example that is open. */
async function faultsAtEverySize(page) {
  const faults = [];
  for (const [width, height] of SIZES) {
    await page.setViewportSize({ width, height });
    const found = await page.evaluate(async () => {
      const press = (selector) => document.querySelector(selector).click();
      const show = (panel) => { if (document.querySelector('#tabs').checkVisibility()) press(`#tabs [data-panel="${panel}"]`); };
      // The page follows the size of its window within a frame.
      await new Promise((resolve) => { requestAnimationFrame(() => requestAnimationFrame(resolve)); });
      show('results');
      document.querySelector('#view').dispatchEvent(new KeyboardEvent('keydown', { key: ']', bubbles: true }));
      const states = { 'point selected': [document.querySelector('#point').hidden ? 'no point is selected' : [], window.faultsOfLayout()].flat() };
      show('setup');
      press('#draw');
      states.drawing = [document.querySelector('#drawing').hidden ? 'no line is drawn' : [], window.faultsOfLayout()].flat();
      press('#give-up');
      return states;
    });
    for (const [state, list] of Object.entries(found)) faults.push(...list.map((fault) => `${width} × ${height}, ${state}: ${fault}`));
  }
  return faults;
}

for (const names of [REPRESENTATIVE.slice(0, 1), REPRESENTATIVE.slice(1)]) {
  const register = names.length === 1 ? test.quick : test;
  register(`at every size, drawing or with a point selected, nothing overlaps and nothing is wider than its box: ${names.join(', ')}`, async () => {
    const { page } = studio;
    await studio.open(names[0]);
    await page.evaluate(`window.faultsOfLayout = ${faultsOfLayout}`);
    const every = await (await fetch(`${studio.url}/v1/examples`)).json();
    const isLong = process.env.PLATEAU_LONG && names.length > 1;
    const faults = [];
    for (const name of isLong ? every.examples.map((each) => each.name) : names) {
      await page.evaluate((each) => window.studio.openExample(each), name);
      await solved(page);
      faults.push(...(await faultsAtEverySize(page)).map((fault) => `${name}, ${fault}`));
    }
    assert.deepEqual(faults.slice(0, 12), []);
  });
}

/** Fails if the page breaks a rule of accessibility. */
async function checkAccessibility(page, what) {
  // The page's policy keeps foreign scripts out, so the checker comes in through the debugger.
  await page.evaluate(axe);
  const { violations } = await page.evaluate(() => window.axe.run());
  assert.deepEqual(violations.map(({ id, nodes }) => [what, id, nodes.map((node) => node.html.slice(0, 140))]), []);
}

for (const theme of ['light', 'dark']) {
  const open = async (page) => {
    await studio.open('wavy-strip');
    if (theme === 'dark') await page.click('#theme');
  };

  (theme === 'light' ? test.quick : test)(`the accessibility rules are met, ${theme}, wide and narrow`, async () => {
    const { page } = studio;
    await open(page);
    for (const [width, height] of [[1440, 860], [390, 844]]) {
      await page.setViewportSize({ width, height });
      await showPanel(page, 'results');
      await checkAccessibility(page, `${theme}, ${width}, result`);
      await showPanel(page, 'setup');
      await page.locator('#view').focus();
      await page.keyboard.press(']');
      await checkAccessibility(page, `${theme}, ${width}, point selected`);
      await page.keyboard.press('Escape');
    }
  });

  test(`the accessibility rules are met, ${theme}, in every dialog and mode`, async () => {
    const { page } = studio;
    await open(page);
    // Dialogs fill a narrow window.
    await page.setViewportSize({ width: 390, height: 844 });
    for (const dialog of ['gallery', 'share', 'recent', 'settings']) {
      await page.click(`#open-${dialog}`);
      await page.locator(`#${dialog}[open]`).waitFor();
      await checkAccessibility(page, `${theme}, ${dialog}`);
      await page.click(`#${dialog} [data-close]`);
    }
    await page.setViewportSize({ width: 1440, height: 860 });
    await page.click('[data-mode="compare"]');
    await page.waitForFunction(() => document.querySelectorAll('.tile dl').length >= 5);
    await checkAccessibility(page, `${theme}, compare`);
    await page.click('[data-mode="flat"]');
    await page.locator('#pattern-profile').waitFor();
    await checkAccessibility(page, `${theme}, flat pattern`);
    await page.click('[data-mode="model"]');
    await page.evaluate(() => window.studio.openExample('four-point-sail'));
    await solved(page);
    await checkAccessibility(page, `${theme}, table of cables`);
    await page.click('#cabling');
    await checkAccessibility(page, `${theme}, placing`);
  });
}

// ---- Golden pictures ----

/**
 * One picture that holds a small one of each example: a row for each, dark on the left and light on the right. The
 * small ones are 64 by 36 pixels, because the last bits of software rendering and of fonts differ from machine to
 * machine.
 */
const GOLDEN = fileURLToPath(new URL('golden.png', import.meta.url));
const PICTURED = ['tent', 'catenoid', 'three-rings', 'tetrahedron-loops', 'wavy-strip', 'contour-stack', 'vault', 'courtyard'];
const THEMES = ['dark', 'light'];
const [WIDTH, HEIGHT] = [64, 36];
/** The pictures in full size of a test that fails or writes. */
const FULL = fileURLToPath(new URL('../../target/golden/', import.meta.url));

/**
 * Shrinks a picture. Returns its pixels and those of the golden picture at a place of the sheet, three colours each,
 * and the sheet with the shrunk picture at that place.
 */
const shrink = (page, png, sheet, place) => page.evaluate(async ([data, golden, [column, row], [width, height], cells]) => {
  const decode = async (text) => {
    const image = new Image();
    image.src = URL.createObjectURL(new Blob([Uint8Array.from(atob(text), (c) => c.charCodeAt(0))], { type: 'image/png' }));
    await image.decode();
    return image;
  };
  const canvas = (w, h) => Object.assign(document.createElement('canvas'), { width: w, height: h }).getContext('2d', { willReadFrequently: true });
  const small = canvas(width, height);
  small.imageSmoothingQuality = 'high';
  small.drawImage(await decode(data), 0, 0, width, height);
  const whole = canvas(cells[0] * width, cells[1] * height);
  if (golden) whole.drawImage(await decode(golden), 0, 0);
  const colours = (context, x, y) => [...context.getImageData(x, y, width, height).data].filter((_, i) => i % 4 !== 3);
  const then = colours(whole, column * width, row * height);
  whole.drawImage(small.canvas, column * width, row * height);
  return { now: colours(small, 0, 0), then, sheet: whole.canvas.toDataURL('image/png').split(',')[1] };
}, [png.toString('base64'), sheet?.toString('base64'), place, [WIDTH, HEIGHT], [THEMES.length, PICTURED.length]]);

for (const [row, name] of PICTURED.entries()) {
  (name === 'vault' ? test.quick : test)(`${name} looks as it should, light and dark`, async () => {
    const { page } = studio;
    await page.setViewportSize({ width: 960, height: 540 });
    // The page is dark because the browser prefers it, and then light because the button says so.
    await page.emulateMedia({ colorScheme: 'dark' });
    await studio.open(name);
    await page.evaluate(() => document.fonts.ready);
    const faults = [];
    for (const [column, theme] of THEMES.entries()) {
      if (theme === 'light') await page.click('#theme');
      await page.mouse.move(5, 535);
      await atRest(page);
      const png = await page.screenshot();
      const { now, then, sheet } = await shrink(page, png, await readFile(GOLDEN).catch(() => null), [column, row]);
      const off = now.filter((value, i) => Math.abs(value - then[i]) > 24).length / now.length;
      // PLATEAU_GOLDEN=write makes the pictures anew: look at each in target/golden before you commit them.
      const isWriting = process.env.PLATEAU_GOLDEN === 'write';
      if (isWriting) await writeFile(GOLDEN, Buffer.from(sheet, 'base64'));
      if (!isWriting && off <= 0.012) continue;
      await mkdir(FULL, { recursive: true });
      await writeFile(`${FULL}${name}-${theme}.png`, png);
      if (!isWriting) faults.push(`${theme}: ${(100 * off).toFixed(1)} % of the picture differs: target/golden/${name}-${theme}.png`);
    }
    assert.deepEqual(faults, []);
  });
}

test.quick('a phone on its side and a low window leave room for the model, and a phone upright keeps layers and the unit of the scale', async () => {
  const { page } = studio;
  await studio.open('four-point-sail');
  for (const [width, height, wide, high] of [[844, 390, 540, 260], [667, 375, 420, 240], [820, 700, 500, 500], [390, 844, 390, 480]]) {
    await page.setViewportSize({ width, height });
    await page.selectOption('#quantity', { index: 1 });
    await page.waitForFunction(() => document.querySelector('#view').clientWidth * devicePixelRatio === document.querySelector('#view').width);
    await atRest(page);
    const [view, look, bar] = await Promise.all(['#view', '#look', '#bar'].map((selector) => page.locator(selector).boundingBox()));
    assert.ok(view.width >= wide && view.height >= high, `the stage is ${view.width} × ${view.height} at ${width} × ${height}`);
    assert.ok(look.y > bar.y + bar.height, `the bars of the stage do not overlap at ${width} × ${height}`);
    const seen = await points(page);
    assert.ok(seen.every(({ x, y }) => x > 0 && x < view.width && y + view.y > bar.y && y + view.y < look.y), `the model is seen at ${width} × ${height}`);
    for (const part of ['#layers button:text-is("Reactions")', '#scale-note']) assert.equal(await page.isVisible(part), true, `${part} at ${width} × ${height}`);
    assert.match(await page.textContent('#scale-note'), /\[m\]/);
  }
});

test('a press leads to a point wherever it is drawn', async () => {
  const { page } = studio;
  for (const [width, height] of [[1280, 720], [390, 844]]) {
    await page.setViewportSize({ width, height });
    await studio.open('tent');
    const seen = await points(page);
    await page.mouse.click(...await onStage(page, seen[2]));
    assert.deepEqual(await page.evaluate(() => window.studio.selection()), [{ line: 0, point: 2 }]);
  }
});
