/** Follows a job to its end over connections that break. */
import { createParser, type EventSourceMessage } from 'eventsource-parser';
import { ConnectionFailed, PASSING, problemOf, retryAfterMs } from './errors.js';
import type { JobInfo, Progress, Status } from './types.js';
import { abortable, Connection, type Patience, pause } from './waiting.js';

export interface FollowControl {
  /** Called with each step of the solver. */
  onProgress?: (progress: Progress) => void;
  /** Called with false when the connection to a job breaks, and with true when it is back. Meanwhile the job goes on. */
  onConnection?: (connected: boolean) => void;
  /** Aborting stops the wait. */
  signal?: AbortSignal | undefined;
}

/** Sends one GET request, once. */
export type Get = (path: string, headers: Record<string, string>, signal: AbortSignal) => Promise<Response>;

/** Milliseconds within which an event stream must begin. The server says something at once. */
const OPENING_MS = 5_000;
/** Milliseconds for which an event stream may be silent. The server sends a comment every 15 s. */
const SILENCE_MS = 45_000;
/** Milliseconds for which any other answer may be awaited. */
const ANSWER_MS = 15_000;
/** Milliseconds from a break to the next connection, until the server has said another time (`retry`). */
const RECONNECT_MS = 1_000;
/** Longest time that a server can ask for between two connections, in milliseconds. */
const LONGEST_RETRY_MS = 60_000;
/** Number of streams without any event in a row after which the job is polled instead. */
const STREAMS = 2;
const POLL_MS = 2_000;
export const hasEnded = (status: Status): boolean => status === 'succeeded' || status === 'failed' || status === 'cancelled';

/** A connection that broke, or an answer that may be another one later. */
class Interrupted extends Error {
  /** `pauseMs` is the time that the server asked for. */
  constructor(cause: unknown, readonly pauseMs = 0) {
    super('interrupted', { cause });
  }
}

/**
 * Waits until a job has ended, however it ended. Its event stream is opened again after a break, from the last event on.
 * Where no stream passes, the job is asked for every other second.
 */
export class Follower {
  /** What the server last said of the job. */
  #job: JobInfo;
  readonly #get: Get;
  readonly #control: FollowControl;
  readonly #patience: Patience;
  #lastId = '';
  #retryMs = RECONNECT_MS;
  /** Number of streams that are still tried if none of them brings an event. */
  #streams = STREAMS;
  #connected = true;

  constructor(job: JobInfo, get: Get, control: FollowControl, patience: Patience) {
    this.#job = job;
    this.#get = get;
    this.#control = control;
    this.#patience = patience;
  }

  async end(): Promise<JobInfo> {
    const { signal, onProgress } = this.#control;
    signal?.throwIfAborted();
    if (hasEnded(this.#job.status)) onProgress?.(this.#job.progress);
    while (!hasEnded(this.#job.status)) {
      if (this.#streams > 0) {
        this.#streams -= 1;
        await this.#listen();
        if (hasEnded(this.#job.status)) break;
      }
      await this.#lookUntilAnswered();
      if (hasEnded(this.#job.status) || this.#streams === 0) {
        this.#tell(true);
        onProgress?.(this.#job.progress);
      }
      if (!hasEnded(this.#job.status)) await pause(this.#streams > 0 ? this.#retryMs : POLL_MS, signal);
    }
    return this.#job;
  }

  /** Listens to the event stream until the job ends or the stream does. */
  async #listen(): Promise<void> {
    const { onProgress, signal } = this.#control;
    const connection = new Connection(signal, OPENING_MS);
    const events: EventSourceMessage[] = [];
    const parser = createParser({
      onEvent: (event) => events.push(event),
      onRetry: (ms) => (this.#retryMs = Math.min(ms, LONGEST_RETRY_MS)),
    });
    try {
      const headers: Record<string, string> = { Accept: 'text/event-stream' };
      if (this.#lastId) headers['Last-Event-ID'] = this.#lastId;
      const path = `${this.#path}/events`;
      const response = await this.#reach(connection, (inner) => this.#get(path, headers, inner));
      // No event follows the last one that was seen.
      if (response.status === 204) this.#streams = 0;
      const isStream = response.headers.get('content-type')?.startsWith('text/event-stream');
      if (response.status !== 200 || !isStream || !response.body) return;
      const reader = response.body.getReader();
      const decoder = new TextDecoder();
      for (;;) {
        const { done, value } = await this.#reach(connection, () => reader.read());
        if (done) break;
        connection.expect(SILENCE_MS);
        this.#tell(true);
        parser.feed(decoder.decode(value, { stream: true }));
        for (const event of events.splice(0)) {
          this.#streams = STREAMS;
          this.#lastId = event.id ?? this.#lastId;
          const said = JSON.parse(event.data) as JobInfo;
          if (event.event === 'status') this.#job = said;
          onProgress?.(said.progress);
          if (hasEnded(this.#job.status)) return;
        }
      }
      this.#tell(false);
    } catch (error) {
      if (!(error instanceof Interrupted)) throw error;
      this.#tell(false);
    } finally {
      connection.close();
    }
  }

  /** Asks for the job, again and again while the server cannot be reached. */
  async #lookUntilAnswered(): Promise<void> {
    const attempts = this.#patience.attempts();
    for (;;) {
      try {
        this.#job = await this.#look();
        return;
      } catch (error) {
        if (!(error instanceof Interrupted)) throw error;
        this.#tell(false);
        if (!(await attempts.again(error.pauseMs, this.#control.signal))) throw this.#lost(error.cause);
      }
    }
  }

  async #look(): Promise<JobInfo> {
    const connection = new Connection(this.#control.signal, ANSWER_MS);
    try {
      const response = await this.#reach(connection, (signal) => this.#get(this.#path, {}, signal));
      if (!response.ok) {
        const problem = problemOf(response, await this.#reach(connection, () => response.text()));
        if (!PASSING.includes(response.status)) throw problem;
        throw new Interrupted(problem, retryAfterMs(response));
      }
      return await this.#reach(connection, () => response.json() as Promise<JobInfo>);
    } finally {
      connection.close();
    }
  }

  /** Carries out a step on a connection; whatever breaks it is an interruption, except for the caller's signal. */
  async #reach<T>(connection: Connection, step: (signal: AbortSignal) => Promise<T>): Promise<T> {
    try {
      return await abortable(step(connection.signal), connection.signal);
    } catch (error) {
      this.#control.signal?.throwIfAborted();
      throw new Interrupted(error);
    }
  }

  get #path(): string {
    return `v1/jobs/${this.#job.id}`;
  }

  #lost(cause: unknown): ConnectionFailed {
    const { id } = this.#job;
    const message = `the connection was lost; job ${id} goes on at the server, and \`client.resume('${id}')\` comes back to it`;
    return new ConnectionFailed(message, { cause, job: this.#job });
  }

  #tell(connected: boolean): void {
    if (connected === this.#connected) return;
    this.#connected = connected;
    this.#control.onConnection?.(connected);
  }
}
