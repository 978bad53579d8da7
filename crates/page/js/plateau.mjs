// The solvers of Plateau as WebAssembly modules, without a server.

/** Endings of a request, in the order of the module's numbers. */
const ENDINGS = ['solved', 'refused', 'failed', 'cancelled', 'moved'];

const SHAPES = ['minimal_surface', 'ruled_surface', 'uniform_mesh'];

/** Name of the module that solves a request: `shapes` or `structures`. Proven bounds of films need the second one. */
export const moduleOf = ({ kind, certify }) => (SHAPES.includes(kind) && !(kind === 'minimal_surface' && certify) ? 'shapes' : 'structures');

/**
 * Loads a module.
 * @param {BufferSource | Response | PromiseLike<Response>} source its bytes, or the answer of a fetch
 */
export async function load(source) {
  // The module calls these while it solves.
  const asked = { signal: () => 0, progress: () => {} };
  const text = (address, bytes) => new TextDecoder().decode(new Uint8Array(exports.memory.buffer, address, bytes));
  const imports = {
    plateau: {
      signal: () => asked.signal(),
      progress: (fraction, phase, bytes, iteration, objective, residual) =>
        asked.progress({
          fraction,
          phase: text(phase, bytes),
          iteration,
          objective_value: Number.isNaN(objective) ? null : objective,
          residual: Number.isNaN(residual) ? null : residual,
        }),
    },
  };
  const waited = await source;
  if (waited instanceof Response && !waited.ok) throw new Error(`the module at ${waited.url} was answered with ${waited.status}`);
  // Browsers compile while they load only what has the media type of WebAssembly, which not every file server knows.
  const streamed = waited instanceof Response && waited.headers.get('content-type') === 'application/wasm';
  const { instance } = await (streamed
    ? WebAssembly.instantiateStreaming(waited, imports)
    : WebAssembly.instantiate(waited instanceof Response ? await waited.arrayBuffer() : waited, imports));
  const exports = instance.exports;

  const put = (words) => {
    const bytes = new TextEncoder().encode(words);
    // Memory is read after the call, because making room may move it.
    const address = exports.plateau_input(bytes.length);
    new Uint8Array(exports.memory.buffer, address, bytes.length).set(bytes);
  };

  /** Calls an entry of the module with a request and reads its answer. */
  const ask = (entry, request, { onProgress = () => {}, signal = () => 0 } = {}) => {
    asked.progress = onProgress;
    asked.signal = signal;
    put(typeof request === 'string' ? request : JSON.stringify(request));
    const ending = ENDINGS[exports[entry]()];
    const answer = text(exports.plateau_answer(), exports.plateau_answer_bytes());
    return { ending, ...(answer === '' ? {} : JSON.parse(answer)) };
  };

  return {
    /**
     * Solves a request (an object, or JSON text) that names its kind. Blocks until it ends, so that pages call it in a
     * worker.
     *
     * `onProgress` gets the members of a job's progress. `signal` is asked where the service's solvers look for a cancel: 0 goes on, 1 cancels,
     * 2 ends with the best result so far.
     */
    solve: (request, options) => ask('plateau_solve', request, options),

    /**
     * Moves the last result to the places of a request that differs from it in places only, with the ending `moved` and
     * the figures `moved` of the preview. A request that the last result cannot follow is solved, with the endings of `solve`.
     */
    drag: (request, options) => ask('plateau_drag', request, options),

    /** The vertices of the last result or of its preview, three numbers each, as a copy. */
    vertices() {
      return new Float64Array(exports.memory.buffer, exports.plateau_vertices(), 3 * exports.plateau_vertices_count()).slice();
    },

    /** The last result's vertices, and its triangles, three vertices each, as copies. */
    mesh() {
      const { buffer } = exports.memory;
      return {
        vertices: this.vertices(),
        triangles: new Uint32Array(buffer, exports.plateau_triangles(), 3 * exports.plateau_triangles_count()).slice(),
      };
    },

    /** The last result as a file: glb, gltf, obj, ply, stl or json, or its flat pattern as svg or dxf. Null if it has none, or is a preview. */
    file(format) {
      put(format);
      const bytes = exports.plateau_file();
      return bytes === 0 ? null : new Uint8Array(exports.memory.buffer, exports.plateau_file_address(), bytes).slice();
    },
  };
}
