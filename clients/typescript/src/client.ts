/** The client. */
import { checkUnits, type CurveLike, curveAt, curves, invalid, toJson } from './curves.js';
import { about, ConnectionFailed, JobCancelled, JobFailed, PASSING, problemOf, retryAfterMs } from './errors.js';
import { type FollowControl, Follower, type Get, hasEnded } from './follow.js';
import { type Lines, Mesh, readLines } from './mesh.js';
import type {
  BatchInfo, CableNetOptions, CableNetStatistics, JobInfo, JobSummary, Kind, Limits, MeshFormat, MinimalStatistics, MinimalSurfaceOptions, ObjectiveList, PatternFormat,
  PatternParameters, Request, RuledStatistics, RuledSurfaceOptions, ScheduleParameters, StatisticsOf, Status, TensileFilm, TensileStatistics,
  TensileStructureOptions, UniformMeshOptions, UniformStatistics,
} from './types.js';
import { abortable, Patience } from './waiting.js';

export interface PlateauOptions {
  /** The server with its public base path. Default: PLATEAU_URL of Node's environment, then http://127.0.0.1:8080. */
  url?: string;
  /** Default: PLATEAU_API_KEY of Node's environment. */
  apiKey?: string;
  /**
   * Milliseconds for which a request is tried again while the server cannot be reached or is busy. Default: 60,000, and
   * 4,000 for an address that was never reached.
   */
  patienceMs?: number;
  fetch?: typeof fetch;
}

export interface SolveControl extends FollowControl {
  /** Aborting stops the wait and cancels the job on the server. */
  signal?: AbortSignal | undefined;
}

export interface SubmitOptions {
  /** Submissions with the same key make one job. Default: a key of its own. */
  idempotencyKey?: string;
  /** Seconds that the answer waits for the job's end; the server may grant less. Default: 0. */
  waitS?: number;
  /** Aborting before the answer is there cancels the job on the server. */
  signal?: AbortSignal | undefined;
}

interface Process {
  env?: Record<string, string | undefined>;
  versions?: Record<string, string | undefined>;
}

interface Sending {
  method?: string;
  headers?: Record<string, string>;
  body?: string;
  signal?: AbortSignal | undefined;
}

/** The version of this package. */
export const version = '0.1.0';

const PATHS: Record<Kind, string> = {
  ruled_surface: 'v1/ruled-surfaces',
  minimal_surface: 'v1/minimal-surfaces',
  uniform_mesh: 'v1/uniform-meshes',
  tensile_structure: 'v1/tensile-structures',
  cable_net: 'v1/cable-nets',
};

/** The path of a job and of everything that belongs to it. */
const JOB = /^v1\/jobs\/([^/?]+)/;

/** Seconds that the answer to a submission waits for the end, so that a small request takes one round trip. */
const SHORT_WAIT_S = 1;
/** Seconds that one request waits for a batch's end; the server may grant less. */
const LONG_POLL_S = 20;
/** Codes of Node.js for connections that were never made. */
const UNREACHED: readonly string[] = [
  'ECONNREFUSED', 'ENOTFOUND', 'EAI_AGAIN', 'EHOSTUNREACH', 'ENETUNREACH', 'ETIMEDOUT', 'UND_ERR_CONNECT_TIMEOUT',
];

/** A mesh whose files and curves can still be fetched from the server. */
export class Result<Statistics> extends Mesh<Statistics> {
  readonly #client: Plateau;

  constructor(client: Plateau, job: JobInfo, ply: ArrayBuffer) {
    super(job, ply);
    this.#client = client;
  }

  /** The mesh in a format, or the flat pattern of a ruled surface (`svg`, `dxf`). */
  download(format: MeshFormat | PatternFormat = 'glb'): Promise<ArrayBuffer> {
    return this.#client.download(this.id, format);
  }

  /** The lines on the mesh by name (`boundaries`, `bridges`, `members rim`, `cables ridge`, `reactions`…). */
  async lines(): Promise<Map<string, Lines>> {
    return readLines(parsed(await this.download('json')));
  }

  /** The flat pattern of a ruled surface: `{ profile: 'cut', format: 'dxf' }` is a ZIP with a file for each piece. */
  pattern(parameters: PatternParameters = {}): Promise<ArrayBuffer> {
    return this.#client.drawing(this.id, 'pattern', parameters);
  }

  /** The parts of a result: `{ part: 'nodes' }` is a table (CSV), `{ format: 'dxf' }` the numbered members in space. */
  schedule(parameters: ScheduleParameters = {}): Promise<ArrayBuffer> {
    return this.#client.drawing(this.id, 'schedule', parameters);
  }

  /** The proof of a lower bound of the area, for requests with `certify`. */
  certificate(): Promise<Record<string, unknown>> {
    return this.#client.getJson(`v1/jobs/${this.id}/certificate`);
  }
}

/** A job on the server. `info` is what the server last said of it. */
export class Job<Statistics = unknown> {
  readonly #client: Plateau;

  constructor(
    client: Plateau,
    public info: JobInfo,
    /** The request as this client sent it. Undefined for a job that another client submitted: see `fetchRequest`. */
    readonly request?: Request,
  ) {
    this.#client = client;
  }

  get id(): string {
    return this.info.id;
  }

  get status(): Status {
    return this.info.status;
  }

  async refresh(): Promise<JobInfo> {
    return (this.info = await this.#client.getJson<JobInfo>(`v1/jobs/${this.id}`));
  }

  /** The request as the server accepted it, with its kind. The server keeps it as long as the job. */
  fetchRequest(): Promise<Request> {
    return this.#client.getJson<Request>(`v1/jobs/${this.id}/request`);
  }

  /** Waits for the end and gets the mesh. Aborting the signal stops the wait; the job goes on. */
  async wait(control: FollowControl = {}): Promise<Result<Statistics>> {
    this.info = await this.#client.waitFor(this.info, control);
    return this.#client.resultOf<Statistics>(this.info, undefined, this.request);
  }

  /** Cancels the job; a job that has ended stays as it is. */
  async cancel(): Promise<JobInfo> {
    return (this.info = await this.#client.cancel(this.id));
  }

  /** Removes the job and its mesh from the server. */
  async delete(): Promise<void> {
    await this.#client.delete(this.id);
  }
}

/** Requests that were submitted together. `info` is what the server last said of them. */
export class Batch {
  readonly #client: Plateau;
  readonly #requests: readonly Request[] | undefined;

  constructor(client: Plateau, public info: BatchInfo, requests?: readonly Request[]) {
    this.#client = client;
    this.#requests = requests;
  }

  get id(): string {
    return this.info.id;
  }

  get status(): Status {
    return this.info.status;
  }

  async refresh(): Promise<BatchInfo> {
    return (this.info = await this.#client.getJson<BatchInfo>(`v1/batches/${this.id}`));
  }

  /**
   * Waits until every job has ended, and gets a mesh for each request, in their order. A job without a mesh has its JobFailed
   * or JobCancelled in the list. Aborting the signal stops the wait; the jobs go on.
   */
  async wait(control: { signal?: AbortSignal } = {}): Promise<(Result<unknown> | JobFailed | JobCancelled)[]> {
    const { signal } = control;
    while (!hasEnded(this.info.status)) {
      const sending = { headers: { Prefer: `wait=${LONG_POLL_S}` }, signal };
      this.info = parsed<BatchInfo>(await this.#client.send(`v1/batches/${this.id}`, sending));
    }
    const found: (Result<unknown> | JobFailed | JobCancelled)[] = [];
    for (const { id, index } of this.info.jobs) {
      const job = await this.#client.getJson<JobInfo>(`v1/jobs/${id}`);
      found.push(await this.#client.resultOf<unknown>(job, signal, this.#requests?.[index]).catch((error: unknown) => {
        if (error instanceof JobFailed || error instanceof JobCancelled) return error;
        throw error;
      }));
    }
    return found;
  }

  /** All meshes as one `zip`, each in `meshFormat` (`glb` by default), or as one `glb` scene. */
  download(format: 'zip' | 'glb' = 'zip', meshFormat?: MeshFormat): Promise<ArrayBuffer> {
    const chosen = meshFormat ? `&mesh_format=${meshFormat}` : '';
    return this.#client.send(`v1/batches/${this.id}/meshes?format=${format}${chosen}`);
  }

  /** Cancels every job that has not ended. */
  async cancel(): Promise<BatchInfo> {
    return (this.info = parsed(await this.#client.send(`v1/batches/${this.id}/cancel`, { method: 'POST' })));
  }

  /** Removes the batch with its jobs and meshes from the server. */
  async delete(): Promise<void> {
    await this.#client.send(`v1/batches/${this.id}`, { method: 'DELETE' });
  }
}

/** A Plateau server. */
export class Plateau {
  readonly url: string;
  readonly #patience: Patience;
  readonly #headers: Record<string, string>;
  readonly #fetch: typeof fetch;

  /** `options` may be the address alone. */
  constructor(options: string | PlateauOptions = {}) {
    const { url, apiKey, patienceMs, fetch }: PlateauOptions = typeof options === 'string' ? { url: options } : options;
    const { env: environment = {}, versions } = (globalThis as { process?: Process }).process ?? {};
    this.url = (url || environment['PLATEAU_URL'] || 'http://127.0.0.1:8080').replace(/\/+$/, '');
    const key = apiKey ?? environment['PLATEAU_API_KEY'];
    this.#headers = key ? { Authorization: `Bearer ${key}` } : {};
    // Browsers name themselves, and ask the server first about a request with a name of its own.
    if (versions?.['node']) this.#headers['User-Agent'] = `plateau-client/${version} (Node.js)`;
    this.#patience = new Patience(patienceMs);
    this.#fetch = fetch ?? ((input, init) => globalThis.fetch(input, init));
  }

  /** The best triangulated strip between each pair of neighbouring directrices. */
  async ruledSurface(
    directrices: readonly CurveLike[], options: RuledSurfaceOptions = {}, control?: SolveControl,
  ): Promise<Result<RuledStatistics>> {
    return this.solve({ kind: 'ruled_surface', directrices: curves('directrices', directrices), ...options }, control);
  }

  /** The minimal surface that spans closed boundaries. */
  async minimalSurface(
    boundaries: readonly CurveLike[], options: MinimalSurfaceOptions = {}, control?: SolveControl,
  ): Promise<Result<MinimalStatistics>> {
    return this.solve({ kind: 'minimal_surface', boundaries: curves('boundaries', boundaries), ...options }, control);
  }

  /** A mesh of nearly equal members on a polygon, given as a curve, or on any domain of the API. */
  async uniformMesh(
    domain: CurveLike | (Request & { kind: 'uniform_mesh' })['domain'], edgeLength: number,
    options: UniformMeshOptions = {}, control?: SolveControl,
  ): Promise<Result<UniformStatistics>> {
    const isCurve = Array.isArray(domain) || ArrayBuffer.isView(domain);
    const given = isCurve ? { polygon: curveAt('/domain/polygon', domain as CurveLike) } : (domain as { polygon?: number[][] });
    return this.solve({ kind: 'uniform_mesh', domain: given, edge_length: edgeLength, ...options }, control);
  }

  /**
   * The shape in equilibrium of a film of constant tension with cables, pressure and weight. Several films are the layers of a
   * cushion, with `chambers` between them.
   */
  async tensileStructure(
    boundaries: readonly CurveLike[], film: TensileFilm | readonly TensileFilm[], options: TensileStructureOptions = {},
    control?: SolveControl,
  ): Promise<Result<TensileStatistics>> {
    const loops = curves('boundaries', boundaries);
    const films = Array.isArray(film) ? { layers: film as TensileFilm[] } : { film: film as TensileFilm };
    return this.solve({ kind: 'tensile_structure', boundaries: loops, ...films, ...options }, control);
  }

  /**
   * The shape in equilibrium of a cable net that comes nearest to target forces and lengths. `edges` are pairs of indices of
   * `vertices`, and `supports` are the indices of the vertices that do not move.
   */
  async cableNet(
    vertices: CurveLike, edges: readonly (readonly [number, number])[], supports: readonly number[],
    options: CableNetOptions = {}, control?: SolveControl,
  ): Promise<Result<CableNetStatistics>> {
    const net = { vertices: curveAt('/vertices', vertices), edges: edges as unknown as number[][], supports: supports as number[] };
    return this.solve({ kind: 'cable_net', ...net, ...options }, control);
  }

  /**
   * Solves a request with its `kind` in it, such as those of `GET /v1/examples`. If the connection is lost for good, the job
   * goes on: the error names it.
   */
  async solve<R extends Request>(request: R, control: SolveControl = {}): Promise<Result<StatisticsOf<R>>> {
    const { signal, onProgress } = control;
    const { info } = await this.submit(request, { waitS: onProgress ? 0 : SHORT_WAIT_S, signal });
    let job: JobInfo;
    try {
      job = await this.waitFor(info, control);
    } catch (error) {
      if (!(error instanceof ConnectionFailed)) await this.cancel(info.id).catch(() => undefined);
      throw error;
    }
    return this.resultOf<StatisticsOf<R>>(job, signal, request);
  }

  /** Submits a request and returns the job once it is accepted. */
  async submit<R extends Request>(request: R, options: SubmitOptions = {}): Promise<Job<StatisticsOf<R>>> {
    const { idempotencyKey = randomKey(), waitS = 0, signal } = options;
    signal?.throwIfAborted();
    const posted = this.#post(request, idempotencyKey, waitS);
    try {
      return new Job(this, await abortable(posted, signal), request);
    } catch (error) {
      if (signal?.aborted) void this.#giveUp(posted, idempotencyKey);
      throw error;
    }
  }

  /** Submits many requests at once and returns the batch once it is accepted. */
  async submitBatch(requests: readonly Request[], options: { idempotencyKey?: string } = {}): Promise<Batch> {
    const key = options.idempotencyKey ?? randomKey();
    requests.forEach((request, index) => checkUnits(request, `/requests/${index}`));
    return new Batch(this, await this.#submit<BatchInfo>('v1/batches', { requests }, key, 0), requests);
  }

  /** A batch by its id. */
  async batch(id: string): Promise<Batch> {
    return new Batch(this, await this.getJson<BatchInfo>(`v1/batches/${id}`));
  }

  /** For dragging: of the requests that are solved through it only the newest counts. */
  live(): Live {
    return new Live(this);
  }

  /** A job by its id. */
  async job(id: string): Promise<Job> {
    return new Job(this, await this.getJson<JobInfo>(`v1/jobs/${id}`));
  }

  /** Waits for a job of an earlier call and gets its mesh. Aborting the signal stops the wait; the job goes on. */
  async resume(id: string, control: FollowControl = {}): Promise<Result<unknown>> {
    return (await this.job(id)).wait(control);
  }

  /** All jobs, newest first, page by page. */
  async *jobs(filter: { status?: Status; kind?: Kind; idempotency_key?: string } = {}): AsyncGenerator<JobSummary> {
    let cursor: string | null | undefined;
    do {
      const query = new URLSearchParams({ ...filter, ...(cursor ? { cursor } : {}) });
      const page = await this.getJson<{ jobs: JobSummary[]; next_cursor?: string | null }>(`v1/jobs?${query}`);
      yield* page.jobs;
      cursor = page.next_cursor;
    } while (cursor);
  }

  async cancel(id: string): Promise<JobInfo> {
    return parsed<JobInfo>(await this.send(`v1/jobs/${id}/cancel`, { method: 'POST' }));
  }

  /** Removes a job and its mesh; cancels it if needed. */
  async delete(id: string): Promise<void> {
    await this.send(`v1/jobs/${id}`, { method: 'DELETE' });
  }

  async download(id: string, format: MeshFormat | PatternFormat = 'glb', signal?: AbortSignal): Promise<ArrayBuffer> {
    const part = format === 'svg' || format === 'dxf' ? 'pattern' : 'mesh';
    return this.send(`v1/jobs/${id}/${part}?format=${format}`, { signal });
  }

  /** A file that is made from a result, by the parameters of its address. */
  drawing(id: string, part: 'pattern' | 'schedule', parameters: PatternParameters | ScheduleParameters = {}) {
    const query = new URLSearchParams(Object.entries(parameters).map(([name, value]) => [name, String(value)]));
    return this.send(`v1/jobs/${id}/${part}?${query}`);
  }

  objectives(): Promise<ObjectiveList> {
    return this.getJson('v1/objectives');
  }

  limits(): Promise<Limits> {
    return this.getJson('v1/limits');
  }

  /** The request of an example, its `kind` in it, ready for `solve`. */
  async example(name: string): Promise<Request> {
    const found = await this.getJson<{ kind: Kind; request: object }>(`v1/examples/${name}`);
    return { kind: found.kind, ...found.request } as Request;
  }

  /** Waits until a job has ended, however it ended. Connections that break are made again. */
  waitFor(job: JobInfo, control: FollowControl = {}): Promise<JobInfo> {
    const get: Get = (path, headers, signal) => this.#fetchOnce(path, { headers, signal });
    return about(job.id, new Follower(job, get, control, this.#patience).end());
  }

  /** The mesh of a job that has ended; throws how it ended if there is none. */
  async resultOf<Statistics>(job: JobInfo, signal?: AbortSignal, request?: Request): Promise<Result<Statistics>> {
    if (job.status === 'failed') throw new JobFailed(job);
    if (job.status === 'cancelled') throw new JobCancelled(job);
    const made = new Result<Statistics>(this, job, await this.download(job.id, 'ply', signal));
    made.request = request;
    return made;
  }

  async getJson<T>(path: string): Promise<T> {
    return parsed<T>(await this.send(path));
  }

  /**
   * Sends a request and reads its answer. Waits and tries again while the server is busy or cannot be reached; throws what it
   * refuses. Every request may be sent again, because submissions carry an Idempotency-Key. An error about a job has its id.
   */
  send(path: string, sending: Sending = {}): Promise<ArrayBuffer> {
    return about(JOB.exec(path)?.[1], this.#send(path, sending));
  }

  async #send(path: string, sending: Sending): Promise<ArrayBuffer> {
    const attempts = this.#patience.attempts();
    for (;;) {
      let response: Response;
      let body: ArrayBuffer;
      try {
        response = await this.#fetchOnce(path, sending);
        body = await response.arrayBuffer();
      } catch (error) {
        sending.signal?.throwIfAborted();
        if (!this.#patience.reached && (await this.#isBlocked())) throw this.#blocked(error);
        if (await attempts.again(0, sending.signal)) continue;
        const remedy = this.#patience.reached ? '' : '; start the service there, or name its address by `url` or PLATEAU_URL';
        throw new ConnectionFailed(`${this.url} cannot be reached${remedy}`, { cause: error });
      }
      if (response.ok) return body;
      const problem = problemOf(response, new TextDecoder().decode(body));
      const isPassing = PASSING.includes(response.status);
      if (!isPassing || !(await attempts.again(retryAfterMs(response), sending.signal))) throw problem;
    }
  }

  /**
   * Whether the server answers and the browser keeps the answer from this page (CORS). A browser does not say so: it reports a
   * blocked answer like a missing one, but lets a request pass that wants no answer.
   */
  async #isBlocked(): Promise<boolean> {
    if (!origin()) return false;
    return this.#fetch(`${this.url}/health/live`, { mode: 'no-cors' }).then(() => true, () => false);
  }

  #blocked(cause: unknown): ConnectionFailed {
    const message = `${this.url} answers, but the browser keeps its answers from pages of ${origin()} (CORS): `
      + `the server's setting http.cors_origins must name "${origin()}"`;
    return new ConnectionFailed(message, { cause });
  }

  async #fetchOnce(path: string, sending: Sending): Promise<Response> {
    const init: RequestInit = { method: sending.method ?? 'GET', headers: { ...this.#headers, ...sending.headers } };
    if (sending.body !== undefined) init.body = sending.body;
    if (sending.signal) init.signal = sending.signal;
    try {
      const response = await this.#fetch(`${this.url}/${path}`, init);
      this.#patience.reached = true;
      return response;
    } catch (error) {
      // Node.js says why there is no answer. A connection that breaks later had reached a server.
      const code = (error as { cause?: { code?: unknown } }).cause?.code;
      if (typeof code === 'string' && !UNREACHED.includes(code)) this.#patience.reached = true;
      throw error;
    }
  }

  async #post(request: Request, key: string, waitS: number): Promise<JobInfo> {
    if (!(request.kind in PATHS)) throw invalid('/kind', `must be one of ${Object.keys(PATHS).join(', ')}`);
    checkUnits(request);
    return this.#submit<JobInfo>(PATHS[request.kind], request, key, waitS);
  }

  async #submit<T>(path: string, body: unknown, key: string, waitS: number): Promise<T> {
    const headers: Record<string, string> = { 'Content-Type': 'application/json', 'Idempotency-Key': key };
    if (waitS > 0) headers['Prefer'] = `wait=${waitS}`;
    try {
      return parsed<T>(await this.send(path, { method: 'POST', headers, body: toJson(body) }));
    } catch (error) {
      if (error instanceof ConnectionFailed) error.idempotencyKey = key;
      throw error;
    }
  }

  /** Cancels a job whose submission is not answered yet: at once by its key, and again when the answer is there. */
  async #giveUp(posted: Promise<JobInfo>, key: string): Promise<void> {
    try {
      for await (const job of this.jobs({ idempotency_key: key })) await this.cancel(job.id);
      const job = await posted;
      if (!hasEnded(job.status)) await this.cancel(job.id);
    } catch {
      // The submission was refused, or the server cannot be reached: nothing runs that could be cancelled from here.
    }
  }
}

/**
 * Solves a stream of requests of which only the newest counts. Its requests name one series (`supersede`), so the server
 * cancels the older jobs of the series when it accepts a newer request.
 */
export class Live {
  readonly #client: Plateau;
  readonly #series = randomKey();
  #newest = new AbortController();
  /** Requests are sent one after the other, because the server counts the last to arrive as the newest. */
  #sent: Promise<unknown> = Promise.resolve();
  /** The last job that the server accepted. */
  #accepted: JobInfo | undefined;

  constructor(client: Plateau) {
    this.#client = client;
  }

  /** The mesh, or null if a newer request came before it was there. */
  async solve<R extends Request>(
    request: R, control: Omit<SolveControl, 'signal'> = {},
  ): Promise<Result<StatisticsOf<R>> | null> {
    this.#newest.abort();
    const own = (this.#newest = new AbortController());
    const submitting = this.#sent.then(() => this.#submit(request, own.signal));
    this.#sent = submitting.catch(() => undefined);
    try {
      let job = await submitting;
      if (!job) return null;
      job = await this.#client.waitFor(job, { ...control, signal: own.signal });
      if (own.signal.aborted) return null;
      return await this.#client.resultOf<StatisticsOf<R>>(job, own.signal, request);
    } catch (error) {
      if (own.signal.aborted) return null;
      // Nobody waits for this job any more: the request was refused, or its caller's function failed.
      if (!(error instanceof ConnectionFailed)) await this.#cancel();
      throw error;
    }
  }

  /** Cancels the newest request; its `solve` returns null. */
  stop(): void {
    this.#newest.abort();
    void this.#sent.then(() => this.#cancel());
  }

  /** Submits a request, unless a newer one came while it waited for its turn. */
  async #submit(request: Request, signal: AbortSignal): Promise<JobInfo | null> {
    if (signal.aborted) return null;
    const job = await this.#client.submit({ ...request, supersede: this.#series });
    return (this.#accepted = job.info);
  }

  async #cancel(): Promise<void> {
    const job = this.#accepted;
    this.#accepted = undefined;
    if (job && !hasEnded(job.status)) await this.#client.cancel(job.id).catch(() => undefined);
  }
}

/** The origin of the page that runs this; undefined outside of browsers. */
function origin(): string | undefined {
  return (globalThis as { location?: { origin?: string } }).location?.origin;
}

function parsed<T>(json: ArrayBuffer): T {
  return JSON.parse(new TextDecoder().decode(json)) as T;
}

/** A key that nobody else has. Pages without TLS have no `crypto.randomUUID`. */
function randomKey(): string {
  return Array.from(crypto.getRandomValues(new Uint8Array(16)), (byte) => byte.toString(16).padStart(2, '0')).join('');
}
