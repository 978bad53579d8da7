// Drives the studio in Chromium as a person would, against the real service: CHROMIUM names the browser, PLATEAU_BIN the
// server, which is started on a free port with a folder of its own; or PLATEAU_URL a server that runs already.

import assert from 'node:assert/strict';
import { spawn, spawnSync } from 'node:child_process';
import { mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { createInterface } from 'node:readline';
import { after, before, beforeEach, afterEach, test } from 'node:test';
import { chromium } from 'playwright-core';

const axe = await readFile(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');
// WebGL in software: the tests need no graphics card.
const FLAGS = [
  '--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader',
  '--disable-background-networking', '--disable-component-update', '--disable-sync',
];

let url, own, browser, page, faults, requests;

/** A server of its own on a free port: { url, stop }. */
async function start(environment = {}) {
  const folder = await mkdtemp(join(tmpdir(), 'plateau-studio-'));
  const options = { stdio: ['ignore', 'pipe', 'ignore'], env: { ...process.env, ...environment } };
  const server = spawn(process.env.PLATEAU_BIN, ['serve', '--listen', '127.0.0.1:0', '--data', folder], options);
  const stop = async () => {
    server.kill();
    await rm(folder, { recursive: true, force: true });
  };
  for await (const line of createInterface({ input: server.stdout })) {
    const [, address] = /^listening on (\S+)/.exec(line) ?? [];
    assert.ok(address, 'the server said where it listens');
    return { url: address, stop };
  }
  await stop();
  throw new Error('the server did not start');
}

before(async () => {
  own = process.env.PLATEAU_URL ? null : await start();
  url = own?.url ?? process.env.PLATEAU_URL;
  browser = await chromium.launch({ executablePath: process.env.CHROMIUM, args: FLAGS });
});

after(async () => {
  await browser?.close();
  await own?.stop();
});

beforeEach(async () => {
  faults = [];
  requests = [];
  page = await browser.newPage({ viewport: { width: 1440, height: 860 } });
  page.on('pageerror', (error) => faults.push(error.message));
  // Chromium logs every answer of 400 and above as an error; those are part of what is tested.
  page.on('console', (message) => message.type() === 'error' && !message.text().startsWith('Failed to load resource') && faults.push(message.text()));
  page.on('request', (request) => requests.push(request.url()));
});

afterEach(async () => {
  const foreign = requests.filter((address) => !address.startsWith(url) && !address.startsWith('blob:') && !address.startsWith('data:'));
  await page.close();
  assert.deepEqual(faults, [], 'no error in the page');
  assert.deepEqual(foreign, [], 'nothing is fetched from another host');
});

const open = async (example) => {
  await page.goto(`${url}/?example=${example}`);
  await page.waitForFunction(() => document.querySelector('#status').textContent === 'Ready.' && document.querySelector('#request').value !== '');
};
const solved = () => page.waitForFunction(() => document.querySelector('#status').textContent.startsWith('Solved'));
const solve = async () => {
  await page.click('#solve');
  await solved();
};
const request = async () => JSON.parse(await page.inputValue('#request'));
const figure = (name) => page.locator(`#statistics tr:has(th:text-is("${name}")) td`).first().textContent();
/** A pressed layer button shows; this one is made to. */
const layer = async (name, shown) => {
  const button = page.locator(`#layers button:text-is("${name}")`);
  if ((await button.getAttribute('aria-pressed') === 'true') !== shown) await button.click();
};
/** How much of the model's view the drawing covers, from 0 to 1. */
const covered = () => page.evaluate(() => new Promise((resolve) => {
  // The picture is only there in the frame that draws it: ask for a drawing, and look right after it.
  document.querySelector('[data-view="fit"]').click();
  requestAnimationFrame(() => {
    const copy = Object.assign(document.createElement('canvas'), { width: 800, height: 600 });
    const context = copy.getContext('2d');
    context.drawImage(document.querySelector('#view'), 0, 0, 800, 600);
    const { data } = context.getImageData(0, 0, 800, 600);
    let filled = 0;
    for (let i = 3; i < data.length; i += 4) filled += data[i] > 128 ? 1 : 0;
    resolve(filled / (data.length / 4));
  });
}));

test('every example of the server is solved and shown', async () => {
  const { examples } = await (await fetch(`${url}/v1/examples`)).json();
  assert.ok(examples.length >= 6);
  for (const { name } of examples) {
    await open(name);
    await layer('Input', false);
    assert.equal(await covered(), 0, `${name}: nothing is shown before it is solved`);
    await solve();
    const id = await page.textContent('#job-id');
    const job = await (await fetch(`${url}/v1/jobs/${id}`)).json();
    assert.equal(job.status, 'succeeded');
    assert.equal((await figure('Triangles')).replaceAll(',', ''), String(job.statistics.triangles));
    assert.ok(await covered() > 0.004, `${name}: the mesh covers a part of the view`);
    await layer('Surface', false);
    await layer('Edges', true);
    assert.ok(await covered() > 0.001, `${name}: the edges alone show too`);
  }
});

test('a dragged point is solved live, and undone', async () => {
  await open('tent');
  await page.check('#live');
  await solved();
  const [before, area] = [await request(), await figure('Area')];
  const box = await page.locator('#handles circle').nth(1).boundingBox();
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (let step = 1; step <= 10; step += 1) await page.mouse.move(x + 6 * step, y - 4 * step);
  await page.mouse.up();
  await page.waitForFunction((old) => document.querySelector('#statistics').textContent.includes('Area') && !document.querySelector('#statistics').textContent.includes(old), area);
  const moved = await request();
  assert.notDeepEqual(moved.boundaries[0][1].slice(0, 2), before.boundaries[0][1].slice(0, 2), 'it moved along the ground');
  assert.equal(moved.boundaries[0][1][2], before.boundaries[0][1][2], 'its height stayed');
  assert.deepEqual(moved.boundaries[0][0], before.boundaries[0][0], 'its neighbour stayed');
  await page.click('#undo');
  assert.deepEqual(await request(), before);
  await page.waitForFunction((old) => document.querySelector('#statistics').textContent.includes(old), area);
});

test('points are moved, inserted and deleted with the keyboard alone', async () => {
  await open('tent');
  const before = await request();
  await page.locator('#handles circle').first().focus();
  await page.keyboard.press('PageUp');
  await page.keyboard.press('ArrowRight');
  const moved = await request();
  assert.ok(moved.boundaries[0][0][2] > before.boundaries[0][0][2] && moved.boundaries[0][0][0] > before.boundaries[0][0][0]);
  await page.keyboard.press(']');
  await page.keyboard.press('Insert');
  assert.equal((await request()).boundaries[0].length, before.boundaries[0].length + 1);
  assert.match(await page.textContent('#point-name'), /boundary 1, 3 of/);
  await page.keyboard.press('Delete');
  assert.deepEqual(await request(), moved);
  await page.fill('#point input[data-axis="2"]', '1.25');
  await page.keyboard.press('Enter');
  assert.equal((await request()).boundaries[0][2][2], 1.25);
});

test('a boundary is drawn by clicks and solved', async () => {
  await open('tent');
  await page.selectOption('#examples', '(empty)');
  const box = await page.locator('#view').boundingBox();
  for (const [x, y] of [[0.3, 0.35], [0.7, 0.3], [0.7, 0.7], [0.3, 0.7], [0.3, 0.35]]) {
    await page.mouse.click(box.x + x * box.width, box.y + y * box.height);
  }
  const { boundaries } = await request();
  assert.equal(boundaries.length, 1);
  assert.equal(boundaries[0].length, 4, 'the click on the first point ends the line');
  assert.ok(boundaries[0].every(([, , z]) => z === 0), 'drawn on the ground');
  await solve();
  assert.equal(await figure('Boundary loops'), '1');
});

test('a refused request names the point, and leads to it', async () => {
  await open('tent');
  const bad = await request();
  bad.boundaries[0][2][1] = 1e300;
  await page.click('#request-box summary');
  await page.fill('#request', JSON.stringify(bad));
  await page.click('#apply-request');
  await page.click('#solve');
  const button = page.locator('#problem button').first();
  await button.waitFor();
  assert.match(await button.textContent(), /boundary 1, point 3/);
  await button.click();
  assert.match(await page.textContent('#point-name'), /boundary 1, 3 of/);
  assert.equal(await page.locator('#handles circle.faulty').count(), 1);
  await page.fill('#request', '{ "boundaries": ');
  await page.click('#apply-request');
  assert.match(await page.textContent('#request-fault'), /not JSON/);
});

test('a long job shows its progress and is cancelled', async () => {
  await open('helicoid');
  // Without a tolerance it takes minutes: the page may be slow, the job is still there when it is cancelled.
  const endless = { area_tolerance: 0, fairing_tolerance: 0, max_iterations: 5000 };
  const long = { ...await request(), solver: 'vertex_relaxation', resolution: { triangles: 100_050 }, ...endless };
  await page.click('#request-box summary');
  await page.fill('#request', JSON.stringify(long));
  await page.click('#apply-request');
  await page.click('#solve');
  await page.waitForFunction(() => /%.*iteration \d+/.test(document.querySelector('#status').textContent));
  await page.click('#cancel');
  await page.waitForFunction(() => document.querySelector('#status').textContent === 'Cancelled.');
  assert.equal(await page.locator('#solve').isDisabled(), false);
  const { jobs } = await (await fetch(`${url}/v1/jobs?limit=1`)).json();
  assert.equal(jobs[0].status, 'cancelled');
});

test('every format is downloaded, the flat pattern too', async () => {
  await open('wavy-strip');
  await solve();
  const starts = { GLB: 'glTF', GLTF: '{', OBJ: '# plateau', PLY: 'ply\n', STL: 'binary STL', SVG: '<svg ', DXF: '999\n' };
  assert.equal(await page.locator('#downloads button, #pattern-downloads button').count(), Object.keys(starts).length);
  for (const [format, start] of Object.entries(starts)) {
    const waiting = page.waitForEvent('download');
    await page.click(`#results button:text-is("${format}")`);
    const download = await waiting;
    assert.match(download.suggestedFilename(), new RegExp(`^ruled-surface-\\w+\\.${format.toLowerCase()}$`));
    const bytes = await readFile(await download.path());
    assert.equal(bytes.subarray(0, start.length).toString('latin1'), start);
  }
  await page.waitForFunction(() => document.querySelector('#pattern-image').naturalWidth > 0);
});

test('a server with keys is used with a key', { skip: process.env.PLATEAU_URL && 'needs a server of its own' }, async () => {
  const made = spawnSync(process.env.PLATEAU_BIN, ['key', 'new', 'tester'], { encoding: 'utf8' }).stdout;
  const [key, line] = made.trim().split('\n').map((each) => each.replace(/^.*?: */, ''));
  const folder = await mkdtemp(join(tmpdir(), 'plateau-keys-'));
  await writeFile(join(folder, 'keys'), `${line}\n`);
  const locked = await start({ PLATEAU_AUTH__KEYS_FILE: join(folder, 'keys') });
  const openServer = url;
  url = locked.url;
  try {
    await page.goto(url);
    await page.locator('#problem:has-text("key")').waitFor();
    await page.fill('#api-key', key);
    await page.keyboard.press('Enter');
    await page.waitForFunction(() => document.querySelector('#status').textContent === 'Ready.');
    await solve();
    const waiting = page.waitForEvent('download');
    await page.click('#downloads button:text-is("OBJ")');
    assert.ok(await (await waiting).path());
    await page.reload();
    await page.waitForFunction(() => document.querySelector('#status').textContent === 'Ready.');
  } finally {
    await page.goto('about:blank');
    await locked.stop();
    await rm(folder, { recursive: true });
    requests = requests.filter((address) => !address.startsWith(locked.url));
    url = openServer;
  }
});

test('each kind keeps its own draft', async () => {
  await open('tent');
  await page.locator('#handles circle').first().focus();
  await page.keyboard.press('PageUp');
  const draft = await request();
  await page.check('#kinds input[value="ruled_surface"]', { force: true });
  await page.waitForFunction(() => 'directrices' in JSON.parse(document.querySelector('#request').value));
  await page.check('#kinds input[value="minimal_surface"]', { force: true });
  await page.waitForFunction(() => 'boundaries' in JSON.parse(document.querySelector('#request').value));
  assert.deepEqual(await request(), draft);
});

test('a saved request opens again, as the kind that it is', async () => {
  await open('wavy-strip');
  const before = await request();
  await page.click('#request-box summary');
  const waiting = page.waitForEvent('download');
  await page.click('#save-request');
  const file = await (await waiting).path();
  await open('tent');
  await page.setInputFiles('#request-file', file);
  await page.waitForFunction(() => 'directrices' in JSON.parse(document.querySelector('#request').value));
  assert.deepEqual(await request(), before);
  assert.equal(await page.isChecked('#kinds input[value="ruled_surface"]'), true);
  await solve();
});

test('survey coordinates keep their digits', async () => {
  await open('tent');
  const far = await request();
  const [x, y] = [3_500_123.456, 5_700_987.125];
  far.boundaries = far.boundaries.map((line) => line.map((point) => [point[0] + x, point[1] + y, point[2]]));
  await page.click('#request-box summary');
  await page.fill('#request', JSON.stringify(far));
  await page.click('#apply-request');
  await solve();
  assert.ok(await covered() > 0.02);
  const box = await page.locator('#handles circle').nth(1).boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + 40, box.y - 30, { steps: 5 });
  await page.mouse.up();
  const moved = (await request()).boundaries[0][1];
  assert.ok(Math.hypot(moved[0] - far.boundaries[0][1][0], moved[1] - far.boundaries[0][1][1]) < 20, `${moved}`);
});

test('the page meets the accessibility rules, light and dark, wide and narrow', async () => {
  await open('wavy-strip');
  await solve();
  await page.locator('#handles circle').first().focus();
  for (const size of [{ width: 1440, height: 860 }, { width: 480, height: 900 }]) {
    await page.setViewportSize(size);
    for (let theme = 0; theme < 2; theme += 1) {
      await page.click('#theme');
      // The page's policy keeps foreign scripts out, so the checker comes in through the debugger.
      await page.evaluate(axe);
      const { violations } = await page.evaluate(() => window.axe.run());
      assert.deepEqual(violations.map(({ id, nodes }) => [id, nodes.map((node) => node.html.slice(0, 120))]), []);
    }
    const overflow = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
    assert.ok(overflow <= 0, `nothing runs off the side at ${size.width} px`);
  }
});
