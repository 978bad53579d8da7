// The service's HTTP interface, as far as the studio needs it. Paths are relative, so that the page works behind a prefix.

import type { components } from './openapi';

type Schemas = components['schemas'];
export type Job = Schemas['Job'];
export type Kind = Schemas['Kind'];
export type Objective = Schemas['ObjectiveList']['objectives'][number];
export type ExampleSummary = Schemas['ExampleSummary'];
export type Limits = Schemas['Limits'];
export type FieldError = Schemas['FieldError'];
export type HistoryRow = Schemas['HistoryRow'];
export type Progress = Schemas['Progress'];

interface ProblemDocument { title?: string; detail?: string; errors?: FieldError[]; errors_omitted?: boolean; status?: number }

/** A problem document (RFC 9457), or a failure to reach the server put in the same words. */
export class Problem extends Error {
  readonly title: string;
  readonly detail: string;
  readonly errors: FieldError[];
  readonly omitted: boolean;
  readonly status: number;

  constructor({ title, detail, errors, errors_omitted, status }: ProblemDocument) {
    super(detail || title);
    this.title = title ?? 'Something went wrong';
    this.detail = detail ?? '';
    this.errors = errors ?? [];
    this.omitted = errors_omitted ?? false;
    this.status = status ?? 0;
  }
}

let key = '';
export const setKey = (value: string): void => { key = value; };
export const hasKey = (): boolean => key !== '';

// The folder of this page, without `studio/` for the page that is embedded elsewhere. Links of the server begin with it if the
// server was told of it; other paths are completed.
const base = new URL('.', document.baseURI).pathname.replace(/studio\/$/, '');
const at = (path: string): string => (path.startsWith(base) ? path : base + path.replace(/^\//, ''));
export const absolute = (path: string): string => new URL(at(path), location.href).href;

async function ask(path: string, options: RequestInit = {}): Promise<Response> {
  const headers = { ...(key && { Authorization: `Bearer ${key}` }), ...(options.headers as Record<string, string>) };
  let response: Response;
  try {
    response = await fetch(at(path), { ...options, headers });
  } catch (error) {
    if (options.signal?.aborted) throw error;
    throw new Problem({ title: 'The server cannot be reached', detail: 'Is it still running? Nothing was lost; try again.' });
  }
  if (response.ok) return response;
  const text = await response.text();
  let document: ProblemDocument;
  try {
    document = JSON.parse(text) as ProblemDocument;
  } catch {
    document = { title: `The server answered ${response.status}`, detail: text.slice(0, 300) };
  }
  throw new Problem({ ...document, status: response.status });
}

export const getJson = async <T>(path: string): Promise<T> => (await ask(path)).json() as Promise<T>;
export const getBytes = async (path: string): Promise<ArrayBuffer> => (await ask(path)).arrayBuffer();
export const getBlob = async (path: string): Promise<Blob> => (await ask(path)).blob();
export const getText = async (path: string): Promise<string> => (await ask(path)).text();

/** Posts a request; the answer waits up to a second, so that a quick job comes back finished. */
export async function submit(path: string, request: unknown): Promise<Job> {
  const headers = { 'Content-Type': 'application/json', Prefer: 'wait=1' };
  return (await ask(path, { method: 'POST', headers, body: JSON.stringify(request) })).json() as Promise<Job>;
}

export const cancel = async (job: Job): Promise<Job> => (await ask(job.links.cancel, { method: 'POST' })).json() as Promise<Job>;
export const remove = async (job: Job): Promise<void> => { await ask(job.links.self, { method: 'DELETE' }); };

export const hasEnded = (job: { status?: string }): boolean => ['succeeded', 'failed', 'cancelled'].includes(job.status ?? '');

/**
 * Follows a job's events until it ends, and gives the job as it ended. EventSource cannot send an API key, so the stream is
 * read by hand. A stream that breaks is taken up again where it stopped.
 */
export async function follow(job: Job, onProgress: (progress: Progress) => void): Promise<Job> {
  let last: string | null = null;
  for (let attempt = 0; ; attempt += 1) {
    try {
      const headers: Record<string, string> = { Accept: 'text/event-stream', ...(last && { 'Last-Event-ID': last }) };
      for await (const event of events(await ask(job.links.events, { headers }))) {
        attempt = 0;
        last = event.id ?? last;
        const data = JSON.parse(event.data) as Partial<Job>;
        if (data.progress) onProgress(data.progress);
        if (hasEnded(data) && data.links) return data as Job;
      }
    } catch (error) {
      if (!(error instanceof Problem) || (error.status >= 400 && error.status < 500) || attempt >= 5) throw error;
    }
    const now = await getJson<Job>(job.links.self);
    if (hasEnded(now)) return now;
    await new Promise((resolve) => { setTimeout(resolve, 300 * (attempt + 1)); });
  }
}

interface ServerEvent { id?: string; event?: string; data: string }

/** Server-sent events of a response, one object each. */
async function* events(response: Response): AsyncGenerator<ServerEvent> {
  if (!response.body || response.status === 204) return;
  const reader = response.body.pipeThrough(new TextDecoderStream() as ReadableWritablePair<string, Uint8Array<ArrayBuffer>>).getReader();
  let text = '';
  for (;;) {
    const { value, done } = await reader.read();
    if (done) return;
    text += value.replaceAll('\r\n', '\n');
    const blocks = text.split('\n\n');
    text = blocks.pop() ?? '';
    for (const block of blocks) {
      const event: Partial<ServerEvent> = {};
      for (const line of block.split('\n')) {
        const [, name, rest = ''] = /^([^:]*):? ?(.*)$/s.exec(line) ?? [];
        if (name === 'data') event.data = event.data === undefined ? rest : `${event.data}\n${rest}`;
        else if (name === 'id' || name === 'event') event[name] = rest;
      }
      if (event.data !== undefined) yield event as ServerEvent;
    }
  }
}
