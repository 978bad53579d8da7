// What has to stay: Solve and its error in view, the drawing in sight, a name with its drawing, and a typed key with
// its answer.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdtemp, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { apply, atRest, points, showPanel, solved, startServer, test, useStudio } from './harness.mjs';

const studio = useStudio();
/** Two of its edges cross, so no film spans it. */
const BOW = [[0, 0, 0], [4, 4, 0], [4, 0, 0], [0, 4, 0]];
const SAIL = [[0, 0, 0], [4, 0, 1], [4, 4, 0], [0, 4, 1]];

const inView = async (page, selector) => {
  const [box, { height }] = [await page.locator(selector).boundingBox(), page.viewportSize()];
  return box !== null && box.y >= 0 && box.y + Math.min(box.height, 40) <= height;
};

test.quick('Solve and the error are in view beside the longest form, and a failed film has no full shadow', async () => {
  const { page } = studio;
  for (const example of ['tent', 'latticed-roof', 'four-point-sail']) {
    await studio.open(example);
    await page.locator('#options summary').first().click();
    assert.ok(await inView(page, '#solve'), `Solve beside the options of ${example}`);
  }
  await studio.open('tent');
  await page.locator('#options summary').first().click();
  const shadow = () => page.evaluate(() => window.studio.shadow());
  const full = await shadow();
  await apply(page, { boundaries: [BOW] });
  await page.locator('#problem').waitFor();
  assert.ok(await inView(page, '#problem strong'), 'the error is in view');
  assert.equal(await page.evaluate(() => window.studio.shown()), null, 'nothing of the old film is left');
  await studio.open('tent');
  await page.route('**/v1/minimal-surfaces', (route) => route.fulfill({ status: 500, contentType: 'application/problem+json', body: '{"type":"/problems/internal","title":"The service failed"}' }));
  await page.evaluate(() => { document.querySelector('#live').checked = false; });
  await page.locator('#view').focus();
  await page.keyboard.press(']');
  await page.keyboard.press('PageUp');
  await page.click('#solve');
  await page.locator('#problem').waitFor();
  assert.ok(await shadow() < 0.5 * full, 'the old film is a ghost with a faint shadow');
});

test('a misspelt field of a file is an error, with the service and without it', async () => {
  const { page, context } = studio;
  await studio.open('tent');
  await page.waitForFunction(() => window.studio.solvesHere());
  const files = [[{ boundaries: [SAIL], resolution: { triangels: 500 } }, /triangels/], [{ kind: 'minimal_surface', boundries: [SAIL] }, /boundries|Boundries/]];
  for (const [content, sentence, offline] of files.flatMap((each) => [[...each, false], [...each, true]])) {
    await context.setOffline(offline);
    await page.setInputFiles('#file', { name: 'sail.json', mimeType: 'application/json', buffer: Buffer.from(JSON.stringify(content)) });
    await page.locator('#problem').waitFor();
    assert.match(await page.textContent('#problem'), sentence);
    assert.doesNotMatch(await page.textContent('#status'), /^Solved/);
    await page.click('#undo');
    await page.waitForFunction(() => document.querySelector('#problem').hidden);
  }
  await context.setOffline(false);
});

test('a wrong key is answered in the dialog, in the words of the page', async () => {
  const { page } = studio;
  const made = spawnSync(process.env.PLATEAU_BIN, ['key', 'new', 'tester'], { encoding: 'utf8' }).stdout;
  const [key, line] = made.trim().split('\n').map((each) => each.replace(/^.*?: */, ''));
  const folder = await mkdtemp(join(tmpdir(), 'plateau-keys-'));
  await writeFile(join(folder, 'keys'), `${line}\n`);
  const locked = await startServer({ PLATEAU_AUTH__KEYS_FILE: join(folder, 'keys') });
  studio.allowed.push(locked.url);
  try {
    await page.goto(locked.url);
    await page.locator('#settings[open]').waitFor();
    assert.match(await page.textContent('#key-fault'), /This server asks for a key/);
    await page.fill('#api-key', 'wrong');
    await page.keyboard.press('Enter');
    await page.locator('#key-fault:has-text("does not take this key")').waitFor();
    assert.equal(await page.isVisible('#settings'), true, 'the dialog stays');
    assert.equal(await page.isVisible('#problem'), false);
    await page.fill('#api-key', key);
    assert.equal(await page.isVisible('#key-fault'), false);
    await page.keyboard.press('Enter');
    await solved(page);
    assert.equal(await page.isVisible('#settings'), false);
  } finally {
    await page.goto('about:blank');
    await locked.stop();
    await rm(folder, { recursive: true });
  }
});

test('a name goes with its drawing, into files and away with it', async () => {
  const { page } = studio;
  await studio.open('tent');
  await page.setInputFiles('#file', { name: 'Süd sail.csv', mimeType: 'text/csv', buffer: Buffer.from(SAIL.join('\n')) });
  await solved(page);
  assert.equal(await page.textContent('#title'), 'Süd sail.csv');
  await showPanel(page, 'results');
  const [download] = await Promise.all([page.waitForEvent('download'), page.click('#downloads button:text-is("OBJ")')]);
  assert.equal(download.suggestedFilename(), 'süd-sail.obj');
  await apply(page, { boundaries: [[...SAIL.slice(0, 3), [0, 5, 1]]] });
  assert.equal(await page.textContent('#title'), 'Süd sail.csv', 'an edit of the text keeps the name');
  await apply(page, { boundaries: [SAIL.map(([x, y, z]) => [x + 9, y + 1, z + 2])] });
  assert.equal(await page.textContent('#title'), '', 'another drawing has not the old name');
});

test('a window that is made narrow keeps the drawing in sight, as large as there is room', async () => {
  const { page } = studio;
  await page.setViewportSize({ width: 1440, height: 900 });
  await studio.open('tent');
  await page.setInputFiles('#file', { name: 'far.csv', mimeType: 'text/csv', buffer: Buffer.from(SAIL.map(([x, y, z]) => [x + 5000, y + 70000, z]).join('\n')) });
  await solved(page);
  for (const [width, height] of [[1000, 900], [700, 900], [390, 844], [1440, 900]]) {
    await page.setViewportSize({ width, height });
    await page.waitForFunction(() => document.querySelector('#view').clientWidth * devicePixelRatio === document.querySelector('#view').width);
    await atRest(page);
    const [box, seen] = [await page.locator('#view').boundingBox(), await points(page)];
    assert.ok(seen.every(({ x, y }) => x > 20 && y > 50 && x < box.width - 20 && y < box.height - 50), `inside and clear of the bars at ${width}`);
    const spread = Math.max(...seen.map(({ x }) => x)) - Math.min(...seen.map(({ x }) => x));
    assert.ok(spread > 0.55 * Math.min(box.width, box.height), `${spread} pixels at ${width}`);
  }
});
