// The bundle that the server embeds is what its sources make, and the sources are sound TypeScript.

import assert from 'node:assert/strict';
import { execFile, spawnSync } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { readFile, readdir } from 'node:fs/promises';
import { posix } from 'node:path';
import { fileURLToPath } from 'node:url';
import { promisify } from 'node:util';
import { test } from './harness.mjs';

const web = fileURLToPath(new URL('../../web/', import.meta.url));
const run = (program, ...args) => spawnSync(program, args, { cwd: web, encoding: 'utf8' });

test.quick('the committed bundle is what the sources make, byte for byte', () => {
  const { status, stderr } = run('node', 'build.mjs', '--check');
  assert.equal(status, 0, stderr);
});

/**
 * Most bytes of the first view before they are compressed: those of 2026-11-27. What the first film does not need comes
 * after it (`later.ts`).
 */
const MOST_FIRST_VIEW = 810_751;

test.quick('the first view has no more bytes than it had', async () => {
  const files = await Promise.all(['index.html', 'studio.css', 'studio.js', 'chunk.js'].map((name) => readFile(`${web}dist/${name}`)));
  const bytes = files.reduce((sum, file) => sum + file.length, 0);
  assert.ok(bytes <= MOST_FIRST_VIEW, `${bytes} bytes of page, looks and script before the first film`);
});

test.quick('the sources compile without a fault', async () => {
  await promisify(execFile)('node', ['node_modules/typescript/bin/tsc', '--noEmit'], { cwd: web }).catch(({ stdout, message }) => assert.fail(stdout || message));
});

test('a bundle that differs by one byte is noticed', () => {
  const file = `${web}dist/studio.css`;
  const bytes = readFileSync(file);
  // No other test of this process reads the file meanwhile, because nothing here waits.
  try {
    writeFileSync(file, Buffer.concat([bytes, Buffer.from(' ')]));
    const { status, stderr } = run('node', 'build.mjs', '--check');
    assert.equal(status, 1);
    assert.match(stderr, /Stale: dist\/studio\.css/);
  } finally {
    writeFileSync(file, bytes);
  }
});

test.quick('no sources form a circle of imports', async () => {
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
