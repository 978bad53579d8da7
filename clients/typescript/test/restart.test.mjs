// The server is killed while clients wait for their jobs, and is started again on the same data.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { setTimeout as sleep } from 'node:timers/promises';
import { ConnectionFailed, Plateau } from 'plateau-client';
import { until } from './hold.mjs';
import { startServer } from './server.mjs';

const DOWN_S = process.env.PLATEAU_FULL === '1' ? [8, 30] : [5];
/** A job of a killed server is taken up again when its lease is over, which lasts 15 s otherwise. */
const SETTINGS = { PLATEAU_JOBS__LEASE_MS: '2000' };

const small = (shift) => ({
  kind: 'minimal_surface', boundaries: [[[0, 0, shift], [8, 0, 3], [8, 8, 0], [0, 8, 3]]],
  resolution: { triangles: 200 }, cache: 'bypass',
});

async function ids(client) {
  const found = [];
  for await (const job of client.jobs()) found.push(job.id);
  return found.sort();
}

for (const downS of DOWN_S) {
  test(`a server killed for ${downS} s gives the same job's result after its restart`, async (context) => {
    const server = await startServer(SETTINGS);
    context.after(server.stop);
    const seen = [];
    await server.hold.at('claimed');
    const waiting = [
      new Plateau(server.url).solve(small(0.1)),
      new Plateau(server.url).solve(small(0.2), { onProgress: ({ fraction }) => seen.push(fraction) }),
      new Plateau(server.url).submitBatch([small(0.3)]).then(async (batch) => (await batch.wait())[0]),
    ];
    const all = Promise.all(waiting);
    all.catch(() => undefined); // awaited below
    const other = new Plateau(server.url);
    await until('all are held', async () => (await ids(other)).length === 3 && server.hold.holdsOne());
    const submitted = await ids(other);
    await server.kill();
    await sleep(1000 * downS);
    await server.hold.release('claimed');
    await server.restart();
    const started = performance.now();
    const films = await all;
    context.diagnostic(`the results came ${((performance.now() - started) / 1000).toFixed(1)} s after the restart`);
    assert.deepEqual(films.map(({ id }) => id).sort(), submitted);
    assert.deepEqual(await ids(other), submitted);
    assert.deepEqual(films.map(({ vertices }) => vertices[2]), [0.1, 0.2, 0.3]);
    assert.equal(seen.at(-1), 1);
  });
}

test('an error carries the job, and a call resumes it', async (context) => {
  const server = await startServer(SETTINGS);
  context.after(server.stop);
  const client = new Plateau({ url: server.url, patienceMs: 300 });
  await server.hold.at('claimed');
  const job = await client.submit(small(0.3));
  const lost = [job.wait(), client.solve(small(0.4), { onProgress: () => undefined })].map((one) => one.catch((error) => error));
  await until('both are held', async () => (await ids(client)).length === 2 && server.hold.holdsOne());
  const submitted = await ids(client);
  await server.kill();
  const errors = await Promise.all(lost);
  assert.ok(errors.every((error) => error instanceof ConnectionFailed && error.message.includes(error.jobId)), String(errors));
  assert.deepEqual(errors.map(({ jobId }) => jobId).sort(), submitted);
  const unanswered = await client.submit(small(0.5), { idempotencyKey: 'mine' }).catch((error) => error);
  assert.deepEqual([unanswered.jobId, unanswered.idempotencyKey], [undefined, 'mine']);
  await server.hold.release('claimed');
  await server.restart();
  for (const { jobId } of errors) {
    const film = await new Plateau(server.url).resume(jobId);
    assert.ok(film.id === jobId && film.statistics.converged);
  }
});
