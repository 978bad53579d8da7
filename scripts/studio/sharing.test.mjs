// A link holds request and camera; copied programs run.

import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import { createServer } from 'node:http';
import { mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { promisify } from 'node:util';
import { atRest, covered, drag, request, solved, test, useStudio, wheel } from './harness.mjs';

const studio = useStudio();
const { transformSync } = createRequire(fileURLToPath(new URL('../../web/package.json', import.meta.url)))('esbuild');

async function copied(page, form) {
  await page.click('#open-share');
  await page.click(`#share-forms button:text-is("${form}")`);
  await page.waitForFunction((each) => document.querySelector(`#share-forms [aria-pressed="true"]`).textContent === each && document.querySelector('#share-text').value !== '', form);
  const text = await page.inputValue('#share-text');
  await page.click('#share [data-close]');
  return text;
}

test.quick('a link restores the request and the camera in another browser', async () => {
  const { page } = studio;
  await studio.open('catenoid');
  await page.selectOption('#quantity', 'mean_curvature');
  await drag(page, { x: 60, y: 420 }, { x: 210, y: 370 });
  const box = await page.locator('#view').boundingBox();
  await page.mouse.move(box.x + 300, box.y + 300);
  await wheel(page, -240);
  await atRest(page);
  const corner = (await request(page)).boundaries[0].filter((_, i) => i % 30 === 0);
  const places = (of) => of.evaluate((list) => list.map((point) => window.studio.project(point)), corner);
  const before = await places(page);
  const link = await copied(page, 'Link');

  const context = await studio.browser.newContext({ viewport: { width: 1280, height: 720 }, reducedMotion: 'reduce' });
  const other = await studio.newPage(context);
  await other.goto(link);
  await solved(other);
  await atRest(other);
  assert.deepEqual(await request(other), await request(page));
  assert.equal(await other.inputValue('#quantity'), 'mean_curvature');
  const after = await places(other);
  before.forEach(({ x, y }, i) => assert.ok(Math.hypot(after[i].x - x, after[i].y - y) < 1, `${x}, ${y} is now at ${after[i].x}, ${after[i].y}`));
  await context.close();
});

test.quick('a short link names the job that the service keeps, with the camera, and says when the job is gone', async () => {
  const { page } = studio;
  await studio.open('catenoid');
  await page.selectOption('#quantity', 'mean_curvature');
  await drag(page, { x: 60, y: 420 }, { x: 210, y: 370 });
  await atRest(page);
  const corner = (await request(page)).boundaries[0].filter((_, i) => i % 30 === 0);
  const places = (of) => of.evaluate((list) => list.map((point) => window.studio.project(point)), corner);
  const before = await places(page);
  await page.click('#open-share');
  await page.waitForFunction(() => document.querySelector('#share-text').value !== '');
  const link = await page.inputValue('#share-text');
  assert.ok(link.length < 190, `${link.length} characters: ${link}`);
  await page.click('#share [data-close]');
  const job = await page.evaluate(() => window.studio.shown().job);
  const context = await studio.browser.newContext({ viewport: { width: 1280, height: 720 }, reducedMotion: 'reduce' });
  const other = await studio.newPage(context);
  await other.goto(link);
  await solved(other);
  await atRest(other);
  const [mine, theirs] = [await request(page), await request(other)];
  for (const [name, value] of Object.entries(mine)) assert.deepEqual(theirs[name] ?? 'minimal_area', value, name);
  assert.equal(await other.evaluate(() => window.studio.shown().job), job);
  assert.equal(await other.textContent('#title'), (await page.textContent('#title')).slice(0, 60));
  assert.equal(await other.inputValue('#quantity'), 'mean_curvature');
  (await places(other)).forEach(({ x, y }, i) => assert.ok(Math.hypot(before[i].x - x, before[i].y - y) < 1, `${x}, ${y} was at ${before[i].x}, ${before[i].y}`));
  await fetch(`${studio.url}/v1/jobs/${job}`, { method: 'DELETE' });
  await other.goto('about:blank');
  await other.goto(link);
  await other.locator('#toast').waitFor();
  assert.match(await other.textContent('#toast'), /no longer keeps/);
  await solved(other);
  await context.close();
  // A drawing that the service does not have yet is shared as a whole.
  await page.uncheck('#live');
  await page.locator('#view').focus();
  await page.keyboard.press(']');
  await page.keyboard.press('PageUp');
  await page.click('#open-share');
  await page.waitForFunction(() => /#s=/.test(document.querySelector('#share-text').value));
  assert.equal(await page.locator('#share-forms button:text-is("Short link")').count(), 0);
});

test('a link that is put into the address of an open studio is opened, and undo goes back', async () => {
  const { page } = studio;
  await studio.open('catenoid');
  const catenoid = await request(page);
  const link = await copied(page, 'Link');
  await studio.open('tent');
  const tent = await request(page);
  await page.evaluate((hash) => { location.hash = hash; }, new URL(link).hash);
  await page.waitForFunction((text) => JSON.stringify(window.studio.request()) === text, JSON.stringify(catenoid));
  await solved(page);
  assert.deepEqual(await request(page), catenoid);
  await page.click('#undo');
  assert.deepEqual(await request(page), tent);
});

test('a damaged link says so and opens the page all the same', async () => {
  const { page } = studio;
  await page.goto(`${studio.url}/#s=abcdefg`);
  await solved(page);
  assert.match(await page.textContent('#toast'), /damaged/);
});

test('the embedded view shows the model in a frame of another page, without the studio around it', async () => {
  const { page } = studio;
  await studio.open('tent');
  const [, source] = /src="([^"]+)"/.exec(await copied(page, 'Embed'));
  const site = createServer((_, response) => {
    response.setHeader('content-type', 'text/html');
    response.end(`<iframe src="${source}" width="700" height="400"></iframe>`);
  });
  await new Promise((resolve) => { site.listen(0, '127.0.0.1', resolve); });
  const other = `http://127.0.0.1:${site.address().port}/`;
  studio.allowed.push(other);
  try {
    await page.goto(other);
    const frame = await (await page.locator('iframe').elementHandle()).contentFrame();
    await frame.waitForFunction(() => window.studio?.shown(), null, { polling: 200 });
    assert.equal(await frame.locator('#setup').isVisible(), false);
    assert.ok(await covered(frame) > 0.05);
  } finally {
    site.close();
    site.closeAllConnections();
  }
});

const STARTERS = { curl: ['bash', 'run.sh'], Python: ['python3', 'run.py'], TypeScript: ['node', 'run.mjs'] };
for (const [form, [program, file]] of Object.entries(STARTERS)) {
  test(`the request copied as ${form} runs and saves a GLB`, async () => {
    const { page } = studio;
    await studio.open('tent');
    const text = await copied(page, form);
    const folder = await mkdtemp(join(tmpdir(), 'plateau-copied-'));
    try {
      await writeFile(join(folder, file), form === 'TypeScript' ? transformSync(text, { loader: 'ts', format: 'esm' }).code : text);
      await promisify(execFile)(program, [file], { cwd: folder, timeout: 300_000 });
      const bytes = await readFile(join(folder, 'surface.glb'));
      assert.equal(bytes.subarray(0, 4).toString('latin1'), 'glTF');
    } finally {
      await rm(folder, { recursive: true });
    }
  });
}
