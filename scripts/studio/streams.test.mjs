// The page behind a proxy that breaks connections: what is solved is shown, and a late answer hides nothing.

import assert from 'node:assert/strict';
import { after, before, beforeEach } from 'node:test';
import { apply, lacksOwnServer, request, solved, test, useStudio } from './harness.mjs';
import { until } from '../../clients/typescript/test/hold.mjs';
import { startProxy } from './proxy.mjs';

const studio = useStudio();
let proxy;
before(async () => { proxy = await startProxy(() => studio.url); });
after(() => proxy.stop());
beforeEach(() => {
  studio.allowed.push(proxy.url);
  proxy.seen = [];
  // Answers do not wait for a job's end: every solve is followed by its stream.
  proxy.meddle = ({ headers }) => { delete headers.prefer; };
});

const STATUS = '#status';
const INTERRUPTED = 'Connection interrupted, the job goes on, reconnecting';
const isStream = ({ url }) => url.endsWith('/events');
const streams = () => proxy.seen.filter(isStream);
const isSubmission = ({ method, url }) => method === 'POST' && url === '/v1/minimal-surfaces';
/** A film of its own for each solve, which no stored result is reused for. */
let films = 0;
const film = () => {
  films += 1;
  const height = 3 + films / 100;
  return { boundaries: [[[0, 0, 0], [8, 0, height], [8, 8, 0], [0, 8, height]]], resolution: { triangles: 2000 }, cache: 'bypass' };
};
/** A promise and the function that fulfils it. */
function gate() {
  let open;
  const opened = new Promise((resolve) => { open = resolve; });
  return { opened, open };
}
/** Applies a rule to the first request for which a condition holds; the others are passed on. */
const onFirst = (condition, rule) => {
  let used = false;
  const before = proxy.meddle;
  proxy.meddle = (incoming) => {
    before(incoming);
    if (used || !condition(incoming)) return undefined;
    used = true;
    return rule;
  };
};
const open = async () => {
  await studio.page.goto(`${proxy.url}/?example=tent`);
  await solved(studio.page);
  proxy.seen = [];
};
/** Waits until the page rests, and expects that it shows the result of what is drawn. */
const endsWith = async (wanted) => {
  const { page } = studio;
  await page.waitForFunction(() => document.body.getAttribute('aria-busy') === 'false');
  assert.match(await page.textContent(STATUS), /^Solved/, await page.textContent('#problem'));
  assert.deepEqual(await request(page), wanted);
  await solved(page);
};
const said = (text) => studio.page.waitForFunction(([at, part]) => document.querySelector(at).textContent.includes(part), [STATUS, text]);

const CUTS = {
  'before its first byte': /^/,
  'within its first event': /^[^]*?data: [^]{40}/,
  'after its first event': /^[^]*?data: [^]*?\n\n/,
};
for (const [where, cut] of Object.entries(CUTS)) {
  const register = where === 'within its first event' ? test.quick : test;
  register(`a stream that is cut ${where} ends with the result`, async () => {
    const { page } = studio;
    await open();
    onFirst(isStream, { cut });
    const wanted = film();
    await apply(page, wanted);
    await endsWith(wanted);
    assert.equal(await page.isVisible('#problem'), false);
    assert.ok(streams().length >= 1, 'there was a stream to cut');
    assert.equal(proxy.seen.filter(isSubmission).length, 1, 'nothing is solved twice');
  });
}

test('a stream that is never answered ends with the result', async () => {
  const { page } = studio;
  await open();
  const { meddle } = proxy;
  proxy.meddle = (incoming) => (isStream(incoming) ? 'silence' : meddle(incoming));
  const wanted = film();
  await apply(page, wanted);
  await endsWith(wanted);
  assert.equal(await page.isVisible('#problem'), false);
});

test('while the line is broken the page says that the job goes on, and then it resumes from the last event', async (t) => {
  if (lacksOwnServer(t)) return;
  const { page, hold } = studio;
  await open();
  const { meddle } = proxy;
  /** Breaks the line; `mend` lets what was asked meanwhile pass. */
  const breakLine = () => {
    const mended = gate();
    proxy.meddle = () => mended.opened;
    proxy.breakAll();
    return { mend: () => { proxy.meddle = meddle; mended.open(); } };
  };
  // Every step is told, and the second half never comes.
  for (const stage of ['each_progress', 'half']) await hold.at(stage);
  await apply(page, film());
  await said('iteration');
  const line = breakLine();
  await said(INTERRUPTED);
  assert.equal(await page.isVisible('#problem'), false, 'an interruption is no problem');
  assert.equal(await page.getAttribute('body', 'aria-busy'), 'true');
  line.mend();
  await said('iteration');
  const [first, second] = streams();
  assert.equal(first.headers['last-event-id'], undefined);
  assert.match(second.headers['last-event-id'], /^1\.\d+$/);
  assert.equal(second.url, first.url);

  // A reload while the line is broken finds the same job again.
  const again = breakLine();
  await said(INTERRUPTED);
  again.mend();
  await page.goto(`${proxy.url}/`);
  await said('iteration');
  assert.ok(streams().every(({ url }) => url === first.url));
  await page.click('#cancel');
  await said('Cancelled.');
  const job = await (await fetch(`${studio.url}${first.url.replace('/events', '')}`)).json();
  assert.equal(job.status, 'cancelled');
});

test('a new solve does not wait for a job whose line is silent', async (t) => {
  if (lacksOwnServer(t)) return;
  const { page, hold } = studio;
  await open();
  onFirst(isStream, 'silence');
  await hold.at('claimed');
  await apply(page, film());
  await page.waitForFunction(() => /Running|queue/.test(document.querySelector('#status').textContent));
  await until('the stream is asked for', () => streams().length > 0);
  const [{ url }] = streams();
  const wanted = film();
  await apply(page, wanted);
  const ended = await fetch(`${studio.url}${url.replace('/events', '')}`, { headers: { Prefer: 'wait=60' } });
  assert.equal((await ended.json()).status, 'cancelled', 'the job that nobody wants any more');
  await hold.release('claimed');
  await endsWith(wanted);
});

test('the late answer to a submission does not hide a newer error', async () => {
  const { page } = studio;
  await open();
  const late = gate();
  onFirst(isSubmission, late.opened);
  const wanted = film();
  await apply(page, wanted);
  const { meddle } = proxy;
  // The page asks for itself until the service is back.
  proxy.meddle = (incoming) => (incoming.url === '/v1/examples/vault' || incoming.method === 'HEAD' ? 'break' : meddle(incoming));
  await page.click('#open-gallery');
  await page.click('#gallery [data-example="vault"]');
  await page.locator('#problem').waitFor();
  assert.match(await page.textContent('#problem'), /cannot be reached/);
  late.open();
  await endsWith(wanted);
  assert.equal(await page.isVisible('#problem'), true, 'the newer error is still there');
  assert.match(await page.textContent('#problem'), /cannot be reached/);
  proxy.meddle = meddle;
  await page.locator('#problem').waitFor({ state: 'hidden' });
  assert.match(await page.textContent(STATUS), /^Solved/, 'the result keeps its line when the service is back');
});

test('the late failure of a solve does not hide the error of a newer one', async () => {
  const { page } = studio;
  await open();
  const late = gate();
  onFirst(isSubmission, late.opened.then(() => 'break'));
  await apply(page, film());
  await apply(page, { boundaries: [[[0, 0, 0], [8, 0, 'high'], [8, 8, 0]]] });
  await page.locator('#problem').waitFor();
  const text = await page.textContent('#problem');
  assert.match(text, /point 2/i);
  late.open();
  await page.waitForFunction(() => document.body.getAttribute('aria-busy') === 'false');
  assert.equal(await page.textContent('#problem'), text);
  assert.equal(await page.textContent(STATUS), 'Not solved.');
});
