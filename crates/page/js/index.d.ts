/** A progress of a running solver, as an event of a job has it. */
export interface Progress {
  fraction: number;
  phase: string;
  iteration: number;
  objective_value: number | null;
  residual: number | null;
}

/** A wrong value of a request: a JSON Pointer and what the value must be. */
export interface FieldError {
  pointer: string;
  detail: string;
}

export interface Warning {
  code: string;
  detail: string;
  values?: Record<string, number>;
}

export interface Solution {
  /** Statistics of the request's kind, as a job of the service has them. */
  statistics: Record<string, unknown>;
  warnings: Warning[];
  /** Three coordinates for each vertex in the request's unit and axes, and three vertices for each triangle. */
  mesh: { vertices: Float64Array; triangles: Uint32Array };
  /** Writes the result as a file: its mesh, or as SVG or DXF its flat pattern. It fails once a later request has replaced the result. */
  file(format: 'glb' | 'gltf' | 'obj' | 'ply' | 'stl' | 'json' | 'svg' | 'dxf'): Promise<Uint8Array>;
  glb(): Promise<Uint8Array>;
}

/** A film that followed a drag: the triangles of the result that it began from, with vertices at other places. */
export interface Preview {
  /** Area in the square of the request's unit, and the residual, which is at most 1e-4 or the request's `tolerance`. */
  moved: { area: number; residual: number };
  mesh: { vertices: Float64Array; triangles: Uint32Array };
}

export interface SolveOptions {
  onProgress?: (progress: Progress) => void;
  /** Cancels the request. The promise is then rejected with the signal's reason. */
  signal?: AbortSignal;
}

export interface Solvers {
  /** Loads the module that solves a kind, so that its first request does not wait for it. Rejects if it cannot be loaded. */
  load(kind: string): Promise<void>;
  /**
   * Solves a request that names its `kind` and has none of the fields that concern a job.
   *
   * Rejects with a {@link PlateauError} if the request is refused or has no result.
   */
  solve(request: object, options?: SolveOptions): Promise<Solution>;
  /**
   * Moves the last result to the places of a request that differs from it in places only, which takes a fraction of a solve. The
   * answer is a preview, of which no file is made: {@link solve} the request in the end. A request that the last result cannot
   * follow is solved, and rejects as a solve does: strips, lattices, nets and tensile structures, films with other numbers of
   * points, fixed points or another topology than `fixed`, and moves that would turn a triangle over.
   */
  drag(request: object, options?: { signal?: AbortSignal }): Promise<Preview | (Solution & { moved: null })>;
  /** Ends the worker. Requests under way are rejected. */
  close(): void;
}

export class PlateauError extends Error {
  ending: 'refused' | 'failed' | 'cancelled';
  /** The reason of a failure as the service's problem documents name it, such as `/problems/no-equilibrium`. */
  type?: string;
  title: string;
  detail: string;
  errors: FieldError[];
}

export interface Options {
  /** Address of the module for films, strips and lattices, if it does not lie beside this file. */
  shapes?: string | URL;
  /** Address of the module for tensile structures, cable nets and proven lower bounds, which is loaded when one is first asked for. */
  structures?: string | URL;
  /** Makes the worker, for bundlers that need to see the call. */
  worker?: () => Worker;
}

export function createSolvers(options?: Options): Solvers;
