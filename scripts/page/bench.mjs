// Measures drags in the page and prints lines for benches/results.jsonl.
//
// 1. `page_drag_engine` has the milliseconds of each call in Node. A film of 2,000 and of 20,000 triangles follows 200 moves.
// 2. `page_drag` has a film, a strip, a lattice and a sail in Chromium, each dragged 200 moves with the network cut. A move is asked
//    for as soon as the result of the last move is there and a frame has passed. The same drag then runs over HTTP with 50 moves,
//    each answer delayed by 0 and by 80 ms. After the release the page's vertices are compared with those of the service's job.
//
// CHROMIUM=… PLATEAU_BIN=… node scripts/page/bench.mjs >> benches/results.jsonl, on a quiet machine.

import assert from 'node:assert/strict';
import { execSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { createServer, request as onward } from 'node:http';
import { cpus, loadavg } from 'node:os';
import { extname } from 'node:path';
import { load } from '../../crates/page/js/plateau.mjs';
import { launch, startServer } from '../studio/harness.mjs';

const root = new URL('../../', import.meta.url).pathname;
const MOVES = 200;
/** Moves over HTTP, which are spread over the same drag. */
const HTTP_MOVES = 50;
const DELAYS_MS = [0, 80];
const TYPES = { '.mjs': 'text/javascript', '.wasm': 'application/wasm' };
const example = (name) => JSON.parse(readFileSync(`${root}api/examples/${name}.json`, 'utf8'));
const round = (value) => Number(value.toFixed(1));
const sorted = (values) => [...values].sort((a, b) => a - b);
const median = (values) => sorted(values)[Math.floor(values.length / 2)];
const common = {
  date: new Date().toISOString().slice(0, 10),
  commit: execSync('git rev-parse --short HEAD').toString().trim(),
  machine: `${cpus().length} cores x86_64`,
};
const say = (line) => console.log(JSON.stringify({ ...common, load: round(loadavg()[0]), ...line }));

/** A request and one of its points, whose last coordinate is dragged by `reach`. */
const SCENES = {
  film: { path: '/v1/minimal-surfaces', request: { ...example('tent'), resolution: { triangles: 2000 } }, point: ['boundaries', 0, 2], reach: 2 },
  strip: { path: '/v1/ruled-surfaces', request: example('wavy-strip'), point: ['directrices', 0, 30], reach: 0.2 },
  lattice: { path: '/v1/uniform-meshes', request: example('latticed-roof'), point: ['domain', 'bezier', 'control_points', 2, 2], reach: 5 },
  sail: { path: '/v1/tensile-structures', request: example('four-point-sail'), point: ['boundaries', 0, 2], reach: 1 },
};

/** The request of a move. The point goes up, down below its start, and back. */
function moved({ request, point, reach }, move) {
  const copy = structuredClone(request);
  point.reduce((value, member) => value[member], copy)[2] += reach * Math.sin(2 * Math.PI * move / MOVES);
  return copy;
}

const engine = await load(readFileSync(`${root}crates/page/js/shapes.wasm`));
for (const triangles of [2000, 20000]) {
  const scene = { ...SCENES.film, request: { ...SCENES.film.request, resolution: { triangles } } };
  const cold = [0, 1, 2, 3, 4, 5].map(() => {
    const started = performance.now();
    assert.equal(engine.solve(scene.request).ending, 'solved');
    return performance.now() - started;
  });
  const [times, processor] = [[], []];
  let solved = 0;
  for (let move = 1; move <= MOVES; move += 1) {
    const request = JSON.stringify(moved(scene, move));
    const [started, used] = [performance.now(), process.cpuUsage()];
    const { ending } = engine.drag(request);
    engine.vertices();
    times.push(performance.now() - started);
    const { user, system } = process.cpuUsage(used);
    processor.push((user + system) / 1000);
    solved += ending === 'moved' ? 0 : 1;
  }
  const warm = times.slice(20);
  say({
    bench: 'page_drag_engine', where: `Node ${process.versions.node}`, triangles, moves: MOVES, solved_anew: solved, first_ms: round(times[0]),
    median_ms: round(median(warm)), p95_ms: round(sorted(warm)[Math.floor(0.95 * warm.length)]), max_ms: round(Math.max(...warm)),
    processor_median_ms: round(median(processor.slice(20))), solve_ms: round(cold.at(-1)), aim_ms: triangles === 2000 ? 8 : 30,
  });
}

const server = await startServer();
/** Serves the package and an empty page below /page/, and passes everything else to the service after the delay. */
let delay = 0;
const front = createServer((incoming, outgoing) => {
  const file = `${root}crates/page/js/${incoming.url.slice('/page/'.length)}`;
  if (incoming.url === '/page/empty.html') return outgoing.writeHead(200, { 'content-type': 'text/html' }).end('<!doctype html>');
  if (incoming.url.startsWith('/page/')) return outgoing.writeHead(200, { 'content-type': TYPES[extname(file)] }).end(readFileSync(file));
  const { hostname, port } = new URL(server.url);
  const asked = onward({ hostname, port, method: incoming.method, path: incoming.url, headers: incoming.headers }, (answer) => {
    setTimeout(() => {
      outgoing.writeHead(answer.statusCode, answer.headers);
      answer.pipe(outgoing);
    }, delay);
  });
  incoming.pipe(asked);
});
await new Promise((listening) => { front.listen(0, '127.0.0.1', listening); });
const address = `http://127.0.0.1:${front.address().port}`;
const browser = await launch();

/** Drags in the page: the milliseconds at which each answer was there, and how many were previews. */
const inPage = (page, requests) => page.evaluate(async (requests) => {
  const times = [performance.now()];
  let previews = 0;
  for (const request of requests) {
    previews += (await window.solvers.drag(request)).moved ? 1 : 0;
    times.push(performance.now());
    await new Promise(requestAnimationFrame);
  }
  return { times, previews };
}, requests);

const overHttp = (page, path, requests) => page.evaluate(async ({ path, requests }) => {
  window.overHttp = async (request) => {
    const headers = { 'content-type': 'application/json', prefer: 'wait=60' };
    const { kind: _, ...body } = request;
    const job = await (await fetch(path, { method: 'POST', headers, body: JSON.stringify({ ...body, cache: 'bypass' }) })).json();
    if (job.status !== 'succeeded') throw new Error(JSON.stringify(job).slice(0, 500));
    return job;
  };
  const times = [performance.now()];
  for (const request of requests) {
    const job = await window.overHttp(request);
    await (await fetch(`${job.links.mesh}?format=glb`)).arrayBuffer();
    times.push(performance.now());
    await new Promise(requestAnimationFrame);
  }
  return { times };
}, { path, requests });

function figures({ times }) {
  const gaps = times.slice(1).map((time, k) => time - times[k]);
  return { frames_a_second: round(1000 * gaps.length / (times.at(-1) - times[0])), median_ms: round(median(gaps)), longest_gap_ms: round(Math.max(...gaps)) };
}

for (const [name, scene] of Object.entries(SCENES)) {
  const context = await browser.newContext();
  const page = await context.newPage();
  await page.goto(`${address}/page/empty.html`);
  await page.evaluate(async (request) => {
    const { createSolvers } = await import('/page/index.mjs');
    window.solvers = createSolvers();
    await window.solvers.solve(request);
  }, scene.request);
  const requests = Array.from({ length: MOVES }, (_, move) => moved(scene, move + 1));
  await context.setOffline(true);
  const dragged = await inPage(page, requests);
  const last = moved(scene, MOVES / 4);
  const released = await page.evaluate(async (request) => {
    const { mesh, statistics } = await window.solvers.solve(request);
    return { vertices: [...mesh.vertices], triangles: [...mesh.triangles], statistics };
  }, last);
  await context.setOffline(false);
  const http = {};
  for (const each of DELAYS_MS) {
    delay = each;
    http[`http_${each}_ms`] = figures(await overHttp(page, scene.path, requests.filter((_, move) => move % (MOVES / HTTP_MOVES) === 0)));
  }
  delay = 0;
  const job = await page.evaluate(async (request) => {
    const job = await window.overHttp(request);
    const mesh = await (await fetch(`${job.links.mesh}?format=json`)).json();
    return { statistics: job.statistics, vertices: mesh.vertices.flat(), triangles: mesh.triangles.flat() };
  }, last);
  assert.deepEqual(released.triangles, job.triangles);
  const same = released.vertices.length === job.vertices.length && released.vertices.every((value, k) => Object.is(value + 0, job.vertices[k] + 0));
  say({
    bench: 'page_drag', where: 'headless Chromium', server: process.env.PLATEAU_BUILD ?? 'release build', scene: name, triangles: released.triangles.length / 3,
    moves: MOVES, http_moves: HTTP_MOVES, network: 'cut', previews: dragged.previews, ...figures(dragged), ...http, released_equals_the_job: same,
  });
  await context.close();
}
await browser.close();
front.close();
front.closeAllConnections();
await server.stop();
