// The WebAssembly modules give the results of `plateau solve` on every example.
//
// PLATEAU_MODULES names the folder of the modules (default: crates/page/js), PLATEAU_BIN the program.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, readdirSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { load, moduleOf } from '../../crates/page/js/plateau.mjs';

const examples = new URL('../../api/examples/', import.meta.url).pathname;
const { PLATEAU_BIN, PLATEAU_MODULES = new URL('../../crates/page/js/', import.meta.url).pathname } = process.env;
const folder = mkdtempSync(join(tmpdir(), 'plateau-page-'));
after(() => rmSync(folder, { recursive: true }));

const engines = {};
const engine = (name) => (engines[name] ??= load(readFileSync(join(PLATEAU_MODULES, `${name}.wasm`))));

/**
 * Examples whose systems are so large that faer factorises them by supernodes. Its kernels use fused multiply-adds where the
 * processor has them, and WebAssembly has none.
 */
const BY_SUPERNODES = ['conic-tent.json', 'flying-mast.json', 'inflated-disc.json'];
const ROUNDING = 1e-12;

/** Every number of a JSON value with its place. */
function* numbers(value, place = '') {
  if (typeof value === 'number') yield [place, value];
  else if (value !== null && typeof value === 'object') {
    for (const [member, inner] of Object.entries(value)) yield* numbers(inner, `${place}/${member}`);
  }
}

/** Compares two JSON values whose numbers may differ by rounding, relative to the largest number there or to 1. */
function assertNear(found, expected, what) {
  const sorted = (value) => [...numbers(value)].sort(([a], [b]) => (a < b ? -1 : 1));
  const [ours, theirs] = [sorted(found), sorted(expected)];
  const size = Math.max(1, ...theirs.map(([, number]) => Math.abs(number)));
  assert.deepEqual(ours.map(([place]) => place), theirs.map(([place]) => place));
  for (const [k, [place, number]] of ours.entries()) {
    const difference = Math.abs(number - theirs[k][1]);
    assert.ok(difference <= ROUNDING * size, `${what}${place}: ${number} and ${theirs[k][1]}`);
  }
}

for (const name of readdirSync(examples).sort()) {
  test(name, async () => {
    const request = readFileSync(join(examples, name), 'utf8');
    const glb = join(folder, 'native.glb');
    const printed = execFileSync(PLATEAU_BIN, ['solve', join(examples, name), '--output', glb], { stdio: ['ignore', 'pipe', 'ignore'] });
    const native = JSON.parse(printed);
    const solver = await engine(moduleOf(JSON.parse(request)));
    const page = solver.solve(request);
    assert.equal(page.ending, 'solved', page.detail);
    if (BY_SUPERNODES.includes(name)) {
      for (const member of Object.keys(native)) assertNear(page.statistics[member], native[member], member);
      const file = join(folder, 'native.json');
      execFileSync(PLATEAU_BIN, ['solve', join(examples, name), '--output', file], { stdio: 'ignore' });
      const { vertices, triangles } = JSON.parse(readFileSync(file));
      assertNear([...solver.mesh().vertices], vertices.flat(), 'vertices');
      assert.deepEqual([...solver.mesh().triangles], triangles.flat());
      return;
    }
    assert.deepEqual(page.statistics, native);
    assert.ok(Buffer.from(solver.file('glb')).equals(readFileSync(glb)), 'the GLB has other bytes');
  });
}

test('a refused request has the pointer of its wrong value', async () => {
  const solver = await engine('structures');
  const { ending, errors } = solver.solve({ kind: 'cable_net', vertices: [[0, 0, 0], [1, 0, 'x']], edges: [[0, 1]], supports: [0] });
  assert.deepEqual([ending, errors[0].pointer], ['refused', '/vertices/1/2']);
  assert.equal(solver.file('glb'), null);
});

test('progress is reported, and the signal ends a request', async () => {
  const solver = await engine('shapes');
  const request = readFileSync(join(examples, 'helicoid.json'), 'utf8');
  const reports = [];
  const solved = solver.solve(request, { onProgress: (progress) => reports.push(progress) });
  assert.equal(solved.ending, 'solved');
  assert.ok(reports.length > 0 && reports.every(({ fraction, phase }) => fraction >= 0 && fraction <= 1 && phase !== ''));
  assert.equal(solver.solve(request, { signal: () => 1 }).ending, 'cancelled');
});
