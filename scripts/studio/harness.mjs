// Drives the studio in Chromium as a person would, against the real service: CHROMIUM names the browser, PLATEAU_BIN the
// server, which is started on a free port with a folder of its own; or PLATEAU_URL a server that runs already.
//
// PLATEAU_DIST names a folder, such as web/dist, whose files are served in front of the server, so that a change of the studio is
// tested without building the service.
//
// `node --test scripts/studio/all.mjs` runs all files in one process, so that they share a browser and a few servers. With
// PLATEAU_QUICK=1 it runs the tests that are registered by `test.quick` only. Each file also runs alone.

import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { existsSync } from 'node:fs';
import { mkdtemp, readFile, rm } from 'node:fs/promises';
import { createServer, request as ask } from 'node:http';
import { tmpdir } from 'node:os';
import { extname, join } from 'node:path';
import { createInterface } from 'node:readline';
import { pipeline } from 'node:stream';
import { after, afterEach, before, beforeEach, test as register } from 'node:test';
import { fileURLToPath } from 'node:url';
import { chromium } from 'playwright-core';
import { Hold } from '../../clients/typescript/test/hold.mjs';
import { isSkipped } from '../skips.mjs';

// WebGL in software: the tests need no graphics card. The page around the model is painted by the processor directly, which
// takes half the time of painting it by a graphics card in software. Four samples a pixel would take half as long again.
const FLAGS = [
  '--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--disable-gpu-compositing', '--webgl-antialiasing-mode=none',
  '--disable-background-networking', '--disable-component-update', '--disable-sync',
];
/** Nothing here is measured; a machine that is busy with other tests is given time. */
const PATIENCE_MS = 120_000;

/**
 * Registers a test of the full suite: the arguments of `test` of node:test. A test that is left out is not registered, because
 * node would count it as skipped.
 */
export const test = (...options) => { if (!process.env.PLATEAU_QUICK) register(...options); };
/** Registers a test of the quick tier, which is part of the full suite too: one or two for each subject. */
test.quick = register;

/** A server of its own on a free port: { url, hold, stop, restart }. `restart` ends it and starts another on the same data. */
export async function startServer(environment = {}) {
  const folder = await mkdtemp(join(tmpdir(), 'plateau-studio-'));
  const hold = new Hold(join(folder, 'hold'));
  const options = { stdio: ['ignore', 'pipe', 'ignore'], env: { ...process.env, ...hold.environment, ...environment } };
  let server, address, front = null;
  const start = async () => {
    server = spawn(process.env.PLATEAU_BIN, ['serve', '--listen', '127.0.0.1:0', '--data', folder], options);
    for await (const line of createInterface({ input: server.stdout })) {
      [, address] = /^listening on (\S+)/.exec(line) ?? [];
      assert.ok(address, 'the server said where it listens');
      return;
    }
    throw new Error('the server did not start');
  };
  const started = {
    url: '', hold,
    restart: async () => {
      server.kill('SIGKILL');
      await once(server, 'exit');
      await start();
      started.url = front?.url ?? address;
    },
    stop: async () => {
      await front?.stop();
      server.kill();
      await rm(folder, { recursive: true, force: true, maxRetries: 5 });
    },
  };
  try {
    await start();
  } catch (error) {
    await started.stop();
    throw error;
  }
  if (process.env.PLATEAU_DIST) front = await startFront(() => address);
  started.url = front?.url ?? address;
  return started;
}

const TYPES = { '.html': 'text/html; charset=utf-8', '.js': 'text/javascript; charset=utf-8', '.css': 'text/css; charset=utf-8', '.svg': 'image/svg+xml', '.wasm': 'application/wasm' };
/** The headers with which the service sends its pages (src/http/routes/studio.rs). */
const HEADERS = {
  'cache-control': 'no-cache', 'x-content-type-options': 'nosniff', 'cross-origin-opener-policy': 'same-origin', 'cross-origin-embedder-policy': 'require-corp',
};
const POLICY = "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; img-src 'self' blob:; object-src 'none'; base-uri 'none'; form-action 'none'; frame-ancestors ";

/** Serves the studio's files, and passes everything else on to the server whose address `target` returns. */
async function startFront(target) {
  const front = createServer(async (incoming, outgoing) => {
    const [, name] = /^\/(?:studio\/([\w.-]+))?(?:\?.*)?$/.exec(incoming.url) ?? [null, null];
    if (name !== null) {
      const file = name ?? 'index.html';
      const bytes = await readFile(join(file.endsWith('.wasm') ? MODULES : process.env.PLATEAU_DIST, file)).catch(() => null);
      const policy = `${POLICY}${file === 'embed.html' ? '*' : "'none'"}`;
      outgoing.writeHead(bytes ? 200 : 404, { ...HEADERS, 'content-security-policy': policy, 'content-type': TYPES[extname(file)] ?? 'application/octet-stream' });
      outgoing.end(bytes ?? '');
      return;
    }
    const { hostname, port } = new URL(target());
    const onward = ask({ hostname, port, method: incoming.method, path: incoming.url, headers: incoming.headers }, (answer) => {
      outgoing.writeHead(answer.statusCode, answer.headers);
      outgoing.flushHeaders();
      pipeline(answer, outgoing, () => answer.destroy());
    });
    onward.on('error', () => outgoing.destroy());
    outgoing.on('close', () => onward.destroy());
    incoming.pipe(onward);
  });
  await new Promise((resolve) => { front.listen(0, '127.0.0.1', resolve); });
  return {
    url: `http://127.0.0.1:${front.address().port}`,
    stop: () => new Promise((resolve) => {
      front.close(resolve);
      front.closeAllConnections();
    }),
  };
}

export const launch = () => chromium.launch({ executablePath: process.env.CHROMIUM, args: FLAGS });

/** Skips a test that needs a server of its own where PLATEAU_URL names one that runs already. Returns whether it does. */
export const lacksOwnServer = (t) => isSkipped(t, 'studio with a server of its own', process.env.PLATEAU_URL && 'PLATEAU_URL names a server');

const MODULES = fileURLToPath(new URL('../../crates/page/js/', import.meta.url));
/** Skips a test that needs the second module where it has not been built. Returns whether it does. */
export const lacksSecondModule = (t) => isSkipped(t, 'second module of plateau-page', !existsSync(join(MODULES, 'structures.wasm')) && 'structures.wasm is not there: scripts/build-page');

/** Number of test files in this process that use the browser and have not ended. The last one closes what they share. */
let users = 0;
let shared = null;
/** Servers that no test file uses at the moment. */
const idle = [];

/** The browser that the test files of a process share: `browser` of the returned object, from the first test on. */
export function useBrowser() {
  const used = { browser: null };
  users += 1;
  before(async () => {
    if (shared && !(await shared).isConnected()) shared = null;
    used.browser = await (shared ??= launch());
  });
  after(async () => {
    users -= 1;
    if (users > 0) return;
    await used.browser?.close();
    shared = null;
    await Promise.all(idle.splice(0).map((server) => server.stop()));
  });
  return used;
}

/**
 * A studio for the tests of one file: `url`, and for each test a fresh `page` whose console, errors and requests are watched.
 * The server may have jobs of files that ran before, but no other file uses it at the same time.
 * Every test fails if the page logged an error, broke its policy or asked another host for anything. `hold` holds the jobs of the
 * server at a stage, at the latest until the end of the test; it is null if PLATEAU_URL names a server that runs already.
 * `device` has further options of the browser's contexts, such as `hasTouch`.
 */
export function useStudio({ viewport = { width: 1280, height: 720 }, colorScheme = 'light', ...device } = {}) {
  const studio = { url: '', hold: null, page: null, context: null, browser: null, faults: [], requests: [], allowed: [] };
  let own = null;

  before(async () => {
    own = process.env.PLATEAU_URL ? null : idle.pop() ?? await startServer();
    studio.url = own?.url ?? process.env.PLATEAU_URL;
    studio.hold = own?.hold ?? null;
  });
  after(() => { if (own) idle.push(own); });
  const used = useBrowser();
  beforeEach(async () => {
    studio.faults = [];
    studio.requests = [];
    studio.allowed = [studio.url];
    studio.browser = used.browser;
    studio.context = await studio.browser.newContext({ viewport, colorScheme, reducedMotion: 'reduce', ...device });
    studio.page = await studio.newPage();
  });
  afterEach(async () => {
    const foreign = studio.requests.filter((address) => !/^(blob|data):/.test(address) && !studio.allowed.some((url) => address.startsWith(url)));
    await studio.context.close();
    await studio.hold?.releaseAll();
    assert.deepEqual(studio.faults, [], 'no error in the page');
    assert.deepEqual(foreign, [], 'nothing is fetched from another host');
  });

  studio.newPage = async (context = studio.context) => {
    const page = await context.newPage();
    // A service without TLS on another machine is no secure context, where browsers have no such function.
    await page.addInitScript(() => { delete Crypto.prototype.randomUUID; });
    page.setDefaultTimeout(PATIENCE_MS);
    // By default a condition is looked at before each frame, and a browser on a busy machine may draw none for minutes.
    const wait = page.waitForFunction.bind(page);
    page.waitForFunction = (condition, argument, options) => wait(condition, argument, { polling: 50, ...options });
    page.on('pageerror', (error) => studio.faults.push(error.message));
    // Chromium logs every answer of 400 and above as an error; those are part of what is tested.
    page.on('console', (message) => message.type() === 'error' && !message.text().startsWith('Failed to load resource') && studio.faults.push(message.text()));
    page.on('request', (request) => studio.requests.push(request.url()));
    return page;
  };

  /** Opens an example, solved; or what the address says otherwise. */
  studio.open = async (example, page = studio.page) => {
    await page.goto(`${studio.url}/${example ? `?example=${example}` : ''}`);
    await solved(page);
  };
  return studio;
}

/** Waits until what is drawn is solved and shown. A wait in vain says what the page shows instead. */
export async function solved(page) {
  try {
    await page.waitForFunction(() => {
      const shown = window.studio?.shown();
      return shown && !shown.stale && document.body.getAttribute('aria-busy') === 'false' && document.querySelector('#status').textContent.startsWith('Solved');
    }, null, { timeout: PATIENCE_MS });
  } catch (error) {
    const seen = await page.evaluate(() => ({
      shown: window.studio?.shown(), request: window.studio?.request(), busy: document.body.getAttribute('aria-busy'),
      status: document.querySelector('#status').textContent, problem: document.querySelector('#problem').textContent,
    }));
    // The reporter prints the stack, which has the message that an error began with.
    throw new Error(`${error.message}\nThe page shows ${JSON.stringify(seen)}`, { cause: error });
  }
}

/** Waits until the camera rests and everything is drawn. */
export const atRest = (page) => page.waitForFunction(() => window.studio.isAtRest(), null, { timeout: PATIENCE_MS });

/** Turns the wheel and waits until the page has heard of it. */
export async function wheel(page, deltaY) {
  await page.evaluate(() => { window.wheeled = new Promise((done) => { addEventListener('wheel', done, { once: true }); }).then(() => true); });
  await page.mouse.wheel(0, deltaY);
  await page.evaluate(() => window.wheeled);
}

export const request = (page) => page.evaluate(() => window.studio.request());
export const points = (page) => page.evaluate(() => window.studio.points());

/** A place of the model's canvas in the page's coordinates. */
export async function onStage(page, { x, y }) {
  const box = await page.locator('#view').boundingBox();
  return [box.x + x, box.y + y];
}

/** Replaces the request by hand, as JSON. */
export async function apply(page, value) {
  await showPanel(page, 'setup');
  if (!await page.locator('#request-box').evaluate((box) => box.open)) await page.click('#request-box summary');
  await page.fill('#request', typeof value === 'string' ? value : JSON.stringify(value));
  await page.click('#apply-request');
}

/** Brings one of the two panels to the front where there is room for one only. */
export async function showPanel(page, name) {
  const tab = page.locator(`#tabs [data-panel="${name}"]`);
  if (await tab.isVisible()) await tab.click();
}

/** Drags from one place of the stage to another. */
export async function drag(page, from, to, { steps = 8, button = 'left', keys = [] } = {}) {
  await page.mouse.move(...await onStage(page, from));
  for (const key of keys) await page.keyboard.down(key);
  await page.mouse.down({ button });
  const [a, b] = [await onStage(page, from), await onStage(page, to)];
  for (let step = 1; step <= steps; step += 1) await page.mouse.move(a[0] + ((b[0] - a[0]) * step) / steps, a[1] + ((b[1] - a[1]) * step) / steps);
  await page.mouse.up({ button });
  for (const key of keys) await page.keyboard.up(key);
}

/** How much of the stage the model covers, from 0 to 1: pixels that are not see-through. */
export const covered = (page) => page.evaluate(() => {
  // The picture is there until the browser composes the next frame: draw and look in one turn.
  window.studio.draw();
  const copy = Object.assign(document.createElement('canvas'), { width: 400, height: 300 });
  const context = copy.getContext('2d', { willReadFrequently: true });
  context.drawImage(document.querySelector('#view'), 0, 0, 400, 300);
  const { data } = context.getImageData(0, 0, 400, 300);
  let filled = 0;
  for (let i = 3; i < data.length; i += 4) filled += data[i] > 235 ? 1 : 0;
  return filled / (data.length / 4);
});

/** The model's pixels: `[r, g, b]` of each that is not see-through. */
export const pixels = (page) => page.evaluate(() => {
  window.studio.draw();
  const view = document.querySelector('#view');
  const copy = Object.assign(document.createElement('canvas'), { width: 300, height: 200 });
  const context = copy.getContext('2d', { willReadFrequently: true });
  context.imageSmoothingEnabled = false;
  context.drawImage(view, 0, 0, 300, 200);
  const { data } = context.getImageData(0, 0, 300, 200);
  const found = [];
  for (let i = 0; i < data.length; i += 4) if (data[i + 3] > 250) found.push([data[i], data[i + 1], data[i + 2]]);
  return found;
});
