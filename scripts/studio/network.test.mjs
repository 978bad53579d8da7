// The page behind a bad network: each stream is cut after 200 ms, every answer comes late, and the server is started again while a
// job runs. Every job is shown in the end, with one message at most.

import assert from 'node:assert/strict';
import { after, before, beforeEach } from 'node:test';
import { apply, lacksOwnServer, request, solved, startServer, test, useStudio } from './harness.mjs';
import { startProxy } from './proxy.mjs';

const CUT_MS = 200;

const studio = useStudio();
let proxy;
let server;
before(async () => {
  server = await startServer();
  proxy = await startProxy(() => server.url);
});
after(async () => {
  await proxy.stop();
  await server.stop();
});
beforeEach(() => {
  studio.allowed.push(proxy.url);
  proxy.seen = [];
  proxy.meddle = () => undefined;
});

const isStream = ({ url }) => url.endsWith('/events');
const pause = (ms) => new Promise((resolve) => { setTimeout(resolve, ms); });

/** Each problem and each note that the page shows, once. */
const watchMessages = (page) => page.evaluate(() => {
  window.messages = [];
  for (const id of ['problem', 'toast']) {
    const box = document.getElementById(id);
    new MutationObserver(() => { if (!box.hidden && window.messages.at(-1) !== box.textContent) window.messages.push(box.textContent); })
      .observe(box, { attributes: true, childList: true, subtree: true, characterData: true });
  }
});

const film = (height) => ({ boundaries: [[[0, 0, 0], [8, 0, height], [8, 8, 0], [0, 8, height]]], resolution: { triangles: 2000 }, cache: 'bypass' });

/** A test that solves several films whose answers come late, and starts the server again while the last is solved. */
const isShown = (delayMs, heights) => async (t) => {
  if (lacksOwnServer(t)) return;
  const { page } = studio;
  await page.goto(`${proxy.url}/?example=tent`);
  await solved(page);
  await page.waitForFunction(() => document.querySelector('#options').childElementCount > 0);
  await watchMessages(page);
  proxy.meddle = async (incoming) => {
    // Answers do not wait for the end, so that each job has its stream.
    delete incoming.headers.prefer;
    await pause(delayMs);
    return isStream(incoming) ? { cutAfter: CUT_MS } : undefined;
  };
  for (const height of heights) {
    const wanted = film(height);
    // A job that is held at its half outlives several streams, and in the last round the server.
    await server.hold.at('half');
    await apply(page, wanted);
    await page.waitForFunction(() => /Running|iteration|queue|interrupted/.test(document.querySelector('#status').textContent));
    await pause(2 * delayMs);
    if (height === heights.at(-1)) {
      await server.restart();
      proxy.breakAll();
    }
    await server.hold.releaseAll();
    await solved(page);
    assert.deepEqual(await request(page), wanted);
  }
  assert.ok(proxy.seen.filter(isStream).length >= heights.length, 'streams were cut');
  const messages = await page.evaluate(() => window.messages);
  assert.ok(messages.length <= 1, messages.join('\n'));
};

test.quick('a job is shown behind a network that cuts, delays and loses the server, with one message at most', isShown(200, [3.3]));
test('every job is shown where answers come two seconds late, with one message at most', isShown(2000, [3.1, 3.2, 3.3]));
