// The studio in a folder, from a plain file server: everything that needs no service works.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdtemp, readFile, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, beforeEach } from 'node:test';
import { fileURLToPath } from 'node:url';
import { startFolder } from './folder.mjs';
import { covered, drag, lacksSecondModule, points, request, showPanel, solved, test, useStudio } from './harness.mjs';

const studio = useStudio();
const web = fileURLToPath(new URL('../../web/', import.meta.url));
const api = new URL('../../api/', import.meta.url);
let folder;
let server;
before(async () => {
  folder = await mkdtemp(join(tmpdir(), 'plateau-static-'));
  const { status, stderr } = spawnSync('node', ['build.mjs', '--check', '--static', folder], { cwd: web, encoding: 'utf8' });
  assert.equal(status, 0, stderr);
  server = await startFolder(folder);
});
after(async () => {
  await server.stop();
  await rm(folder, { recursive: true, force: true });
});
beforeEach(() => {
  studio.allowed = [server.url];
  server.seen.length = 0;
});

const open = async (example) => {
  await studio.page.goto(`${server.url}/${example ? `?example=${example}` : ''}`);
  await solved(studio.page);
};

test.quick('the first film is solved and shown, and nothing that a file server lacks is asked for', async () => {
  const { page } = studio;
  await open();
  assert.ok(await covered(page) >= 0.15);
  await page.locator('#kinds input').first().waitFor();
  for (const [id, seen] of [['#open-recent', false], ['#open-share', true], ['#unkept', false]]) assert.equal(await page.isVisible(id), seen, id);
  assert.deepEqual(server.seen.filter((path) => path.startsWith('/v1')), []);
});

test('a film is dragged and its released point solved, and the files are written', async () => {
  const { page } = studio;
  await open('tent');
  const before = await request(page);
  const [, , corner] = await points(page);
  await drag(page, corner, { x: corner.x + 30, y: corner.y + 10 }, { steps: 20 });
  await solved(page);
  assert.notDeepEqual(await request(page), before);
  await showPanel(page, 'results');
  const [download] = await Promise.all([page.waitForEvent('download'), page.click('#downloads button:text-is("OBJ")')]);
  assert.match(await readFile(await download.path(), 'utf8'), /^v /m);
});

// A request of each kind; the last two need the second module.
const SECOND = ['four-point-sail', 'four-cables'];
for (const example of ['wavy-strip', 'courtyard', ...SECOND]) {
  test(`${example} is solved`, async (t) => {
    if (SECOND.includes(example) && lacksSecondModule(t)) return;
    const { page } = studio;
    await open(example);
    assert.equal(await page.isVisible('#problem'), false);
    assert.equal(server.seen.includes('/studio/structures.wasm'), SECOND.includes(example), 'the second module is loaded when it is needed, and not before');
  });
}

test('the objectives of a strip are compared, and its flat pattern is drawn', async () => {
  const { page } = studio;
  await open('wavy-strip');
  await page.click('[data-mode="flat"]');
  await page.waitForFunction(() => document.querySelector('#flat-image').naturalWidth > 0);
  await page.click('[data-mode="compare"]');
  await page.locator('#tiles .tile dl').first().waitFor();
});

test('a refused request names its point, and a film that does not exist says why', async () => {
  const { page } = studio;
  await open('tent');
  await page.click('#request-box summary');
  await page.fill('#request', JSON.stringify({ boundaries: [[[0, 0, 0], [8, 0, 'high'], [8, 8, 0]]] }));
  await page.click('#apply-request');
  await page.locator('#problem').waitFor();
  assert.match(await page.textContent('#problem'), /point 2/i);
});

test('the copies of the service\'s lists are what the service answers', async () => {
  for (const [name, of] of [['objectives', (each) => each.kind !== 'enlargement'], ['examples', () => true]]) {
    const served = await (await fetch(`${studio.url}/v1/${name}`)).json();
    // Only a service that was built for tests has the kind `enlargement`.
    const expected = { ...served, [name]: served[name].filter(of) };
    assert.deepEqual(JSON.parse(await readFile(new URL(`${name}.json`, api), 'utf8')), expected, `api/${name}.json: curl the service's /v1/${name}`);
  }
});
