// The solvers of Plateau in a worker of a web page. No server is asked.

/** A request without a result. `errors` lists the wrong values as the service does. */
export class PlateauError extends Error {
  constructor({ ending, type, title, detail, errors }) {
    const [first] = errors ?? [];
    super([title, detail, first && `${first.pointer} ${first.detail}`].filter(Boolean).join(': '));
    this.name = 'PlateauError';
    Object.assign(this, { ending, type, title, detail, errors: errors ?? [] });
  }
}

const aborted = (signal) => signal.reason ?? new DOMException('the request was cancelled', 'AbortError');

/**
 * Starts the solvers. Requests are solved one after the other.
 *
 * A page that is isolated (`crossOriginIsolated`) shares memory with the worker, so that a cancel ends a solver at its next
 * look. In other pages a cancel ends the worker, and the next request waits until a new one has loaded the module.
 */
export function createSolvers({
  shapes = new URL('shapes.wasm', import.meta.url),
  structures = new URL('structures.wasm', import.meta.url),
  worker: makeWorker = () => new Worker(new URL('worker.mjs', import.meta.url), { type: 'module' }),
} = {}) {
  let worker = null;
  let numbers = 0;
  /** Messages that wait for the worker, and the one that it works on. */
  let waiting = [];
  let current = null;
  /** Triangles of the last result. */
  let last = null;

  function start() {
    worker = makeWorker();
    worker.onmessage = ({ data }) => {
      if (data.number !== current?.number) return;
      if (data.progress) return current.onProgress?.(data.progress);
      const { resolve, reject } = current;
      current = null;
      if (data.fault === undefined) resolve(data.done);
      else reject(new Error(data.fault));
      next();
    };
    worker.onerror = (event) => {
      const failed = current;
      stop();
      failed?.reject(new Error(event.message || 'the worker cannot be loaded'));
      next();
    };
    waiting.unshift(message('start', { modules: { shapes: String(shapes), structures: String(structures) } }));
  }

  /** Ends the worker. The next message starts a new one. */
  function stop() {
    worker?.terminate();
    worker = null;
    current = null;
    waiting = waiting.filter(({ what }) => what !== 'start');
  }

  function message(what, members, { onProgress } = {}) {
    numbers += 1;
    const made = { what, number: numbers, members, onProgress };
    made.promise = new Promise((resolve, reject) => Object.assign(made, { resolve, reject }));
    // Whoever needs the answer waits for the promise; a failed start fails the request after it, too.
    made.promise.catch(() => {});
    return made;
  }

  function next() {
    if (current || waiting.length === 0) return;
    if (!worker) start();
    current = waiting.shift();
    worker.postMessage({ what: current.what, number: current.number, ...current.members });
  }

  function send(made) {
    waiting.push(made);
    next();
    return made.promise;
  }

  async function file(format, of) {
    return (await send(message('file', { format, of }))).file;
  }

  /** Sends a request, and cancels it when `signal` says so. */
  async function ask(what, request, { onProgress, signal }) {
    if (signal?.aborted) throw aborted(signal);
    const flag = globalThis.crossOriginIsolated ? new Int32Array(new SharedArrayBuffer(4)) : null;
    const made = message(what, { request, flag, progress: Boolean(onProgress) }, { onProgress });
    const cancel = () => {
      if (made === current && flag) {
        Atomics.store(flag, 0, 1);
        return;
      }
      if (made === current) stop();
      waiting = waiting.filter((each) => each !== made);
      made.reject(aborted(signal));
      next();
    };
    signal?.addEventListener('abort', cancel);
    try {
      const { answer, vertices, triangles } = await send(made);
      if (answer.ending === 'cancelled') throw signal ? aborted(signal) : new PlateauError(answer);
      if (answer.ending !== 'solved' && answer.ending !== 'moved') throw new PlateauError(answer);
      // A preview has the triangles of the result that it began from.
      if (triangles) last = triangles;
      return { number: made.number, answer, mesh: { vertices, triangles: last } };
    } finally {
      signal?.removeEventListener('abort', cancel);
    }
  }

  const solution = ({ number, answer: { statistics, warnings }, mesh }) => ({
    statistics,
    warnings,
    mesh,
    file: (format) => file(format, number),
    glb: () => file('glb', number),
  });

  return {
    async load(kind) {
      await send(message('load', { kind }));
    },

    async solve(request, { onProgress, signal } = {}) {
      return solution(await ask('solve', request, { onProgress, signal }));
    },

    async drag(request, { signal } = {}) {
      const asked = await ask('drag', request, { signal });
      const { answer, mesh } = asked;
      return answer.ending === 'moved' ? { moved: answer.moved, mesh } : { moved: null, ...solution(asked) };
    },

    close() {
      const left = [current, ...waiting].filter(Boolean);
      stop();
      waiting = [];
      left.forEach(({ reject }) => reject(new Error('the solvers were closed')));
    },
  };
}
