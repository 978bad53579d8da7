// Solves the requests that `index.mjs` sends, one at a time, and keeps the last result for its files.

import { load } from './plateau.mjs';

let engine = null;
/** Number of the request whose result the engine has. */
let last = null;

const handlers = {
  async start({ module }) {
    engine = load(fetch(module));
    await engine;
  },

  async solve({ request, flag, number, progress }) {
    const solver = await engine;
    last = null;
    const answer = solver.solve(request, {
      onProgress: progress ? (report) => postMessage({ number, progress: report }) : undefined,
      signal: flag ? () => Atomics.load(flag, 0) : undefined,
    });
    if (answer.ending !== 'solved') return { answer };
    last = number;
    const { vertices, triangles } = solver.mesh();
    return { answer, vertices, triangles };
  },

  async drag({ request, flag, number }) {
    const solver = await engine;
    last = null;
    const answer = solver.drag(request, { signal: flag ? () => Atomics.load(flag, 0) : undefined });
    if (answer.ending === 'moved') return { answer, vertices: solver.vertices() };
    if (answer.ending !== 'solved') return { answer };
    last = number;
    const { vertices, triangles } = solver.mesh();
    return { answer, vertices, triangles };
  },

  async file({ format, of }) {
    if (of !== last) throw new Error('a later request has replaced this result: ask for its files before the next solve');
    const file = (await engine).file(format);
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
    postMessage({ number, fault: String(error?.message ?? error) });
  }
};
