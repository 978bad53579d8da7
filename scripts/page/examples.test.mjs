// The WebAssembly module gives the results of `plateau solve` on every example.
//
// PLATEAU_WASM names the module (scripts/build-page), PLATEAU_BIN the program.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, readdirSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { load } from '../../crates/page/js/plateau.mjs';

const examples = new URL('../../api/examples/', import.meta.url).pathname;
const { PLATEAU_BIN, PLATEAU_WASM } = process.env;
const folder = mkdtempSync(join(tmpdir(), 'plateau-page-'));
after(() => rmSync(folder, { recursive: true }));

let engine;
before(async () => {
  engine = await load(readFileSync(PLATEAU_WASM));
});

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
  test(name, () => {
    const request = readFileSync(join(examples, name), 'utf8');
    const glb = join(folder, 'native.glb');
    const printed = execFileSync(PLATEAU_BIN, ['solve', join(examples, name), '--output', glb], { stdio: ['ignore', 'pipe', 'ignore'] });
    const native = JSON.parse(printed);
    const page = engine.solve(request);
    assert.equal(page.ending, 'solved', page.detail);
    if (BY_SUPERNODES.includes(name)) {
      for (const member of Object.keys(native)) assertNear(page.statistics[member], native[member], member);
      const file = join(folder, 'native.json');
      execFileSync(PLATEAU_BIN, ['solve', join(examples, name), '--output', file], { stdio: 'ignore' });
      const { vertices, triangles } = JSON.parse(readFileSync(file));
      assertNear([...engine.mesh().vertices], vertices.flat(), 'vertices');
      assert.deepEqual([...engine.mesh().triangles], triangles.flat());
      return;
    }
    assert.deepEqual(page.statistics, native);
    assert.ok(Buffer.from(engine.file('glb')).equals(readFileSync(glb)), 'the GLB has other bytes');
  });
}

test('a refused request has the pointer of its wrong value', () => {
  const { ending, errors } = engine.solve({ kind: 'cable_net', vertices: [[0, 0, 0], [1, 0, 'x']], edges: [[0, 1]], supports: [0] });
  assert.deepEqual([ending, errors[0].pointer], ['refused', '/vertices/1/2']);
  assert.equal(engine.file('glb'), null);
});

test('progress is reported, and the signal ends a request', () => {
  const request = readFileSync(join(examples, 'helicoid.json'), 'utf8');
  const reports = [];
  const solved = engine.solve(request, { onProgress: (progress) => reports.push(progress) });
  assert.equal(solved.ending, 'solved');
  assert.ok(reports.length > 0 && reports.every(({ fraction, phase }) => fraction >= 0 && fraction <= 1 && phase !== ''));
  assert.equal(engine.solve(request, { signal: () => 1 }).ending, 'cancelled');
});
