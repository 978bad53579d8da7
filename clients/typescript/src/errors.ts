/** Every way in which a request can fail. */
import type { FieldError, JobInfo, Problem } from './types.js';

/** Base class of all errors of this package. An aborted signal's own reason is passed on as it is. */
export class PlateauError extends Error {
  /** The id of the job that the error is about, if the server had accepted one. `resume` comes back to the job. */
  jobId: string | undefined;

  constructor(message: string, options?: ErrorOptions) {
    super(message, options);
    this.name = new.target.name;
  }
}

interface ProblemFacts {
  title: string;
  detail: string;
  type?: string | undefined;
  /** A wrong value of the body has a pointer, one of the query the name of its parameter. */
  errors?: readonly { pointer?: string | null; parameter?: string | null; detail: string }[] | undefined;
  errors_omitted?: boolean | undefined;
}

/** The server refused a request. The message holds its reason and every pointer. */
export class ProblemError extends PlateauError {
  readonly title: string;
  readonly detail: string;
  readonly type: string;
  /** JSON Pointers (RFC 6901) into the request, or names of parameters, each with what is wrong there. */
  readonly errors: readonly FieldError[];
  /** True if there are more errors than `errors` holds. */
  readonly errorsOmitted: boolean;

  constructor(
    problem: ProblemFacts,
    /** HTTP status, or null if the client itself found the fault. */
    readonly status: number | null = null,
    /** The request's id in the server's log. */
    readonly requestId: string | null = null,
  ) {
    const { title, detail, type = 'about:blank', errors = [], errors_omitted = false } = problem;
    const places = errors.map(({ pointer, parameter, detail: reason }) => ({ pointer: pointer ?? parameter ?? '', detail: reason }));
    const lines = places.map((error) => `\n  ${error.pointer || '(the whole request)'}: ${error.detail}`);
    super(`${title}${detail && `: ${detail}`}${lines.join('')}${errors_omitted ? '\n  … and more' : ''}`);
    this.title = title;
    this.detail = detail;
    this.type = type;
    this.errors = places;
    this.errorsOmitted = errors_omitted;
  }
}

/** Values of the request cannot be used (400, 413, 415, 422, or found before sending). See `errors`. */
export class InvalidRequest extends ProblemError {}
/** The API key is missing or wrong (401), or may not do this (403). */
export class Unauthorized extends ProblemError {}
/** There is no such job, or it has expired (404, 410). */
export class NotFound extends ProblemError {}
/** The queue is full or the rate is used up (429, 503), and stayed so for as long as the client tried again. */
export class Busy extends ProblemError {}
/** The server failed (5xx). */
export class ServerError extends ProblemError {}

/** The solver found no valid mesh. `detail` and `errors` say what was wrong and what to try. */
export class JobFailed extends ProblemError {
  constructor(readonly job: JobInfo) {
    super(job.error ?? { title: 'The job failed', detail: '' });
    this.jobId = job.id;
  }
}

/** The job was cancelled by another than its caller. */
export class JobCancelled extends PlateauError {
  constructor(readonly job: JobInfo) {
    super(`job ${job.id} was cancelled`);
    this.jobId = job.id;
  }
}

/** The server could not be reached for as long as the client tried. A job that it had accepted goes on there. */
export class ConnectionFailed extends PlateauError {
  /** What the server last said of the job. */
  readonly job: JobInfo | undefined;
  /** The key of a submission that got no answer. `submit` with the same request and key makes no second job. */
  idempotencyKey: string | undefined;

  constructor(message: string, { job, ...options }: ErrorOptions & { job?: JobInfo } = {}) {
    super(message, options);
    this.job = job;
    this.jobId = job?.id;
  }
}

/** Gives an error of a step about a job the job's id. */
export async function about<T>(jobId: string | undefined, step: Promise<T>): Promise<T> {
  try {
    return await step;
  } catch (error) {
    if (error instanceof PlateauError) error.jobId ??= jobId;
    throw error;
  }
}

/** Answers of proxies, and of a server that is busy or starts again. */
export const PASSING: readonly number[] = [408, 425, 429, 502, 503, 504];

/** Milliseconds that an answer asks to wait for, or 0. */
export function retryAfterMs(response: Response): number {
  const text = response.headers.get('retry-after') ?? '';
  return /^\d+$/.test(text) ? Math.max(200, 1000 * Number(text)) : 0;
}

const BY_STATUS: Record<number, typeof ProblemError> = {
  400: InvalidRequest, 413: InvalidRequest, 415: InvalidRequest, 422: InvalidRequest,
  401: Unauthorized, 403: Unauthorized, 404: NotFound, 410: NotFound, 429: Busy, 503: Busy,
};

/** The error for an answer that is a failure. */
export function problemOf(response: Response, text: string): ProblemError {
  let problem: ProblemFacts = { title: `HTTP ${response.status}`, detail: text.slice(0, 200) };
  try {
    const found = JSON.parse(text) as Partial<Problem>;
    if (typeof found.title === 'string' && typeof found.detail === 'string') problem = found as Problem;
  } catch {
    // Not a problem document: a proxy answered.
  }
  const Class = BY_STATUS[response.status] ?? (response.status >= 500 ? ServerError : ProblemError);
  return new Class(problem, response.status, response.headers.get('x-request-id'));
}
