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

/** The largest difference between two JSON values, relative to the numbers of the list or the object that they are in. */
function difference(a, b, place = '') {
  if (typeof a === 'number' && typeof b === 'number') {
    return { size: a === b ? 0 : Math.abs(a - b) / Math.max(Math.abs(a), Math.abs(b)), place, a, b };
  }
  if (a === null || b === null || typeof a !== 'object' || typeof b !== 'object') {
    return { size: a === b ? 0 : Infinity, place, a, b };
  }
  const members = new Set([...Object.keys(a), ...Object.keys(b)]);
  const found = [...members].map((member) => difference(a[member], b[member], `${place}/${member}`));
  return found.reduce((worst, next) => (next.size > worst.size ? next : worst), { size: 0, place });
}

for (const name of readdirSync(examples).sort()) {
  test(name, () => {
    const request = readFileSync(join(examples, name), 'utf8');
    const glb = join(folder, 'native.glb');
    const printed = execFileSync(PLATEAU_BIN, ['solve', join(examples, name), '--output', glb], { stdio: ['ignore', 'pipe', 'ignore'] });
    const native = JSON.parse(printed);
    const page = engine.solve(request);
    assert.equal(page.ending, 'solved', page.detail);
    const worst = difference(page.statistics, native);
    const bytes = Buffer.compare(Buffer.from(engine.file('glb')), readFileSync(glb)) === 0;
    console.log(`${name}: ${worst.size === 0 ? 'statistics equal' : `${worst.size} at ${worst.place}: ${worst.a} ${worst.b}`}, GLB ${bytes ? 'equal' : 'DIFFERS'}`);
  });
}
