// The life of a request: a cancelled one stays cancelled, and an answer changes nothing once a newer request was made.

import assert from 'node:assert/strict';
import { until } from '../../clients/typescript/test/hold.mjs';
import { apply, request, solved, test, useStudio } from './harness.mjs';

const studio = useStudio();

const says = (page, text) => page.waitForFunction((wanted) => document.querySelector('#status').textContent === wanted, text);
const newest = async () => (await (await fetch(`${studio.url}/v1/jobs?limit=1`)).json()).jobs[0];
/** A film that no stored result is used for. */
const film = (height) => ({ boundaries: [[[0, 0, 0], [8, 0, height], [8, 8, 0], [0, 8, height]]], resolution: { triangles: 300 }, cache: 'bypass' });

/** Holds the answers to what the page asks of an address. Gives a promise of the first, and a function that lets all pass. */
async function holdAnswers(page, address, method = 'GET') {
  let release, reached;
  const gate = new Promise((resolve) => { release = resolve; });
  const first = new Promise((resolve) => { reached = resolve; });
  await page.route(address, async (route) => {
    if (route.request().method() !== method) {
      await route.fallback();
      return;
    }
    const response = await route.fetch();
    reached();
    await gate;
    await route.fulfill({ response }).catch(() => {});
  });
  return { first, release };
}

test.quick('a request that was cancelled is not solved again by a reload, but by the button', async () => {
  const { page } = studio;
  await studio.open('tent');
  const { first, release } = await holdAnswers(page, '**/v1/minimal-surfaces', 'POST');
  const wanted = film(3);
  await apply(page, wanted);
  await first;
  const { id } = await newest();
  await page.click('#cancel');
  await says(page, 'Cancelled.');
  assert.equal(await page.isVisible('#cancel'), false);
  release();
  await page.unrouteAll({ behavior: 'wait' });
  await page.goto(`${studio.url}/`);
  await says(page, 'Cancelled.');
  await page.waitForFunction(() => document.body.getAttribute('aria-busy') === 'false');
  assert.deepEqual(await request(page), wanted, 'the drawing is there');
  assert.equal((await newest()).id, id, 'no job was made');
  assert.equal(await page.evaluate(() => window.studio.shown()), null);
  await page.click('#solve');
  await solved(page);
  assert.notEqual((await newest()).id, id);
});

test('a job that is accepted after its request was cancelled is cancelled then', async () => {
  const { page } = studio;
  await studio.open('tent');
  const { first, release } = await holdAnswers(page, '**/v1/minimal-surfaces', 'POST');
  const cancelled = [];
  await page.route('**/v1/jobs/*/cancel', (route) => { cancelled.push(route.request().url()); return route.continue(); });
  await page.route('**/v1/jobs/*', (route) => { if (route.request().method() === 'DELETE') cancelled.push(route.request().url()); return route.fallback(); });
  // The service answers that the job is under way, as it does for a long one.
  await page.route('**/v1/minimal-surfaces', async (route) => {
    const headers = { ...route.request().headers() };
    delete headers.prefer;
    await route.fallback({ headers });
  });
  await apply(page, { ...film(4), resolution: { triangles: 60_000 } });
  await first;
  const { id } = await newest();
  await page.click('#cancel');
  await says(page, 'Cancelled.');
  release();
  await until('the job is cancelled', () => cancelled.some((url) => url.includes(id)));
});

test('the job of the last visit does not replace what was solved while it was looked up', async () => {
  const { page } = studio;
  await studio.open('tent');
  await apply(page, film(3));
  await solved(page);
  const { job: old } = await page.evaluate(() => window.studio.shown());
  await page.waitForFunction((job) => JSON.parse(sessionStorage.getItem('plateau.work'))?.job === job, old);
  const { first, release } = await holdAnswers(page, `**/v1/jobs/${old}`);
  await page.goto(`${studio.url}/`);
  await first;
  const wanted = film(5);
  await apply(page, wanted);
  await solved(page);
  const { job: own } = await page.evaluate(() => window.studio.shown());
  assert.notEqual(own, old);
  release();
  await page.unrouteAll({ behavior: 'wait' });
  await page.waitForFunction(() => document.body.getAttribute('aria-busy') === 'false');
  const { job: now, solved: text } = await page.evaluate(() => window.studio.shown());
  assert.deepEqual([now, JSON.parse(text)], [own, wanted]);
});

test('the example of the address does not replace what was opened while it was fetched', async () => {
  const { page } = studio;
  const { first, release } = await holdAnswers(page, '**/v1/examples/vault');
  await page.goto(`${studio.url}/?example=vault`);
  await first;
  const wanted = film(6);
  await apply(page, wanted);
  await page.waitForFunction(() => window.studio.shown());
  release();
  await page.unrouteAll({ behavior: 'wait' });
  await page.waitForFunction(() => document.body.getAttribute('aria-busy') === 'false');
  assert.deepEqual(await request(page), wanted);
});

test('a job that failed says so again after a reload, and is not solved again', async () => {
  const { page } = studio;
  await studio.open('tent');
  // Cables that are too weak for the film have no equilibrium.
  const cables = [0, 1, 2, 3].map((from) => ({ along: { from, to: (from + 1) % 4 }, value: 1 }));
  await apply(page, {
    kind: 'tensile_structure', boundaries: [[[0, 0, 0], [10, 0, 3], [10, 10, 0], [0, 10, 3]]], film: { tension: 1 }, cables, resolution: { triangles: 300 },
  });
  await says(page, 'Not solved.');
  const { id, status } = await newest();
  assert.equal(status, 'failed');
  const text = await page.textContent('#problem');
  await page.waitForFunction((job) => JSON.parse(sessionStorage.getItem('plateau.work'))?.job === job, id);
  await page.goto(`${studio.url}/`);
  await says(page, 'Not solved.');
  assert.equal(await page.textContent('#problem'), text);
  assert.equal((await newest()).id, id, 'no job was made');
});
