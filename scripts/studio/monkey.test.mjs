// Random presses on everything that can be pressed, from a fixed seed: no error in the console, no page that stays busy, and a
// request that is what the form shows. MONKEY_SEED and MONKEY_PRESSES choose others.

import assert from 'node:assert/strict';
import { apply, request, solved, test, useStudio } from './harness.mjs';

const SEED = Number(process.env.MONKEY_SEED ?? 1);
const PRESSES = Number(process.env.MONKEY_PRESSES ?? 60);
const SIZES = [[1440, 900], [1280, 720], [1024, 768], [768, 1024], [390, 844]];
/** What leads out of the page, or opens a dialog of the browser's own. */
const LEFT_ALONE = '#open-file, #file, #copy, a, #api-key';
const REST_MS = 180_000;

const studio = useStudio();

/** Marsaglia's xorshift of 32 bits: numbers from 0 to 1. */
function random(seed) {
  let state = (seed * 2654435761) >>> 0 || 1;
  return () => {
    state ^= state << 13;
    state ^= state >>> 17;
    state ^= state << 5;
    state >>>= 0;
    return state / 2 ** 32;
  };
}

/** Marks everything that can be pressed now, and returns how much it is. */
const mark = (page) => page.evaluate((leftAlone) => {
  document.querySelectorAll('[data-monkey]').forEach((each) => each.removeAttribute('data-monkey'));
  const root = document.querySelector('dialog[open]') ?? document;
  const found = [...root.querySelectorAll('button, summary, select, input, textarea, canvas#view')].filter((each) => {
    if (each.disabled || each.matches(leftAlone)) return false;
    const { width, height } = each.getBoundingClientRect();
    return width > 0 && height > 0 && each.checkVisibility();
  });
  found.forEach((each, i) => { each.dataset.monkey = String(i); });
  return found.length;
}, LEFT_ALONE);

/** Presses the control of a number, with what a person might do to it, and says what that was. */
async function press(page, index, draw) {
  const control = page.locator(`[data-monkey="${index}"]`);
  const options = { timeout: 2000 };
  const what = await control.evaluate((each) => ({
    tag: each.tagName, type: each.type, id: each.id || each.name || each.textContent.trim().slice(0, 30), options: [...each.options ?? []].filter(({ disabled }) => !disabled).map(({ value }) => value),
  }), null, options);
  if (what.tag === 'SELECT') {
    const value = what.options[Math.floor(draw() * what.options.length)];
    await control.selectOption(value, options);
    return `${what.id} = ${value}`;
  }
  if (what.tag === 'CANVAS') {
    const { x, y, width, height } = await control.boundingBox();
    const place = () => [x + width * (0.1 + 0.8 * draw()), y + height * (0.1 + 0.8 * draw())];
    const [from, to] = [place(), place()];
    await page.mouse.move(...from);
    await page.mouse.down();
    if (draw() < 0.5) await page.mouse.move(...to, { steps: 5 });
    await page.mouse.up();
    return `the model at ${from.map(Math.round)}`;
  }
  if (what.tag === 'INPUT' && ['number', 'text'].includes(what.type)) {
    const value = ['', '0', '1', '2.5', '500', '-1', 'x'][Math.floor(draw() * (what.type === 'number' ? 6 : 7))];
    await control.fill(value, options);
    await control.press('Tab', options);
    return `${what.id} = ${JSON.stringify(value)}`;
  }
  if (what.tag === 'TEXTAREA') return `${what.id} left as it is`;
  await control.click(options);
  return what.id;
}

/**
 * Each control of the form with its value, once no control has the focus. The value is null for an entry that the page refused
 * and that has the border of a fault, because such an entry is shown but not in the request.
 */
const form = (page) => page.evaluate(() => {
  document.activeElement?.blur();
  const probe = Object.assign(document.body.appendChild(document.createElement('i')), { style: 'color: var(--fault)' });
  const fault = getComputedStyle(probe).color;
  probe.remove();
  const isMarked = (each) => each.matches(':invalid') && getComputedStyle(each).borderTopColor === fault;
  return Object.fromEntries([...document.querySelectorAll('#options [name]')]
    .map((each) => [each.name, each.type === 'checkbox' ? each.checked : isMarked(each) ? null : each.value]));
});

for (const context of [1, 2]) {
  test(`random presses, context ${context}`, async (t) => {
    const { page } = studio;
    const draw = random(100 * SEED + context);
    const told = [];
    await page.goto(`${studio.url}/`);
    await solved(page);
    await page.waitForFunction(() => document.querySelector('#options').childElementCount > 0);
    for (let count = 0; count < PRESSES; count += 1) {
      if (count % (PRESSES / SIZES.length) === 0) {
        const [width, height] = SIZES[(count / (PRESSES / SIZES.length) + context) % SIZES.length];
        await page.setViewportSize({ width, height });
        told.push(`${width} × ${height}`);
      }
      const many = await mark(page);
      // A control may go away or be covered between the look and the press, which a person would not press either.
      told.push(await press(page, Math.floor(draw() * many), draw).catch((error) => `not pressed: ${error.message.split('\n')[0].slice(0, 80)}`));
      assert.deepEqual(studio.faults, [], told.join('\n'));
    }
    const missed = told.filter((each) => each.startsWith('not pressed'));
    t.diagnostic(`${PRESSES - missed.length} of ${PRESSES} presses hit something`);
    for (let open = true; open;) {
      open = await page.evaluate(() => {
        const dialog = document.querySelector('dialog[open]');
        dialog?.close();
        return dialog !== null;
      });
    }
    await page.setViewportSize({ width: 1280, height: 720 });
    await page.waitForFunction(() => document.body.getAttribute('aria-busy') === 'false', null, { timeout: REST_MS }).catch(() => assert.fail(`the page stays busy after\n${told.join('\n')}`));
    // A draft is given up before the request is written by hand.
    for (const id of ['give-up', 'discard-request']) if (await page.isVisible(`#${id}`)) await page.click(`#${id}`);
    const [shown, now] = [await form(page), await request(page)];
    // The same request by hand makes the form anew.
    await apply(page, { kind: await page.evaluate(() => window.studio.kind()), ...now });
    await page.waitForFunction(() => document.body.getAttribute('aria-busy') === 'false', null, { timeout: REST_MS });
    // JSON has no -0.
    assert.deepEqual(await request(page), JSON.parse(JSON.stringify(now)), told.join('\n'));
    const anew = await form(page);
    const refused = Object.keys(shown).filter((name) => shown[name] === null);
    assert.deepEqual({ ...shown, ...Object.fromEntries(refused.map((name) => [name, anew[name]])) }, anew, told.join('\n'));
    assert.ok(missed.length < PRESSES / 3, told.join('\n'));
  });
}
