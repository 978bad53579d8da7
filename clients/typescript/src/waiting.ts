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
