// The committed modules are those of built.json. They are built anew when an issue is resolved and before a release, and not with
// every commit: between, this test only says how old they are.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { readFileSync, readdirSync } from 'node:fs';
import { test } from '../studio/harness.mjs';
import { hashOfSources, root, SOURCES } from './sources.mjs';

const folder = `${root}crates/page/js/`;
const built = JSON.parse(readFileSync(`${folder}built.json`, 'utf8'));
/** Most bytes of the module for films, strips and lattices, as Brotli has them. */
const MOST_BROTLI = 800_000;
const git = (...words) => execFileSync('git', words, { cwd: root, encoding: 'utf8' }).trim();

test.quick('the committed modules are those whose hashes are committed with them', () => {
  const files = readdirSync(folder).filter((file) => file.endsWith('.wasm'));
  assert.deepEqual(files.sort(), Object.keys(built.modules).map((name) => `${name}.wasm`).sort());
  for (const [name, { sha256 }] of Object.entries(built.modules)) {
    assert.equal(createHash('sha256').update(readFileSync(`${folder}${name}.wasm`)).digest('hex'), sha256, `${name}.wasm: run scripts/build-page`);
  }
  assert.ok(built.modules.shapes.brotli <= MOST_BROTLI, `shapes.wasm has ${built.modules.shapes.brotli} bytes as Brotli`);
});

test('how old the committed modules are', (t) => {
  if (hashOfSources() === built.sources) {
    t.diagnostic('the modules are built from these sources');
    return;
  }
  let age = 'from other sources';
  try {
    const since = git('log', '-1', '--format=%H', '--', 'crates/page/js/built.json');
    const count = git('rev-list', '--count', `${since}..HEAD`, '--', ...SOURCES);
    age = `${count} commits older than these sources`;
  } catch {
    // An archive of the sources has no history.
  }
  t.diagnostic(`the modules are ${age}: scripts/build-page builds them anew`);
});
