// The solvers within this page: the package plateau-page in a worker. Their results look like jobs of the service that have ended.

import type { JobInfo, Kind, Progress } from 'plateau-client';
import { createSolvers, PlateauError, type Solution, type Solvers } from 'plateau-page';
import { absolute, plateau } from './api';
import type { Request } from './model/request';
import { meshOf, parseMesh, type ResultMesh } from './stage/mesh';

/** Members of a request that concern its job. There is no job in a page. */
const OF_THE_JOB = ['cache', 'callback_url', 'label', 'metadata', 'supersede', 'cancel_on_disconnect'];
/** Films of more triangles are solved by the service. A film of this size takes a second or two, and each move of a drag 30 ms. */
export const MOST_TRIANGLES = 20_000;
const PREFIX = 'page-';

export interface Asking { signal: AbortSignal; onProgress?: (progress: Progress) => void }

const start = (): Solvers => createSolvers({
  shapes: absolute('studio/shapes.wasm'), structures: absolute('studio/structures.wasm'),
  worker: () => new Worker(absolute('studio/worker.js'), { type: 'module' }),
});

/** The worker of the document, and one for everything else, which would replace the result that a drag follows. */
const workers: { document?: Solvers; other?: Solvers } = {};
const worker = (name: keyof typeof workers): Solvers => (workers[name] ??= start());

const MODULES: Record<Kind, 'shapes' | 'structures'> = {
  minimal_surface: 'shapes', ruled_surface: 'shapes', uniform_mesh: 'shapes', tensile_structure: 'structures', cable_net: 'structures',
};
/** Modules that are there, whose kinds are solved without a connection, and modules that could not be loaded when last tried. */
const loaded = new Set<string>(), missing = new Set<string>();

/** What a page has beside a job of its own. */
interface Own { body: object; solution: Solution | null; mesh: () => Promise<ResultMesh> }
const own = new WeakMap<JobInfo, Own>();
let made = 0;

/** Whether a job is a result of this page, which the service does not know. */
export const isOfPage = (job: JobInfo): boolean => job.id.startsWith(PREFIX);

/** Whether the page solves requests like this one while somebody works on it. */
export function solvesHere(kind: Kind, request: Request): boolean {
  const { triangles } = (request.resolution ?? {}) as { triangles?: unknown };
  return !missing.has(MODULES[kind]) && !request.certify && !(typeof triangles === 'number' && triangles > MOST_TRIANGLES);
}

export const isLoaded = (kind: Kind): boolean => loaded.has(MODULES[kind]);

/** Loads the module of a kind, so that the first change is followed at once and a lost connection stops nothing. */
export async function prepare(kind: Kind): Promise<void> {
  if (!isLoaded(kind)) await worker('document').load(kind).then(() => note(kind, true), () => note(kind, false));
}

function note(kind: Kind, is: boolean): void {
  (is ? loaded : missing).add(MODULES[kind]);
  (is ? missing : loaded).delete(MODULES[kind]);
}

/** The modules cannot be used here: neither a refused request nor one that was given up, but a fault of the page. */
export const isUnusable = (error: unknown): boolean => !(error instanceof PlateauError) && (error as Error | null)?.name !== 'AbortError';

/** The request was refused, as far as a module without the schemas can tell. */
export const isRefused = (error: unknown): boolean => error instanceof PlateauError && error.ending === 'refused';

const bodyOf = (kind: Kind, request: Request): object => {
  const body: Request = { ...request, kind };
  for (const member of OF_THE_JOB) delete body[member];
  return body;
};

/** Solves a request in this page. */
export async function solveHere(kind: Kind, request: Request, asking: Asking, name: keyof typeof workers = 'document'): Promise<JobInfo> {
  const body = bodyOf(kind, request);
  const since = Date.now();
  const solution = await using(kind, worker(name).solve(body, asking));
  return jobOf(kind, since, body, solution);
}

/** Moves the last result to the request, which differs from the last one in places only, or solves it. */
export async function moveHere(kind: Kind, request: Request, asking: Asking): Promise<JobInfo> {
  const body = bodyOf(kind, request);
  const since = Date.now();
  const answer = await using(kind, worker('document').drag(body, asking));
  if (answer.moved === null) return jobOf(kind, since, body, answer);
  const { moved, mesh: { vertices, triangles } } = answer;
  const job = described(kind, since, { ...moved, vertices: vertices.length / 3, triangles: triangles.length / 3 }, []);
  own.set(job, { body, solution: null, mesh: () => Promise.resolve(meshOf(vertices, triangles, request)) });
  return job;
}

/** Remembers of an answer whether the modules work. */
async function using<T>(kind: Kind, answer: Promise<T>): Promise<T> {
  try {
    const found = await answer;
    note(kind, true);
    return found;
  } catch (error) {
    if (isUnusable(error)) note(kind, false);
    throw error;
  }
}

function jobOf(kind: Kind, since: number, body: object, solution: Solution): JobInfo {
  const job = described(kind, since, solution.statistics, solution.warnings);
  // The file is made at once, because a later request replaces the result in the worker.
  const glb = solution.glb();
  glb.catch(() => {});
  own.set(job, { body, solution, mesh: async () => parseMesh((await glb).buffer as ArrayBuffer) });
  return job;
}

function described(kind: Kind, since: number, statistics: object, warnings: object[]): JobInfo {
  made += 1;
  const [started_at, finished_at] = [since, Date.now()].map((time) => new Date(time).toISOString());
  const links = kind === 'ruled_surface' ? { pattern: '#' } : {};
  return { id: `${PREFIX}${made}`, kind, status: 'succeeded', statistics, warnings, links, created_at: started_at, started_at, finished_at } as unknown as JobInfo;
}

/** The mesh of a job of this page or of the service. */
export async function meshOfJob(job: JobInfo, signal?: AbortSignal): Promise<ResultMesh> {
  return own.get(job)?.mesh() ?? parseMesh(await plateau.download(job.id, 'glb', signal));
}

/** A file of a job of this page or of the service. */
export async function fileOf(job: JobInfo, format: Parameters<typeof plateau.download>[1]): Promise<BlobPart> {
  const found = own.get(job);
  if (!found) return plateau.download(job.id, format);
  const known = await found.solution?.file(format as 'glb').catch(() => null);
  // A later request has replaced the result. The same request has the same result.
  return (known ?? await (await worker('other').solve(found.body)).file(format as 'glb')) as BlobPart;
}
