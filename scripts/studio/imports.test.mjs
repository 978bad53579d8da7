// Drawings of other programs open right: files/files.json says the unit and the size of each, and whether the file leaves its unit open.

import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { fileURLToPath } from 'node:url';
import { test } from 'node:test';
import { points, request, solved, useStudio } from './harness.mjs';

const studio = useStudio();
const folder = fileURLToPath(new URL('files/', import.meta.url));
const table = JSON.parse(await readFile(`${folder}files.json`, 'utf8'));

const open = async (page, name) => {
  await page.evaluate(() => document.querySelector('#card')?.remove());
  await page.setInputFiles('#file', `${folder}${name}`);
  await page.locator('#card:not([hidden]), #problem:not([hidden])').first().waitFor();
  await page.waitForFunction(() => document.body.getAttribute('aria-busy') === 'false');
};
const found = (page) => page.evaluate(() => {
  const card = document.querySelector('#card');
  if (!card) return { problem: document.querySelector('#problem').textContent };
  return {
    asks: card.querySelector('.asks') !== null, unit: card.querySelector('[data-field="unit"]').value, size: card.querySelector('.size').textContent,
    lines: window.studio.request().boundaries.length, points: window.studio.request().boundaries.reduce((sum, line) => sum + line.length, 0),
    layers: [...card.querySelectorAll('.layers label')].map((label) => label.textContent), notes: [...card.querySelectorAll('p.small')].slice(1).map((note) => note.textContent),
  };
});

test('drawings of other programs open in their unit and size, and ask exactly where they name no unit', async () => {
  const { page } = studio;
  await studio.open('tent');
  await page.uncheck('#live');
  const wrong = [];
  for (const { file, ...expected } of table) {
    await open(page, file);
    const given = await found(page);
    if (process.env.PRINT) console.log(JSON.stringify({ file, ...given }));
    for (const [name, value] of Object.entries(expected)) {
      if (JSON.stringify(given[name]) !== JSON.stringify(value)) wrong.push(`${file}: ${name} is ${JSON.stringify(given[name])}, not ${JSON.stringify(value)}`);
    }
    // The drawing fills the stage: its points do not lie on one pixel.
    const seen = await points(page);
    const spread = Math.max(...seen.map(({ x }) => x)) - Math.min(...seen.map(({ x }) => x));
    if (!(spread > 200) || !seen.every(({ x, y }) => x > 0 && y > 0 && x < 960 && y < 720)) wrong.push(`${file}: its points span ${Math.round(spread)} pixels of the stage`);
  }
  assert.deepEqual(wrong, []);
});
