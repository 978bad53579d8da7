// Solves the requests that `index.mjs` sends, one at a time, and keeps the last result for its files.

import { load, moduleOf } from './plateau.mjs';

/** Addresses of the two modules by their names, and the engines that were loaded from them. */
let addresses = {};
const engines = new Map();
/** The request whose result an engine has. */
let last = { number: null, engine: null };

/** Loads a module when it is first needed. A module that could not be loaded is fetched again by the next request. */
function engineOf(name) {
  if (!engines.has(name)) {
    const loaded = load(fetch(addresses[name]));
    engines.set(name, loaded);
    loaded.catch(() => engines.delete(name));
  }
  return engines.get(name);
}

/**
 * A refused request with all its errors. The first module knows only the first error, and the second one, which knows all kinds,
 * explains it like the service. Where that one cannot be loaded, the first error remains.
 */
async function explained(request, answer) {
  if (answer.ending !== 'refused' || moduleOf(request) !== 'shapes') return answer;
  const again = await engineOf('structures').then((engine) => engine.solve(request, { signal: () => 1 }), () => answer);
  return again.ending === 'refused' ? again : answer;
}

const stopping = (flag) => (flag ? () => Atomics.load(flag, 0) : undefined);

/** Passes a result on, which the engine keeps for its files. */
function solution(engine, number, answer) {
  if (answer.ending !== 'solved') return { answer };
  last = { number, engine };
  const { vertices, triangles } = engine.mesh();
  return { answer, vertices, triangles };
}

const handlers = {
  start({ modules }) {
    addresses = modules;
  },

  async load({ kind }) {
    await engineOf(moduleOf({ kind }));
  },

  async solve({ request, flag, number, progress }) {
    const engine = await engineOf(moduleOf(request));
    last = { number: null, engine: null };
    const answer = engine.solve(request, {
      onProgress: progress ? (report) => postMessage({ number, progress: report }) : undefined,
      signal: stopping(flag),
    });
    return solution(engine, number, await explained(request, answer));
  },

  async drag({ request, flag, number }) {
    const engine = await engineOf(moduleOf(request));
    last = { number: null, engine: null };
    const answer = engine.drag(request, { signal: stopping(flag) });
    return answer.ending === 'moved' ? { answer, vertices: engine.vertices() } : solution(engine, number, await explained(request, answer));
  },

  file({ format, of }) {
    if (of !== last.number) throw new Error('a later request has replaced this result: ask for its files before the next solve');
    const file = last.engine.file(format);
    if (file === null) throw new Error(`the result cannot be written as ${format}`);
    return { file };
  },
};

onmessage = async ({ data }) => {
  const { what, number } = data;
  try {
    const done = await handlers[what](data);
    const arrays = [done?.vertices, done?.triangles, done?.file].filter(Boolean);
    postMessage({ number, done: done ?? {} }, arrays.map((array) => array.buffer));
  } catch (error) {
    // A module that has ended within a call, for example without memory, answers no further call.
    if (error instanceof WebAssembly.RuntimeError) engines.clear();
    postMessage({ number, fault: String(error?.message ?? error) });
  }
};
