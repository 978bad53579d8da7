// The bundle that the server embeds is what its sources make, and the sources are sound TypeScript.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { readFile, readdir, writeFile } from 'node:fs/promises';
import { posix } from 'node:path';
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

test('no sources form a circle of imports', async () => {
  const sources = (await readdir(`${web}src`, { recursive: true })).filter((file) => file.endsWith('.ts') && !file.endsWith('.d.ts'));
  const arrows = new Map();
  for (const file of sources) {
    const text = await readFile(`${web}src/${file}`, 'utf8');
    const names = [...text.matchAll(/^(?:import|export) [^;]*?from '(\.[^']+)'/gm)].map(([, name]) => `${posix.join(posix.dirname(file), name)}.ts`);
    arrows.set(file, names.filter((name) => sources.includes(name)));
  }
  assert.ok(arrows.get('main.ts').length > 5, 'the imports were found');
  const done = new Set();
  const visit = (file, path) => {
    assert.ok(!path.includes(file), [...path.slice(path.indexOf(file)), file].join(' -> '));
    if (done.has(file)) return;
    for (const next of arrows.get(file)) visit(next, [...path, file]);
    done.add(file);
  };
  for (const file of sources) visit(file, []);
});
