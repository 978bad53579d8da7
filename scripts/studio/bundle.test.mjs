// The bundle that the server embeds is what its sources make, and the sources are sound TypeScript.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { readFile, writeFile } from 'node:fs/promises';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

const web = fileURLToPath(new URL('../../web/', import.meta.url));
const run = (program, ...args) => spawnSync(program, args, { cwd: web, encoding: 'utf8' });

test('the committed bundle is what the sources make, byte for byte', () => {
  const { status, stderr } = run('node', 'build.mjs', '--check');
  assert.equal(status, 0, stderr);
});

test('the sources compile without a fault', () => {
  const { status, stdout } = run('node', 'node_modules/typescript/bin/tsc', '--noEmit');
  assert.equal(status, 0, stdout);
});

test('a bundle that differs by one byte is noticed', async () => {
  const file = `${web}dist/studio.css`;
  const bytes = await readFile(file);
  try {
    await writeFile(file, Buffer.concat([bytes, Buffer.from(' ')]));
    const { status, stderr } = run('node', 'build.mjs', '--check');
    assert.equal(status, 1);
    assert.match(stderr, /Stale: dist\/studio\.css/);
  } finally {
    await writeFile(file, bytes);
  }
});
