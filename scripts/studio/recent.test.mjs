// The list of recent jobs: each with its name and its picture, and none that nobody asked for.

import assert from 'node:assert/strict';
import { apply, atRest, request, solved, test, useStudio } from './harness.mjs';

const studio = useStudio();
const jobs = async () => (await (await fetch(`${studio.url}/v1/jobs?limit=100`)).json()).jobs;

/** The rows of the list: name, share of the picture that is drawn, and the width of its colours. */
async function rows(page) {
  await page.click('#open-recent');
  await page.locator('#recent-list table').waitFor();
  await page.waitForFunction(() => [...document.querySelectorAll('#recent-list img')].every((image) => image.complete));
  const found = await page.locator('#recent-list tr').evaluateAll((all) => all.map((row) => {
    const image = row.querySelector('img');
    let tones = 0;
    if (image) {
      const context = Object.assign(document.createElement('canvas'), { width: 72, height: 48 }).getContext('2d');
      context.drawImage(image, 0, 0, 72, 48);
      const { data } = context.getImageData(0, 0, 72, 48);
      tones = new Set(Array.from({ length: data.length / 4 }, (_, i) => data[4 * i + 3] > 200 && data[4 * i] >> 4)).size;
    }
    return { name: row.querySelector('th').textContent, tones };
  }));
  await page.click('#recent [data-close]');
  return found;
}

test.quick('recent jobs have a name and a picture, and open again', async () => {
  const { page } = studio;
  await studio.open('tent');
  await page.waitForFunction(() => document.querySelector('#options').childElementCount > 0);
  await atRest(page);
  await apply(page, { boundaries: [[[1, 1, 1], [7, 1, 2], [7, 7, 1], [1, 7, 2], [-2, 3, 1]]], resolution: { triangles: 400 } });
  await solved(page);
  await page.waitForFunction(() => !window.studio.shown().job.startsWith('page-'));
  await atRest(page);
  const [mine, tent] = await rows(page);
  assert.equal(mine.name, 'Film: 1 line, 5 points', 'a drawing without a name says what is drawn');
  assert.match(tent.name, /^A tent over a square/);
  for (const { name, tones } of [mine, tent]) assert.ok(tones > 4, `${name} has a picture of ${tones} tones`);
  const now = await request(page);
  await page.click('#open-recent');
  await page.locator('#recent-list tr', { hasText: 'A tent over a square' }).locator('button').first().click();
  await solved(page);
  assert.notDeepEqual(await request(page), now);
});

test('a comparison leaves no job with the service', async () => {
  const { page } = studio;
  await studio.open('wavy-strip');
  await page.waitForFunction(() => window.studio.solvesHere());
  const before = (await jobs()).map(({ id }) => id);
  await page.click('[data-mode="compare"]');
  await page.waitForFunction(() => document.querySelectorAll('.tile dl').length >= 5);
  assert.deepEqual((await jobs()).map(({ id }) => id), before);
});
