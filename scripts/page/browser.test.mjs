// Tests the package plateau-page in Chromium: results, errors, progress and cancel. The last test drags a film in the
// example page without a server.
//
// CHROMIUM names the browser. The modules are those of crates/page/js.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { extname } from 'node:path';
import { after, before } from 'node:test';
import { lacksSecondModule, test, useBrowser } from '../studio/harness.mjs';

const root = new URL('../../', import.meta.url).pathname;
const TYPES = { '.html': 'text/html', '.mjs': 'text/javascript', '.js': 'text/javascript', '.wasm': 'application/wasm' };
const ISOLATED = { 'cross-origin-opener-policy': 'same-origin', 'cross-origin-embedder-policy': 'require-corp' };

/** Serves the package as a plain file server does. Addresses below /isolated/ make their pages isolated. */
function serve({ url }, response) {
  const path = url.replace(/^\/isolated/, '');
  seen.push(path);
  const file = path.startsWith('/page/example/three.')
    ? `${root}web/node_modules/three/build/${path.slice('/page/example/'.length)}`
    : `${root}crates/page/js/${path.slice('/page/'.length)}`;
  try {
    const body = path === '/page/empty.html' ? '<!doctype html>' : readFileSync(file);
    response.writeHead(200, { 'content-type': TYPES[extname(path)] ?? 'text/plain', ...(url.startsWith('/isolated') ? ISOLATED : {}) });
    response.end(body);
  } catch {
    response.writeHead(404).end();
  }
}

/** Every path that was asked for. */
let seen = [];
let address;
const server = createServer(serve);
before(async () => {
  await new Promise((listening) => server.listen(0, '127.0.0.1', listening));
  address = `http://127.0.0.1:${server.address().port}`;
});
after(() => { server.close(); });
const used = useBrowser();

async function open(path) {
  const page = await used.browser.newPage({ viewport: { width: 900, height: 600 } });
  const faults = [];
  page.on('pageerror', (error) => faults.push(error.message));
  page.on('console', (message) => message.type() === 'error' && !message.text().includes('favicon') && !message.text().startsWith('Failed to load') && faults.push(message.text()));
  await page.goto(`${address}${path}`);
  return { page, faults };
}

const SADDLE = { kind: 'minimal_surface', boundaries: [[[0, 0, 0], [1, 0, 1], [1, 1, 0], [0, 1, 1]]] };
/** A film whose solver takes minutes. */
const LONG = { ...SADDLE, solver: 'vertex_relaxation', area_tolerance: 1e-15, max_iterations: 1_000_000, resolution: { triangles: 20_000 } };

for (const folder of ['/page', '/isolated/page']) {
  (folder === '/page' ? test.quick : test)(`${folder}: a film is solved with progress and files, and a wrong request names its values`, async () => {
    const { page, faults } = await open(`${folder}/empty.html`);
    const seen = await page.evaluate(async ({ folder, SADDLE }) => {
      const { createSolvers, PlateauError } = await import(`${folder}/index.mjs`);
      const solvers = createSolvers();
      const phases = [];
      const first = await solvers.solve(SADDLE, { onProgress: ({ phase }) => phases.push(phase) });
      const glb = await first.glb();
      const wrong = await solvers.solve({ ...SADDLE, boundaries: [[[0, 0, 0], [1, 0, null], [1, 1, 0]]] }).catch((error) => error);
      const late = await first.glb().catch((error) => error.message);
      const { statistics, mesh } = first;
      solvers.close();
      return {
        isolated: crossOriginIsolated,
        converged: statistics.converged,
        counts: [statistics.vertices, mesh.vertices.length / 3, statistics.triangles, mesh.triangles.length / 3],
        magic: new TextDecoder().decode(glb.subarray(0, 4)),
        phases: phases.length,
        wrong: [wrong instanceof PlateauError, wrong.ending, wrong.errors[0].pointer],
        late,
      };
    }, { folder, SADDLE });
    assert.equal(seen.isolated, folder === '/isolated/page');
    assert.equal(seen.converged, true);
    assert.equal(seen.counts[0], seen.counts[1]);
    assert.equal(seen.counts[2], seen.counts[3]);
    assert.equal(seen.magic, 'glTF');
    assert.ok(seen.phases > 0);
    assert.deepEqual(seen.wrong, [true, 'refused', '/boundaries/0/1/2']);
    assert.match(seen.late, /a later request has replaced/);
    assert.deepEqual(faults, []);
    await page.close();
  });

  test(`${folder}: a cancel ends the request under way and one that waits, and the next is solved`, async () => {
    const { page, faults } = await open(`${folder}/empty.html`);
    const seen = await page.evaluate(async ({ folder, SADDLE, LONG }) => {
      const { createSolvers } = await import(`${folder}/index.mjs`);
      const solvers = createSolvers();
      const [long, queued] = [new AbortController(), new AbortController()];
      let begun;
      const running = new Promise((resolve) => { begun = resolve; });
      const ended = solvers.solve(LONG, { signal: long.signal, onProgress: begun }).catch((error) => error.name);
      const waited = solvers.solve(LONG, { signal: queued.signal }).catch((error) => error.name);
      const last = solvers.solve(SADDLE);
      await running;
      queued.abort();
      long.abort();
      const names = [await ended, await waited];
      const { statistics } = await last;
      solvers.close();
      const closed = await solvers.solve(SADDLE, { signal: AbortSignal.abort() }).catch((error) => error.name);
      return { names, converged: statistics.converged, closed };
    }, { folder, SADDLE, LONG });
    assert.deepEqual(seen, { names: ['AbortError', 'AbortError'], converged: true, closed: 'AbortError' });
    assert.deepEqual(faults, []);
    await page.close();
  });
}

test.quick('a film follows a drag without a network, and the released film has the bits of a solve', async () => {
  const { page, faults } = await open('/page/empty.html');
  await page.evaluate(async (SADDLE) => {
    const { createSolvers } = await import('/page/index.mjs');
    window.solvers = createSolvers();
    window.first = await window.solvers.solve(SADDLE);
  }, SADDLE);
  await page.context().setOffline(true);
  const seen = await page.evaluate(async (SADDLE) => {
    const at = (height) => ({ ...SADDLE, boundaries: [[[0, 0, 0], [1, 0, height], [1, 1, 0], [0, 1, 1]]] });
    const moves = [];
    for (let step = 1; step <= 20; step += 1) moves.push(await window.solvers.drag(at(1 - 0.02 * step)));
    const released = await window.solvers.solve(at(0.6));
    const fresh = await window.solvers.solve(at(0.6));
    const strip = { kind: 'ruled_surface', directrices: [[[0, 0, 0], [1, 0, 0]], [[0, 1, 0], [1, 1, 1]]] };
    const cold = await window.solvers.drag(strip);
    const wrong = await window.solvers.drag(at(null)).catch((error) => [error.ending, error.errors[0].pointer]);
    const last = moves.at(-1);
    return {
      previews: moves.filter(({ moved }) => moved !== null).length,
      sameTriangles: String(last.mesh.triangles) === String(window.first.mesh.triangles),
      height: last.mesh.vertices[5],
      residual: last.moved.residual,
      close: Math.abs(last.moved.area / released.statistics.area - 1),
      equal: String(released.mesh.vertices) === String(fresh.mesh.vertices),
      cold: [cold.moved, cold.statistics.triangles > 0],
      wrong,
    };
  }, SADDLE);
  const { residual, close, ...rest } = seen;
  assert.ok(residual <= 1e-4 && close < 1e-3, `${residual} ${close}`);
  assert.deepEqual(rest, {
    previews: 20, sameTriangles: true, height: 0.6, equal: true, cold: [null, true], wrong: ['refused', '/boundaries/0/1/2'],
  });
  assert.deepEqual(faults, []);
  await page.close();
});

test('the second module is loaded by the first request that needs it', async (t) => {
  if (lacksSecondModule(t)) return;
  const { page, faults } = await open('/page/empty.html');
  seen = [];
  const modules = () => seen.filter((path) => path.endsWith('.wasm')).map((path) => path.split('/').at(-1));
  await page.evaluate(async (SADDLE) => {
    const { createSolvers } = await import('/page/index.mjs');
    window.solvers = createSolvers();
    window.film = await window.solvers.solve(SADDLE);
  }, SADDLE);
  assert.deepEqual(modules(), ['shapes.wasm']);
  const net = { kind: 'cable_net', vertices: [[0, 0, 0], [1, 0, 0], [2, 0, 1]], edges: [[0, 1], [1, 2]], supports: [0, 2], cables: [{ force_density: 1 }] };
  const found = await page.evaluate(async (net) => {
    const { mesh } = await window.solvers.solve(net);
    // The first module still has its result, but a later request has replaced it for the page.
    const late = await window.film.glb().catch((error) => error.message);
    return { middle: [...mesh.vertices.slice(3, 6)], late };
  }, net);
  assert.deepEqual(modules(), ['shapes.wasm', 'structures.wasm']);
  assert.deepEqual(found.middle, [1, 0, 0.5]);
  assert.match(found.late, /a later request has replaced/);
  // Each module is loaded once, and `load` loads what is not there yet.
  await page.evaluate(async (SADDLE) => {
    await window.solvers.solve(SADDLE);
    await window.solvers.load('tensile_structure');
  }, SADDLE);
  assert.equal(modules().length, 2);
  assert.deepEqual(faults, []);
  await page.close();
});

test('a module that cannot be loaded fails its requests, and only those', async () => {
  const { page } = await open('/page/empty.html');
  const found = await page.evaluate(async (SADDLE) => {
    const { createSolvers } = await import('/page/index.mjs');
    const solvers = createSolvers({ structures: '/page/missing.wasm' });
    const missing = await solvers.solve({ kind: 'cable_net' }).catch((error) => `${error.name}: ${error.message}`);
    return { missing, converged: (await solvers.solve(SADDLE)).statistics.converged };
  }, SADDLE);
  assert.match(found.missing, /^Error: the module at .*missing\.wasm was answered with 404/);
  assert.equal(found.converged, true);
  await page.close();
});

test('a page of forty lines drags a film without a server', async () => {
  const { page, faults } = await open('/page/example/index.html');
  await page.waitForFunction(() => document.title.startsWith('film 1:'));
  await page.context().setOffline(true);
  // The corner at (1, -1, 1) on the screen.
  await page.mouse.move(...await corner(page));
  await page.mouse.down();
  for (let step = 1; step <= 60; step += 1) await page.mouse.move(...await below(page, step));
  await page.mouse.up();
  await page.waitForFunction(() => Number(document.title.split(' ')[1].replace(':', '')) > 5);
  if (process.env.SCREENSHOT) await page.screenshot({ path: process.env.SCREENSHOT });
  assert.deepEqual(faults, []);
  await page.close();
});

let start = null;
async function corner(page) {
  // The same camera as the page's.
  start = await page.evaluate(async () => {
    const THREE = await import('three');
    const camera = new THREE.PerspectiveCamera(40, innerWidth / innerHeight, 0.1, 100);
    camera.up.set(0, 0, 1);
    camera.position.set(3, -5, 4);
    camera.lookAt(0, 0, 0.5);
    camera.updateMatrixWorld();
    const { x, y } = new THREE.Vector3(1, -1, 1).project(camera);
    return [(x + 1) / 2 * innerWidth, (1 - y) / 2 * innerHeight];
  });
  return start;
}
const below = async (page, step) => [start[0], start[1] + step];
