// Following a job over connections that break, against a server that breaks them where a test says.
import assert from 'node:assert/strict';
import { once } from 'node:events';
import { createServer } from 'node:http';
import { test } from 'node:test';
import { ConnectionFailed, NotFound, Plateau } from 'plateau-client';

const ID = '01JOB';
const job = (status, fraction) => ({ id: ID, status, kind: 'minimal_surface', progress: { phase: 'minimise', fraction }, links: {} });
const FRACTIONS = [0, 0.25, 0.5, 0.75, 1];
/** The events of a job with their ids: queued, three steps, the end. `ü` has two bytes, between which a stream may break. */
const EVENTS = FRACTIONS.map((fraction, index) => {
  const status = ['queued', 'running', 'running', 'running', 'succeeded'][index];
  const named = { ...job(status, fraction), label: 'ü' };
  return { id: `1.${index}`, text: `event: ${fraction % 1 ? 'progress' : 'status'}\nid: 1.${index}\ndata: ${JSON.stringify(named)}\n\n` };
});
/** What the server sends after an event. */
const after = (lastId) => EVENTS.filter(({ id }) => !lastId || id > lastId).map(({ text }) => text).join('');
const BEGINNING = ': open\nretry: 1\n\n';

/**
 * A server with one job. `events` answers each request of the job's stream, `look` each request of the job itself; both get
 * the response, the request, and how many came before.
 */
async function serve(context, { events, look }, options = {}) {
  const seen = [];
  const http = createServer((request, response) => {
    const isStream = request.url === `/v1/jobs/${ID}/events`;
    const before = seen.filter(({ url }) => url === request.url).length;
    seen.push(request);
    if (isStream) events(response, request, before);
    else if (request.method === 'GET') look(response, request, before);
    else json(response, job('queued', 0), 202);
  });
  await once(http.listen(0, '127.0.0.1'), 'listening');
  context.after(() => {
    http.closeAllConnections();
    http.close();
  });
  const client = new Plateau({ url: `http://127.0.0.1:${http.address().port}`, ...options });
  const asked = (url) => () => seen.filter((request) => request.url === url);
  return { client, seen, streams: asked(`/v1/jobs/${ID}/events`), looks: asked(`/v1/jobs/${ID}`) };
}

function json(response, body, status = 200) {
  response.writeHead(status, { 'Content-Type': 'application/json' }).end(JSON.stringify(body));
}
const stream = (response) => response.writeHead(200, { 'Content-Type': 'text/event-stream' });
/** Sends some bytes and breaks the connection when they are sent. */
const cut = (response, bytes) => stream(response).write(bytes, () => response.destroy());
const running = (response) => json(response, job('running', 0.5));
const ended = (response) => json(response, job('succeeded', 1));

/** Follows the job and notes what is told on the way. */
async function follow(client, control = {}) {
  const told = [];
  const fractions = [];
  const end = await client.waitFor(job('queued', 0), {
    ...control,
    onProgress: ({ fraction }) => fractions.push(fraction),
    onConnection: (connected) => told.push(connected),
  });
  return { end, told, fractions };
}

test('a stream that breaks at any byte is resumed, and every event is told once', async (context) => {
  const whole = Buffer.from(BEGINNING + EVENTS[0].text + EVENTS[1].text);
  let at;
  const { client, seen, streams } = await serve(context, {
    events: (response, { headers }, before) => {
      if (before === 0) cut(response, whole.subarray(0, at));
      else stream(response).end(BEGINNING + after(headers['last-event-id']));
    },
    look: running,
  });
  for (at = BEGINNING.length; at <= whole.length; at += 1) {
    seen.length = 0;
    const { end, told, fractions } = await follow(client);
    assert.equal(end.status, 'succeeded');
    assert.deepEqual(fractions, FRACTIONS, `cut after ${at} bytes`);
    assert.deepEqual(told, [false, true]);
    assert.equal(streams().length, 2);
  }
});

test('the next stream begins after the last event, and not before the time that the server asked for', async (context) => {
  let opened, cutAt, againAt;
  const { client, streams } = await serve(context, {
    events: (response, { headers }, before) => {
      if (before === 0) (opened = stream(response)).write(`retry: 300\n\n${EVENTS[0].text}${EVENTS[1].text}`);
      else {
        againAt = performance.now();
        stream(response).end(after(headers['last-event-id']));
      }
    },
    look: running,
  });
  const fractions = [];
  const end = await client.waitFor(job('queued', 0), {
    onProgress: ({ fraction }) => {
      fractions.push(fraction);
      if (fraction !== FRACTIONS[1]) return;
      cutAt = performance.now();
      opened.destroy();
    },
  });
  assert.equal(end.status, 'succeeded');
  assert.deepEqual(streams().map(({ headers }) => headers['last-event-id']), [undefined, EVENTS[1].id]);
  assert.deepEqual(fractions, FRACTIONS);
  assert.ok(againAt - cutAt > 290, `${againAt - cutAt} ms`);
});

test('an end that was told while the line was broken is found', async (context) => {
  const { client, streams } = await serve(context, { events: (response) => cut(response, BEGINNING + EVENTS[0].text), look: ended });
  const { end, told, fractions } = await follow(client);
  assert.equal(end.status, 'succeeded');
  assert.deepEqual([told, fractions.at(-1), streams().length], [[false, true], 1, 1]);
});

test('204 says that no event follows: no stream is opened again', async (context) => {
  const { client, streams } = await serve(context, { events: (response) => response.writeHead(204).end(), look: ended });
  const { end, told } = await follow(client);
  assert.equal(end.status, 'succeeded');
  assert.deepEqual([told, streams().length], [[], 1]);
});

test('where streams do not pass, the job is asked for', async (context) => {
  const blocks = {
    refused: (response) => json(response, { title: 'no streams here' }, 502),
    'answered with a page': (response) => response.writeHead(200, { 'Content-Type': 'text/html' }).end('<p>Sign in'),
    'closed at once': (response) => stream(response).end(),
    'broken at once': (response) => response.destroy(),
  };
  const late = (response, _, before) => (before < 2 ? running : ended)(response);
  await Promise.all([
    ...Object.entries(blocks).map(async ([name, events]) => {
      const { client, streams } = await serve(context, { events, look: late });
      const { end, fractions } = await follow(client);
      assert.deepEqual([end.status, streams().length, fractions], ['succeeded', 2, [0.5, 1]], name);
    }),
    (async () => {
      const { client, streams } = await serve(context, { events: () => undefined, look: ended });
      const { end, told } = await follow(client);
      assert.deepEqual([end.status, streams().length, told], ['succeeded', 1, [false, true]], 'never answered');
    })(),
  ]);
});

test('a server that is back after some failures is used again', async (context) => {
  const { client, streams, looks } = await serve(context, {
    events: (response, { headers }, before) => (before === 0 ? cut(response, BEGINNING + EVENTS[0].text) : stream(response).end(after(headers['last-event-id']))),
    look: (response, _, before) => [
      () => response.destroy(),
      () => response.writeHead(503, { 'Retry-After': '0' }).end(),
      () => response.writeHead(200, { 'Content-Type': 'application/json' }).write('{"id":', () => response.destroy()),
      () => running(response),
    ][before](),
  });
  const { end, told } = await follow(client);
  assert.equal(end.status, 'succeeded');
  assert.deepEqual([told, looks().length, streams().length], [[false, true], 4, 2]);
});

test('a server that is lost: the error names the job, which is not cancelled', async (context) => {
  const { client, looks, seen } = await serve(context, {
    events: (response) => cut(response, BEGINNING + EVENTS[0].text),
    look: (response) => response.destroy(),
  }, { patienceMs: 500 });
  const solved = client.solve({ kind: 'minimal_surface', boundaries: [[[0, 0, 0], [1, 0, 0], [0, 1, 0]]] });
  const error = await solved.catch((reason) => reason);
  assert.ok(error instanceof ConnectionFailed, String(error));
  assert.match(error.message, /job 01JOB goes on at the server, and `client\.resume\('01JOB'\)` comes back to it/);
  assert.deepEqual([error.job.id, error.jobId], [ID, ID]);
  assert.ok(looks().length > 2);
  assert.ok(!seen.some(({ url }) => url.endsWith('/cancel')));
});

test('a job that is gone is an error at once', async (context) => {
  const gone = (response) => json(response, { title: 'Not found', detail: 'there is no such job', status: 404 }, 404);
  const { client, looks } = await serve(context, { events: gone, look: gone });
  await assert.rejects(follow(client), NotFound);
  assert.equal(looks().length, 1);
});

test('an aborted signal ends the wait wherever it is', async (context) => {
  const places = {
    'on a stream that has begun': [(response) => stream(response).write(BEGINNING), running],
    'on a stream that has not begun': [() => undefined, running],
    'on a look': [(response) => stream(response).end(), () => undefined],
    'in the pause before a stream': [(response) => cut(response, `retry: 60000\n\n${EVENTS[0].text}`), running],
  };
  for (const [place, [events, look]] of Object.entries(places)) {
    const controller = new AbortController();
    const reason = new Error('enough');
    const inPause = place.startsWith('in the pause');
    const { client, seen } = await serve(context, {
      events: (response) => {
        events(response);
        if (place.startsWith('on a stream')) setImmediate(() => controller.abort(reason));
      },
      look: (response) => {
        response.on('finish', () => inPause && setImmediate(() => controller.abort(reason)));
        look(response);
        if (place === 'on a look') setImmediate(() => controller.abort(reason));
      },
    });
    await assert.rejects(follow(client, { signal: controller.signal }), reason, place);
    const before = seen.length;
    await new Promise((resolve) => { setImmediate(resolve); });
    assert.equal(seen.length, before, 'nothing is asked any more');
  }
  const { client, seen } = await serve(context, { events: () => undefined, look: running });
  await assert.rejects(follow(client, { signal: AbortSignal.abort(new Error('before')) }), /before/);
  assert.equal(seen.length, 0);
});

test('a fault of the caller comes through', async (context) => {
  const { client, streams } = await serve(context, { events: (response) => stream(response).end(after(null)), look: running });
  const own = new TypeError('my own fault');
  await assert.rejects(client.waitFor(job('queued', 0), { onProgress: () => { throw own; } }), own);
  assert.equal(streams().length, 1);
});
