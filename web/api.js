// The service's HTTP interface, as far as the studio needs it. Paths are relative, so that the page works behind a prefix.

/** A problem document (RFC 9457), or a failure to reach the server put in the same words. */
export class Problem extends Error {
  constructor({ title, detail, errors = [], errors_omitted = false, status = 0 }) {
    super(detail || title);
    Object.assign(this, { title, detail, errors, omitted: errors_omitted, status });
  }
}

let key = '';
export const setKey = (value) => { key = value; };

// The folder of this page. Links of the server begin with it if the server was told of it; other paths are completed.
const base = new URL('.', document.baseURI).pathname;
const at = (path) => (path.startsWith(base) ? path : base + path.replace(/^\//, ''));

async function ask(path, options = {}) {
  const headers = { ...(key && { Authorization: `Bearer ${key}` }), ...options.headers };
  let response;
  try {
    response = await fetch(at(path), { ...options, headers });
  } catch {
    throw new Problem({ title: 'The server cannot be reached', detail: 'Is it still running? Nothing was lost; try again.' });
  }
  if (response.ok) return response;
  const text = await response.text();
  let document;
  try {
    document = JSON.parse(text);
  } catch {
    document = { title: `The server answered ${response.status}`, detail: text.slice(0, 300) };
  }
  throw new Problem({ ...document, status: response.status });
}

export const getJson = async (path) => (await ask(path)).json();
export const getBytes = async (path) => (await ask(path)).arrayBuffer();
export const getBlob = async (path) => (await ask(path)).blob();

/** Posts a request and gives its job. */
export async function submit(path, request) {
  const headers = { 'Content-Type': 'application/json' };
  return (await ask(path, { method: 'POST', headers, body: JSON.stringify(request) })).json();
}

export const cancel = async (job) => (await ask(job.links.cancel, { method: 'POST' })).json();
export const remove = (job) => ask(job.links.self, { method: 'DELETE' });

const ENDED = ['succeeded', 'failed', 'cancelled'];
export const hasEnded = (job) => ENDED.includes(job.status);

/**
 * Follows a job's events until it ends, and gives the job as it ended. Not EventSource, which can send no API key. A stream
 * that breaks is taken up again where it stopped.
 */
export async function follow(job, onProgress) {
  let last = null;
  for (let attempt = 0; ; attempt += 1) {
    try {
      const headers = { Accept: 'text/event-stream', ...(last && { 'Last-Event-ID': last }) };
      const response = await ask(job.links.events, { headers });
      for await (const event of events(response)) {
        attempt = 0;
        last = event.id ?? last;
        const data = JSON.parse(event.data);
        if (data.progress) onProgress(data);
        if (hasEnded(data) && data.links) return data;
      }
    } catch (error) {
      if ((error.status >= 400 && error.status < 500) || attempt >= 5) throw error;
    }
    const now = await getJson(job.links.self);
    if (hasEnded(now)) return now;
    await new Promise((resolve) => { setTimeout(resolve, 300 * (attempt + 1)); });
  }
}

/** Server-sent events of a response, one object each: { id, event, data }. */
async function* events(response) {
  if (!response.body || response.status === 204) return;
  const reader = response.body.pipeThrough(new TextDecoderStream()).getReader();
  let text = '';
  for (;;) {
    const { value, done } = await reader.read();
    if (done) return;
    text += value.replaceAll('\r\n', '\n');
    const blocks = text.split('\n\n');
    text = blocks.pop();
    for (const block of blocks) {
      const event = {};
      for (const line of block.split('\n')) {
        const [, name, rest] = /^([^:]*):? ?(.*)$/s.exec(line);
        if (name === 'data') event.data = event.data === undefined ? rest : `${event.data}\n${rest}`;
        else if (name) event[name] = rest;
      }
      if (event.data !== undefined) yield event;
    }
  }
}
