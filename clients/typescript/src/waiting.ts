/** Waiting with an end. */

/** A promise that is left alone when the signal aborts; what it stands for goes on. */
export function abortable<T>(promise: Promise<T>, signal?: AbortSignal): Promise<T> {
  if (!signal) return promise;
  return new Promise((resolve, reject) => {
    const onAbort = () => reject(signal.reason as Error);
    if (signal.aborted) onAbort();
    signal.addEventListener('abort', onAbort, { once: true });
    promise.then(resolve, reject).finally(() => signal.removeEventListener('abort', onAbort));
  });
}

export function pause(milliseconds: number, signal?: AbortSignal): Promise<void> {
  let timer: ReturnType<typeof setTimeout> | undefined;
  const elapsed = new Promise<void>((resolve) => (timer = setTimeout(resolve, milliseconds)));
  return abortable(elapsed, signal).finally(() => clearTimeout(timer));
}

/** Milliseconds for which a server that cannot be reached, or is busy, is tried again. */
const PATIENCE_MS = 60_000;
/** The same for an address that was never reached: it may be mistyped, and its user should not wait for a minute. */
const FIRST_CONTACT_MS = 4_000;
const SHORTEST_PAUSE_MS = 100;
const LONGEST_PAUSE_MS = 3_000;

/** How long a client tries again. */
export class Patience {
  readonly #givenMs: number | undefined;
  /** Whether a connection to the server has been made before. */
  reached = false;

  constructor(givenMs?: number) {
    this.#givenMs = givenMs;
  }

  get ms(): number {
    return this.#givenMs ?? (this.reached ? PATIENCE_MS : FIRST_CONTACT_MS);
  }

  /** The attempts at one answer. */
  attempts(): Attempts {
    return new Attempts(this);
  }
}

/** Counts the time from the first failure after an answer. */
class Attempts {
  readonly #patience: Patience;
  #giveUpAt: number | undefined;
  #pauseMs = SHORTEST_PAUSE_MS;

  constructor(patience: Patience) {
    this.#patience = patience;
  }

  /** Pauses before the next attempt, for as long as the server asked if it did. False if there is to be none. */
  async again(askedMs: number, signal?: AbortSignal): Promise<boolean> {
    const now = Date.now();
    this.#giveUpAt ??= now + this.#patience.ms;
    if (now + askedMs >= this.#giveUpAt) return false;
    await pause(askedMs || Math.min(this.#pauseMs, this.#giveUpAt - now), signal);
    this.#pauseMs = Math.min(2 * this.#pauseMs, LONGEST_PAUSE_MS);
    return true;
  }
}

/** The signal of one connection. It aborts with the caller's signal, when it is closed, and after a silence. */
export class Connection {
  readonly #controller = new AbortController();
  readonly #outer: AbortSignal | undefined;
  #timer: ReturnType<typeof setTimeout> | undefined;

  /** `silenceMs` is the time that the connection may be silent at first. */
  constructor(outer: AbortSignal | undefined, silenceMs: number) {
    this.#outer = outer;
    outer?.addEventListener('abort', this.#end);
    if (outer?.aborted) this.#end();
    this.expect(silenceMs);
  }

  get signal(): AbortSignal {
    return this.#controller.signal;
  }

  /** Allows a silence of so many milliseconds from now on. */
  expect(silenceMs: number): void {
    clearTimeout(this.#timer);
    this.#timer = setTimeout(this.#end, silenceMs);
  }

  close(): void {
    clearTimeout(this.#timer);
    this.#outer?.removeEventListener('abort', this.#end);
    this.#end();
  }

  readonly #end = (): void => this.#controller.abort();
}
