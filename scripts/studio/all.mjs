// Runs every test of the studio and of plateau-page in one process, so that the files share a browser and two servers:
// CHROMIUM=… PLATEAU_BIN=… node --test scripts/studio/all.mjs. With PLATEAU_QUICK=1 it runs one or two tests of each file.

import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { describe } from 'node:test';
import { test } from './harness.mjs';

const folder = (path, names) => readdirSync(new URL(path, import.meta.url)).filter((name) => names.test(name)).map((name) => `${path}${name}`);
// The longest files come first, so that the two that run side by side end together.
const LONGEST = ['./layout.test.mjs', './editing.test.mjs', './monkey.test.mjs', './tensile.test.mjs'];
const files = [...new Set([...LONGEST, ...folder('./', /\.test\.mjs$/), ...folder('../page/', /^b.*\.test\.mjs$/)])];
/** Random presses find faults of every kind, but not in a few seconds. */
const WITHOUT_QUICK = ['./monkey.test.mjs'];

test.quick('each file has a test of the quick tier', () => {
  assert.deepEqual(files.filter((file) => !readFileSync(new URL(file, import.meta.url), 'utf8').includes('test.quick')), WITHOUT_QUICK);
});

// Two files at a time, each with a server for itself; a server that PLATEAU_URL names has one file at a time.
describe('files', { concurrency: process.env.PLATEAU_URL ? 1 : 2 }, () => {
  for (const file of files) describe(file.replace('.test.mjs', ''), { concurrency: 1 }, async () => { await import(file); });
});
