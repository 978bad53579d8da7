// The client against a real server: solve, progress, cancel, errors by pointer, live dragging.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Vector3 } from 'three';
import {
  Busy, ConnectionFailed, InvalidRequest, JobCancelled, JobFailed, NotFound, Plateau, Unauthorized, version,
} from 'plateau-client';
import { toBufferGeometry } from 'plateau-client/three';
import { until } from './hold.mjs';
import { startServer } from './server.mjs';

const TENT = [[0, 0, 0], [8, 0, 3], [8, 8, 0], [0, 8, 3]];
const SURVEY = [2_600_123.123456789, 1_200_456.987654321, 431.25];

let server;
let client;
before(async () => {
  server = await startServer();
  client = new Plateau(server.url);
});
after(() => server.stop());

const moved = (by) => TENT.map((point) => point.map((value, axis) => value + by[axis]));
/** A small request, never the same twice with different shifts. A hold makes it take as long as a test needs. */
const small = (shift) => ({
  kind: 'minimal_surface', boundaries: [moved([0, 0, shift])], resolution: { triangles: 200 }, cache: 'bypass',
});

const nothingRuns = () => until('nothing runs', async () => {
  const busy = await Promise.all(['queued', 'running'].map((status) => collect(client.jobs({ status }))));
  return busy.flat().length === 0 && !(await server.hold.holdsOne());
});

async function collect(iterable) {
  const all = [];
  for await (const item of iterable) all.push(item);
  return all;
}

/** A fetch that passes requests on and lets `meddle` change what comes back. */
function lossy(meddle) {
  const seen = [];
  const own = async (input, init) => {
    seen.push({ url: String(input), ...init });
    return meddle(seen.length, await fetch(input, init), seen.at(-1));
  };
  return { seen, client: (options) => new Plateau({ url: server.url, fetch: own, ...options }) };
}

test('every kind is solved', async () => {
  const rails = [TENT.slice(0, 2), [[0, 8, 3], [4, 8, 2], [8, 8, 0]]];
  const strip = await client.ruledSurface(rails, { objective: 'minimal_twist' });
  const film = await client.minimalSurface([TENT], { resolution: { triangles: 2000 }, units: 'mm' });
  const floor = await client.uniformMesh([[0, 0, 0], [30, 0, 0], [30, 20, 0], [0, 20, 0]], 2.5);
  const edges = [0, 1, 2, 3].map((k) => ({ along: { from: k, to: (k + 1) % 4 }, mode: 'force', value: 10 }));
  const square = [[0, 0, 0], [10, 0, 0], [10, 10, 0], [0, 10, 0]];
  const sail = await client.tensileStructure([square], { tension: 1 }, { cables: edges, resolution: { triangles: 500 } });
  assert.ok(sail.statistics.converged && Math.abs(sail.statistics.area - 63.77) < 0.6);
  const corners = [[0, 0, 0], [1, 0, 1], [1, 1, 0], [0, 1, 1], [0.2, 0.7, 3]];
  const spokes = [[0, 4], [1, 4], [2, 4], [3, 4]];
  const net = await client.cableNet(corners, spokes, [0, 1, 2, 3], { cables: [{ force_density: 1 }] });
  assert.ok([12, 13, 14].every((k) => Math.abs(net.vertices[k] - 0.5) < 1e-12) && net.triangles.length === 0);
  assert.deepEqual([...net.edges], spokes.flat());
  assert.ok(net.forces.every((force) => Math.abs(force - Math.sqrt(0.75)) < 1e-12) && net.forces.length === 4);
  assert.equal(film.edges.length, 0);
  assert.equal(strip.triangles.length, 3 * strip.statistics.triangles);
  assert.equal(strip.meanCurvature, null);
  assert.equal(film.vertices.length, 3 * film.statistics.vertices);
  assert.equal(film.meanCurvature.length, film.statistics.vertices);
  assert.deepEqual([film.unit, film.up], ['mm', 'z']);
  assert.equal(floor.vertices.length, 3 * floor.statistics.nodes);
  const members = await floor.lines();
  assert.deepEqual([...members.keys()], ['members lattice', 'members rim']);
  assert.equal(members.get('members rim').values.length.length, members.get('members rim').paths.length);
  const lines = await net.lines();
  const [cable] = [...lines.values()];
  assert.ok(cable.paths.flatMap((path) => [...path]).every((vertex) => vertex < net.vertices.length / 3));
  assert.ok(cable.values.force.length === cable.paths.length && cable.unit === 'kN');
  const { arrows, values } = lines.get('reactions');
  assert.ok(arrows.length === 6 * 4 && values.force.every((force) => Math.abs(force - Math.sqrt(0.75)) < 1e-12));
  assert.ok(new TextDecoder().decode(await strip.download('svg')).startsWith('<svg'));
  assert.equal(new TextDecoder().decode((await film.download('glb')).slice(0, 4)), 'glTF');
});

test('a batch gives a mesh for each request or its error', async () => {
  const requests = [small(0.1), small(0.2)];
  const batch = await client.submitBatch(requests);
  const films = await batch.wait();
  assert.deepEqual(films.map((film) => film.request), requests);
  assert.deepEqual(films.map((film) => film.vertices[2]), [0.1, 0.2]);
  assert.deepEqual((await client.batch(batch.id)).info.jobs, batch.info.jobs);
  assert.equal(new TextDecoder().decode((await batch.download('zip', 'ply')).slice(0, 2)), 'PK');
  assert.equal(new TextDecoder().decode((await batch.download('glb')).slice(0, 4)), 'glTF');
  const refused = await client.submitBatch([small(0.3), { ...small(0.3), boundaries: [] }]).catch((error) => error);
  assert.match(refused.errors[0].pointer, /^\/requests\/1\/boundaries/);
  await batch.delete();
  await assert.rejects(batch.refresh(), NotFound);
  await server.hold.during('claimed', async () => {
    const late = await client.submitBatch([small(0.4), small(0.5)]);
    await late.cancel();
    assert.ok((await late.wait()).every((one) => one instanceof JobCancelled));
  });
});

test('patterns and schedules are made by their parameters', async () => {
  const text = (bytes) => new TextDecoder().decode(bytes);
  const strip = await client.ruledSurface([[[0, 0, 0], [1, 0, 0.2], [2, 0, 0]], [[0, 1, 0], [2, 1, 0.5]]]);
  assert.ok(text(await strip.pattern()).startsWith('<svg'));
  assert.equal(text((await strip.pattern({ profile: 'cut', format: 'dxf', kerf: 0.2 })).slice(0, 2)), 'PK');
  const [on, off] = await Promise.all(['true', 'false'].map((angles) => strip.pattern({ format: 'dxf', angles })));
  assert.notDeepEqual(on, off);
  const table = text(await strip.schedule({ part: 'bends' })).split('\n');
  assert.ok(table.length > 1 && table[0].includes(','), table[0]);
  const refused = await strip.pattern({ kerf: -1 }).catch((error) => error);
  assert.ok(refused.status === 400 && /kerf/.test(refused.message), refused);
  await assert.rejects((await client.solve(small(0.7))).pattern(), NotFound);
});

test('the request and the certificate come back', async () => {
  const request = { ...small(0.6), certify: { seconds: 0.1 } };
  const proven = await client.solve(request);
  assert.equal(proven.request, request);
  assert.equal((await (await client.submit(request)).wait()).request, request);
  assert.equal((await client.job(proven.id)).request, undefined);
  assert.ok(Object.keys(await proven.certificate()).length > 0);
  await assert.rejects((await client.solve(small(0.7))).certificate(), NotFound);
});

test('the server is told who asks', async () => {
  const { seen, client: make } = lossy((number, response) => response);
  await make().limits();
  assert.equal(seen[0].headers['User-Agent'], `plateau-client/${version} (Node.js)`);
});

test("vertices are the solver's own numbers, at survey coordinates too", async () => {
  const film = await client.minimalSurface([moved(SURVEY)], { resolution: { triangles: 500 } });
  assert.deepEqual([...film.vertices.subarray(0, 12)], moved(SURVEY).flat());
  const obj = new TextDecoder().decode(await film.download('obj'));
  const read = [...obj.matchAll(/^v (\S+) (\S+) (\S+)$/gm)].flatMap((match) => match.slice(1).map(Number));
  assert.deepEqual([...film.vertices], read);
});

test('curves may be vectors of three.js and typed arrays', async () => {
  const areas = [TENT, TENT.map((point) => new Vector3(...point)), new Float64Array(TENT.flat())];
  const options = { resolution: { triangles: 200 } };
  const films = await Promise.all(areas.map((curve) => client.minimalSurface([curve], options)));
  assert.equal(new Set(films.map((film) => film.statistics.area)).size, 1);
});

test('a geometry for three.js keeps its place and its size', async () => {
  const film = await client.minimalSurface([moved(SURVEY)], { resolution: { triangles: 500 } });
  for (const [up, turned] of [['z', (v) => v], ['y', ([x, y, z]) => [x, z, -y]]]) {
    const geometry = toBufferGeometry(film, { up });
    const { origin, unit } = geometry.userData;
    assert.equal(unit, 'm');
    const position = geometry.getAttribute('position');
    for (const vertex of [0, 57, position.count - 1]) {
      const near = [position.getX(vertex), position.getY(vertex), position.getZ(vertex)];
      const placed = near.map((value, axis) => value + origin[axis]);
      const expected = turned([...film.vertices.subarray(3 * vertex, 3 * vertex + 3)]);
      assert.ok(placed.every((value, axis) => Math.abs(value - expected[axis]) < 1e-6), `${placed} and ${expected}`);
    }
    assert.equal(geometry.getIndex().count, film.triangles.length);
    assert.equal(geometry.getAttribute('mean_curvature').count, position.count);
    assert.ok(geometry.getAttribute('normal').count === position.count);
  }
});

test('examples are solved as they are served', async () => {
  for (const name of ['helicoid-liu-wang', 'two-rails', 'courtyard']) {
    const mesh = await client.solve(await client.example(name));
    assert.equal(mesh.triangles.length, 3 * mesh.statistics.triangles);
  }
});

test('progress rises to the end', async () => {
  const seen = [];
  const onProgress = ({ fraction }) => {
    seen.push(fraction);
    if (fraction >= 0.5) void server.hold.release('half');
  };
  await server.hold.during('half', () => client.solve(small(0.001), { onProgress }));
  assert.ok(seen[0] < 0.5 && seen.some((fraction) => fraction >= 0.5 && fraction < 1));
  assert.deepEqual(seen, seen.toSorted((a, b) => a - b));
  assert.equal(seen.at(-1), 1);
});

test('a job is cancelled by whoever has its handle', () => server.hold.during('claimed', async () => {
  const job = await client.submit(small(0.002));
  assert.equal((await job.cancel()).status, 'cancelled');
  await assert.rejects(job.wait(), JobCancelled);
  await job.delete();
  await assert.rejects(job.refresh(), NotFound);
}));

test('who stops waiting cancels the job', () => server.hold.during('claimed', async () => {
  // Before the request is sent, somewhere in its submission, and while the client waits for the answer.
  const moments = [() => {}, () => new Promise((resolve) => setTimeout(resolve, 5)), () => until('held', () => server.hold.holdsOne())];
  for (const [number, moment] of moments.entries()) {
    const controller = new AbortController();
    const solved = client.solve(small(0.003 + number), { signal: controller.signal });
    const refused = assert.rejects(solved, /enough/);
    await moment();
    controller.abort(new Error('enough'));
    await refused;
    await nothingRuns();
  }
  const own = new Error('my own fault');
  await assert.rejects(client.solve(small(0.004), { onProgress: () => { throw own; } }), own);
  const timed = client.solve(small(0.005), { onProgress: () => {}, signal: AbortSignal.timeout(300) });
  await assert.rejects(timed, { name: 'TimeoutError' });
  await nothingRuns();
}));

test('errors lead to the values', async () => {
  const wrong = { resolution: { triangles: -5 }, units: 'MM' };
  const refused = await client.minimalSurface([TENT], wrong).catch((error) => error);
  assert.ok(refused instanceof InvalidRequest);
  assert.equal(refused.status, 422);
  assert.deepEqual(refused.errors.map((error) => error.pointer).sort(), ['/resolution/triangles', '/units']);
  assert.match(refused.message, /\/units: /);
  assert.ok(refused.requestId);

  const local = await client.minimalSurface([TENT, [[0, 0, 0], [1, NaN, 0], [1, 1, 0]]]).catch((error) => error);
  assert.ok(local instanceof InvalidRequest);
  assert.equal(local.status, null);
  assert.equal(local.errors[0].pointer, '/boundaries/1/1/1');
  await assert.rejects(client.minimalSurface([new Float64Array(4)]), /\/boundaries\/0: expected x y z of each point/);

  const twisted = [[0, 0, 0], [30, 20, 0], [30, 0, 0], [0, 20, 0]];
  const failed = await client.uniformMesh(twisted, 2.5).catch((error) => error);
  assert.ok(failed instanceof JobFailed || failed instanceof InvalidRequest);
  assert.ok(failed.detail);
});

test('slips are explained before they are sent', async () => {
  const nowhere = new Plateau({ url: 'http://127.0.0.1:9', patienceMs: 0 });
  const refused = (step) => step.then(() => assert.fail('accepted'), (error) => {
    assert.ok(error instanceof InvalidRequest, String(error));
    return `${error.errors[0].pointer}: ${error.errors[0].detail}`;
  });
  for (const curve of [TENT, TENT.map((point) => new Vector3(...point)), new Float64Array(TENT.flat())]) {
    assert.match(await refused(nowhere.minimalSurface(curve)), /^\/boundaries: lacks a level of brackets: it must be a list of /);
  }
  const force = '/units: must be an object, such as {"force":"kN","length":"mm"}';
  assert.equal(await refused(nowhere.tensileStructure([TENT], { tension: 1 }, { units: 'mm' })), force);
  const net = { kind: 'cable_net', vertices: TENT, edges: [[0, 1]], supports: [0], units: 'mm' };
  assert.equal(await refused(nowhere.submitBatch([net])), `/requests/0${force}`);
});

test('a slip is told in the words of the server', async () => {
  const film = { tension: 1 };
  const net = { edges: [[0, 1]], supports: [0] };
  const slips = [
    [(c) => c.minimalSurface(TENT), 'minimal-surfaces', { boundaries: TENT }],
    [(c) => c.minimalSurface([[TENT]]), 'minimal-surfaces', { boundaries: [[TENT]] }],
    [(c) => c.minimalSurface([TENT, [TENT]]), 'minimal-surfaces', { boundaries: [TENT, [TENT]] }],
    [(c) => c.ruledSurface(TENT), 'ruled-surfaces', { directrices: TENT }],
    [(c) => c.uniformMesh([TENT], 1), 'uniform-meshes', { domain: { polygon: [TENT] }, edge_length: 1 }],
    [(c) => c.tensileStructure([TENT], film, { units: 'm' }), 'tensile-structures', { boundaries: [TENT], film, units: 'm' }],
    [(c) => c.cableNet([TENT], [[0, 1]], [0]), 'cable-nets', { vertices: [TENT], ...net }],
    [(c) => c.cableNet(TENT, [[0, 1]], [0], { units: 'm' }), 'cable-nets', { vertices: TENT, ...net, units: 'm' }],
  ];
  for (const [step, path, body] of slips) {
    const error = await step(client).then(() => assert.fail('accepted'), (reason) => reason);
    const request = { method: 'POST', headers: { 'Content-Type': 'application/json' }, body: JSON.stringify(body) };
    const said = (await (await fetch(`${server.url}/v1/${path}`, request)).json()).errors;
    assert.deepEqual([error.status, error.errors], [null, said.map(({ pointer, detail }) => ({ pointer, detail }))]);
  }
});

test('the server says what is wrong with an index or a film, and the client what with a kind', async () => {
  const cables = { cables: [{ force: 1 }] };
  for (const [step, pointer, status] of [
    [() => client.cableNet(TENT, [[0, 1], [0, 1, 2]], [0], cables), '/edges/1', 422],
    [() => client.cableNet(TENT, null, [0], cables), '/edges', 422],
    [() => client.cableNet(TENT, [[0, 1]], null, cables), '/supports', 422],
    [() => client.tensileStructure([TENT], null), '/film', 422],
    [() => client.solve({ kind: 'minimal_surfaces', boundaries: [TENT] }), '/kind', null],
  ]) {
    const error = await step().then(() => assert.fail('accepted'), (reason) => reason);
    assert.ok(error instanceof InvalidRequest, String(error));
    assert.deepEqual([error.errors[0].pointer, error.status], [pointer, status]);
  }
});

test('every error about a job has its id', async () => {
  const mesh = await client.solve(small(0.8));
  const job = await client.job(mesh.id);
  const about = (step) => assert.rejects(step, (error) => error instanceof NotFound && error.jobId === mesh.id);
  await about(mesh.certificate());
  await job.delete();
  for (const step of [
    () => mesh.download(), () => mesh.lines(), () => mesh.pattern(), () => mesh.schedule({ part: 'nodes' }), () => mesh.certificate(), () => job.refresh(),
    () => job.fetchRequest(), () => job.wait(), () => job.cancel(), () => client.job(mesh.id), () => client.resume(mesh.id),
  ]) await about(step());
});

test('a page that CORS blocks is told the setting', async (context) => {
  globalThis.location = { origin: 'https://page.example' };
  context.after(() => delete globalThis.location);
  // As browsers do: no answer at all, except to requests that want none.
  const blocking = (input, init) => (init.mode === 'no-cors' ? fetch(input) : Promise.reject(new TypeError('Failed to fetch')));
  const error = await new Plateau({ url: server.url, fetch: blocking }).limits().catch((reason) => reason);
  assert.ok(error instanceof ConnectionFailed);
  assert.match(error.message, /answers, but the browser keeps .*http\.cors_origins must name "https:\/\/page\.example"/);
  const absent = await new Plateau({ url: 'http://127.0.0.1:9', patienceMs: 0 }).limits().catch((reason) => reason);
  assert.match(absent.message, /^http:\/\/127\.0\.0\.1:9 cannot be reached; start the service there/);
});

test('only the newest of a drag is delivered', async () => {
  const live = client.live();
  const solved = [];
  await server.hold.during('claimed', async () => {
    for (let step = 0; step < 20; step++) {
      const followed = new Promise((resolve) => solved.push(live.solve(small(0.01 + step / 1000), { onProgress: resolve })));
      // The first ten follow each other once the server has the one before, the others at once.
      if (step < 10) await followed;
    }
  });
  const films = await Promise.all(solved);
  assert.ok(films.slice(0, -1).every((film) => film === null));
  assert.ok(Math.abs(films.at(-1).vertices[2] - 0.029) < 1e-12);
  await nothingRuns();
});

test('an answer that is lost is asked for again and nothing is solved twice', async () => {
  const { seen, client: make } = lossy((number, response) => {
    if (number === 1) throw new TypeError('fetch failed');
    return response;
  });
  const film = await make().minimalSurface([TENT]);
  const posts = seen.filter((request) => request.method === 'POST');
  assert.equal(posts.length, 2);
  assert.equal(posts[0].headers['Idempotency-Key'], posts[1].headers['Idempotency-Key']);
  const jobs = await collect(client.jobs({ idempotency_key: posts[0].headers['Idempotency-Key'] }));
  assert.deepEqual(jobs.map((job) => job.id), [film.id]);
});

test('a busy server is asked again for as long as the patience lasts', async () => {
  const busy = () => lossy((number, response) => {
    if (number > 2) return response;
    const problem = { title: 'The queue is full', status: 429, detail: 'later' };
    return new Response(JSON.stringify(problem), { status: 429, headers: { 'retry-after': '0' } });
  });
  assert.ok((await busy().client().minimalSurface([TENT])).statistics.converged);
  await assert.rejects(busy().client({ patienceMs: 0 }).minimalSurface([TENT]), Busy);
});

test('a server that is not there, and an answer without a problem document', async () => {
  await assert.rejects(new Plateau({ url: 'http://127.0.0.1:9', patienceMs: 200 }).limits(), ConnectionFailed);
  const { client: make } = lossy(() => new Response('<html>', { status: 401 }));
  await assert.rejects(make().limits(), Unauthorized);
});
