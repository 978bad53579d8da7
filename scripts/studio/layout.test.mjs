// Nothing overlaps, nothing runs off, everything can be read by everyone; and it looks as it should.

import assert from 'node:assert/strict';
import { mkdir, readFile, writeFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { points, onStage, showPanel, solved, useStudio } from './harness.mjs';

const studio = useStudio();
const axe = await readFile(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');
const SIZES = [[1280, 720], [1920, 1080], [1024, 768], [820, 1180], [390, 844]];

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
 * Examples whose figures, options and modes take the most room: films with and without ropes, a comparison, strips with one
 * and many pieces, lattices plane and curved, structures with a table of cables. `scripts/test --long` looks at every example.
 */
const REPRESENTATIVE = ['tent', 'ridge-rope', 'rings-12-best', 'wavy-strip', 'wang-tang-v', 'vault', 'floor-fewest-nodes', 'four-point-sail', 'air-hall'];

test('at every size, drawing or with a point selected, nothing overlaps and nothing is wider than its box', async () => {
  const { page } = studio;
  await studio.open('tent');
  await page.evaluate(`window.faultsOfLayout = ${faultsOfLayout}`);
  const every = await (await fetch(`${studio.url}/v1/examples`)).json();
  const names = process.env.PLATEAU_LONG ? every.examples.map(({ name }) => name) : REPRESENTATIVE;
  const faults = [];
  for (const name of names) {
    await page.evaluate((each) => window.studio.openExample(each), name);
    await solved(page);
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
      for (const [state, list] of Object.entries(found)) faults.push(...list.map((fault) => `${name}, ${width} × ${height}, ${state}: ${fault}`));
    }
  }
  assert.deepEqual(faults.slice(0, 12), []);
});

test('the accessibility rules are met, light and dark, wide and narrow, in every dialog', async () => {
  const { page } = studio;
  await studio.open('wavy-strip');
  const check = async (what) => {
    // The page's policy keeps foreign scripts out, so the checker comes in through the debugger.
    await page.evaluate(axe);
    const { violations } = await page.evaluate(() => window.axe.run());
    assert.deepEqual(violations.map(({ id, nodes }) => [what, id, nodes.map((node) => node.html.slice(0, 140))]), []);
  };
  for (const theme of ['light', 'dark']) {
    for (const [width, height] of [[1440, 860], [390, 844]]) {
      await page.setViewportSize({ width, height });
      await showPanel(page, 'results');
      await check(`${theme}, ${width}, result`);
      await showPanel(page, 'setup');
      await page.locator('#view').focus();
      await page.keyboard.press(']');
      await check(`${theme}, ${width}, point selected`);
      await page.keyboard.press('Escape');
    }
    for (const dialog of ['gallery', 'share', 'recent', 'settings']) {
      await page.click(`#open-${dialog}`);
      await page.locator(`#${dialog}[open]`).waitFor();
      await check(`${theme}, ${dialog}`);
      await page.click(`#${dialog} [data-close]`);
    }
    await page.setViewportSize({ width: 1440, height: 860 });
    await page.click('[data-mode="compare"]');
    await page.waitForFunction(() => document.querySelectorAll('.tile dl').length >= 5);
    await check(`${theme}, compare`);
    await page.click('[data-mode="model"]');
    await page.evaluate(() => window.studio.openExample('four-point-sail'));
    await solved(page);
    await check(`${theme}, table of cables`);
    await page.evaluate(() => window.studio.openExample('wavy-strip'));
    await solved(page);
    await page.click('#theme');
  }
});

// ---- Golden pictures ----

const GOLDEN = fileURLToPath(new URL('golden/', import.meta.url));
const PICTURED = ['tent', 'catenoid', 'three-rings', 'tetrahedron-loops', 'wavy-strip', 'contour-stack', 'vault', 'courtyard'];
/** Pictures are compared this small: the last bits of software rendering and of fonts differ from machine to machine. */
const SMALL = [96, 54];

/** Mean brightness of each cell of the picture, three colours. */
const reduce = (page, png) => page.evaluate(async ([data, width, height]) => {
  const image = new Image();
  const bytes = Uint8Array.from(atob(data), (c) => c.charCodeAt(0));
  image.src = URL.createObjectURL(new Blob([bytes], { type: 'image/png' }));
  await image.decode();
  const context = Object.assign(document.createElement('canvas'), { width, height }).getContext('2d', { willReadFrequently: true });
  context.imageSmoothingQuality = 'high';
  context.drawImage(image, 0, 0, width, height);
  return [...context.getImageData(0, 0, width, height).data].filter((_, i) => i % 4 !== 3);
}, [png.toString('base64'), ...SMALL]);

test('eight examples look as they should, light and dark', async () => {
  const { page } = studio;
  await page.setViewportSize({ width: 960, height: 540 });
  await mkdir(GOLDEN, { recursive: true });
  const faults = [];
  for (const theme of ['light', 'dark']) {
    await page.emulateMedia({ colorScheme: theme });
    for (const name of PICTURED) {
      await studio.open(name);
      await page.mouse.move(5, 535);
      await page.evaluate(() => document.fonts.ready);
      const png = await page.screenshot();
      const file = `${GOLDEN}${name}-${theme}.png`;
      const golden = await readFile(file).catch(() => null);
      // PLATEAU_GOLDEN=write makes the pictures anew: look at each before you commit it.
      if (process.env.PLATEAU_GOLDEN === 'write') await writeFile(file, png);
      else if (!golden) faults.push(`${name}, ${theme}: there is no golden picture`);
      else {
        const [now, then] = [await reduce(page, png), await reduce(page, golden)];
        const off = now.filter((value, i) => Math.abs(value - then[i]) > 24).length / now.length;
        if (off > 0.012) faults.push(`${name}, ${theme}: ${(100 * off).toFixed(1)} % of the picture differs`);
      }
    }
  }
  assert.deepEqual(faults, []);
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
