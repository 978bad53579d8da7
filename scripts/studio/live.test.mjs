// Live work in the page: the solvers in a worker, with and without the service.

import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { brotliCompressSync } from 'node:zlib';
import { drag, points, request, showPanel, solved, test, useStudio } from './harness.mjs';

const studio = useStudio();
/** Most bytes of script that are loaded before the first film is shown, as Brotli has them. */
const MOST_SCRIPT = 180_000;

const ready = (page) => page.waitForFunction(() => window.studio.solvesHere());
const isOfPage = (page) => page.evaluate(() => window.studio.shown().job.startsWith('page-'));
const move = async (page, by = { x: 24, y: 8 }) => {
  const [, , corner] = await points(page);
  await drag(page, corner, { x: corner.x + by.x, y: corner.y + by.y });
};

test('before the first film the script is small, and the rest comes after it', async () => {
  const { page } = studio;
  const scripts = [];
  page.on('response', (response) => {
    if (response.url().endsWith('.js')) scripts.push(response);
  });
  await page.goto(`${studio.url}/`);
  await solved(page);
  const names = () => scripts.map((each) => each.url().split('/').at(-1)).sort();
  await page.waitForFunction(() => document.querySelector('#options').childElementCount > 0);
  assert.deepEqual(names().filter((name) => name !== 'worker.js'), ['chunk.js', 'later.js', 'studio.js']);
  let bytes = 0;
  for (const response of scripts.filter((each) => /(chunk|studio)\.js$/.test(each.url()))) bytes += brotliCompressSync(await response.body()).length;
  assert.ok(bytes <= MOST_SCRIPT, `${bytes} bytes of script before the first film`);
});

test.quick('a drag is solved in the page without a connection, and the service keeps its result afterwards', async () => {
  const { page, context } = studio;
  await studio.open('tent');
  await ready(page);
  await context.setOffline(true);
  const before = await request(page);
  await move(page);
  await solved(page);
  assert.notDeepEqual(await request(page), before);
  assert.equal(await isOfPage(page), true);
  await page.locator('#unkept').waitFor();
  assert.equal(await page.isVisible('#problem'), false, 'a lost connection is no problem');
  await context.setOffline(false);
  await page.waitForFunction(() => !window.studio.shown().job.startsWith('page-'));
  assert.equal(await page.isVisible('#unkept'), false);
  // The file is the page's own, and the job that of the service.
  await showPanel(page, 'results');
  const [download] = await Promise.all([page.waitForEvent('download'), page.click('#downloads button:text-is("OBJ")')]);
  const own = await readFile(await download.path(), 'utf8');
  const job = await page.evaluate(() => window.studio.shown().job);
  const kept = await (await fetch(`${studio.url}/v1/jobs/${job}/mesh?format=obj`)).text();
  const vertices = (text) => text.split('\n').filter((line) => /^[vf] /.test(line));
  assert.deepEqual(vertices(own), vertices(kept), 'the released film has the bits of the service');
});

test('Solve without a connection is solved in the page, with a quiet sign', async () => {
  const { page, context } = studio;
  await studio.open('tent');
  await ready(page);
  await page.uncheck('#live');
  await context.setOffline(true);
  await move(page);
  await page.click('#solve');
  await solved(page);
  assert.equal(await isOfPage(page), true);
  assert.equal(await page.isVisible('#unkept'), true);
  assert.equal(await page.isVisible('#problem'), false);
});

test('Solve goes to the service', async () => {
  const { page } = studio;
  await studio.open('tent');
  await ready(page);
  await page.uncheck('#live');
  await move(page);
  const [posted] = await Promise.all([page.waitForRequest((each) => each.method() === 'POST'), page.click('#solve')]);
  await solved(page);
  assert.match(posted.url(), /v1\/minimal-surfaces$/);
  assert.equal(await isOfPage(page), false);
});

test('a drag of a sail loads the second module, and follows the hand', async () => {
  const { page, context } = studio;
  const seen = [];
  page.on('request', (each) => seen.push(each.url().split('/').at(-1)));
  await studio.open('four-point-sail');
  await ready(page);
  assert.ok(seen.includes('structures.wasm') && !seen.includes('shapes.wasm'), seen.join(' '));
  await context.setOffline(true);
  const before = await request(page);
  await move(page, { x: -24, y: -8 });
  await solved(page);
  assert.notDeepEqual(await request(page), before);
  assert.equal(await isOfPage(page), true);
});

test('a sail that is dragged beyond the length of its cable is refused without a connection, and solved again once it is back', async () => {
  const { page, context } = studio;
  await studio.open('four-point-sail');
  await ready(page);
  await context.setOffline(true);
  const posted = new Set();
  page.on('request', (each) => each.method() === 'POST' && posted.add(each.postData()));
  await move(page, { x: 60, y: 20 });
  await page.locator('#problem', { hasText: 'Cable 3, value must be longer than the chord' }).waitFor();
  await page.waitForFunction(() => document.body.getAttribute('aria-busy') === 'false');
  assert.equal(await page.textContent('#status'), 'Not solved.');
  assert.equal(posted.size, 1, 'only the released point is told to the service');
  await page.keyboard.press('Control+z');
  await solved(page);
  assert.equal(await page.isVisible('#problem'), false);
  assert.equal(await isOfPage(page), true);
});

test('where the modules cannot be loaded the service follows the drag', async () => {
  const { page } = studio;
  await page.route('**/*.wasm', (route) => route.abort());
  await studio.open('tent');
  await move(page);
  await solved(page);
  assert.equal(await isOfPage(page), false);
});

test('without a connection no other kind lights up over the result, and the message goes when the service is back', async () => {
  const { page, context } = studio;
  await studio.open('tent');
  await page.waitForFunction(() => document.querySelector('#kinds input') !== null);
  const chosen = () => page.locator('#kinds input:checked').getAttribute('value');
  await context.setOffline(true);
  await page.locator('#kinds label:has([value="uniform_mesh"])').click();
  assert.equal(await chosen(), 'minimal_surface', 'at once');
  await page.locator('#problem').waitFor();
  assert.match(await page.textContent('#problem'), /cannot be reached/);
  assert.equal(await chosen(), 'minimal_surface');
  await context.setOffline(false);
  await page.locator('#problem').waitFor({ state: 'hidden' });
  assert.equal(await page.textContent('#status'), 'The server is back.');
  // A service that fails while the machine has a connection.
  await page.route('**/v1/examples/**', (route) => route.abort());
  await page.locator('#kinds label:has([value="uniform_mesh"])').click();
  await page.locator('#problem').waitFor();
  assert.equal(await chosen(), 'minimal_surface');
});
