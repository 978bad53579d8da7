// From the document to a result: one request at a time, live, with its progress, and cancelled on demand.

import { ConnectionFailed, hasEnded, type JobInfo, JobFailed, type Kind, NotFound, type Progress, type Request as ApiRequest } from 'plateau-client';
import { isStatic, plateau } from '../api';
import { $ } from '../dom';
import type { Request } from '../model/request';
import type { Sample } from '../panels/chart';
import { isLoaded, isOfPage, isRefused, isUnusable, meshOfJob, MOST_TRIANGLES, moveHere, prepare, solveHere, solvesHere } from '../solvers';
import type { ResultMesh } from '../stage/mesh';
import { duration, humanise, number } from '../text';
import { ask, whileBusy } from './busy';
import { keep, keepNow, rememberJob } from './keeping';
import type { Asked, Source } from './life';
import { showPattern } from './modes';
import { say } from './notes';
import { hideProblem, showProblem } from './problems';
import { nameJob, show, showStale, toleranceOf } from './result';
import { doc, later, session } from './session';

/** In live mode, a job that takes longer than this is cancelled when its input has changed. */
const PATIENCE_MS = 2000;
/** A job of less than this needs no progress bar: one that blinks disturbs. */
const BAR_AFTER_MS = 300;
/** Seconds that the answer to a submission waits for the end, so that a quick job comes back finished. */
const SHORT_WAIT_S = 1;

/** A result of this page is handed on to the service once it has been shown for so long, and again after a failure. */
const HAND_AFTER_MS = 800, HAND_AGAIN_MS = 5000;

const { requests } = session;
let barTimer = 0;
let keepTimer = 0;
let patienceTimer = 0;

const submit = async (kind: Kind, request: string): Promise<JobInfo> =>
  (await plateau.submit({ ...JSON.parse(request) as object, kind } as ApiRequest, { waitS: SHORT_WAIT_S })).info;

/** The service behind this page. Without a connection the page solves what it can. */
const service: Source = {
  submit: async (asked) => {
    const { kind, request } = asked;
    if (isStatic) return inPage(asked);
    try {
      const job = await submit(kind, request);
      showKept('kept');
      return job;
    } catch (error) {
      if (!(error instanceof ConnectionFailed) || !isLoaded(kind)) throw error;
      showKept('lost');
      return inPage(asked);
    }
  },
  follow: (job, asked) => follow(job, asked),
  mesh: (job, { stop }) => meshOfJob(job, stop.signal),
  cancel: (job) => plateau.cancel(job.id),
};

/**
 * The solvers within this page. The service takes their place where they cannot be loaded, and says of a refused
 * request all that is wrong. A refused move of a drag has the page's own words, because the next move follows at once.
 */
const here: Source = {
  ...service,
  submit: async (asked) => {
    try {
      return await inPage(asked);
    } catch (error) {
      if (isStatic || !(isUnusable(error) || (isRefused(error) && !asked.dragging))) throw error;
      return service.submit(asked);
    }
  },
};

/** Solves a request in this page, with its progress. */
async function inPage(asked: Asked): Promise<JobInfo> {
  const { kind, dragging, stop: { signal } } = asked;
  const request = JSON.parse(asked.request) as Request;
  if (dragging) return moveHere(kind, request, { signal });
  const progress = reporter(asked);
  try {
    return await solveHere(kind, request, { signal, onProgress: progress.add });
  } finally {
    progress.end();
  }
}

/**
 * Solves the document. In live mode what changed meanwhile is solved next. Where `live` is true, somebody is at work on
 * the document, and the page solves it itself if it can; all other requests go to the service.
 */
export function solve({ dragging = false, live = false } = {}): Promise<void> {
  return request(live && isForHere() ? here : service, dragging);
}

/**
 * Whether the page solves the document while somebody works on it. Where its last result was large, the next one will
 * be, too.
 */
function isForHere(): boolean {
  const { kind, request: document } = doc();
  const { shown } = session;
  return solvesHere(kind, document) && !(shown?.job.kind === kind && shown.mesh.geometry.index!.count > 3 * MOST_TRIANGLES);
}

/** Whether moves of this document are followed however long a solve takes. */
export const follows = (): boolean => doc().kind === 'minimal_surface' && isForHere();

/** Follows a job that belongs to the document as it is, such as one from the list of recent jobs. */
export const adopt = (job: JobInfo): Promise<void> => request({ ...service, submit: () => Promise.resolve(job) });

/**
 * Goes on with the job of a document from the last visit. The document is solved anew if the service no longer has its
 * job.
 */
export const resumeJob = (id: string): Promise<void> => request({
  ...service,
  submit: (asked) => plateau.getJson<JobInfo>(`v1/jobs/${id}`).catch((error: unknown) => {
    if (error instanceof NotFound) return service.submit(asked);
    throw error;
  }),
});

/** Asks for a result of the document as it is now. While a request is under way, the last that was asked for waits. */
async function request(source: Source, dragging = false): Promise<void> {
  const { kind, request: document, title } = doc();
  const asked: Asked = { turn: ask(), kind, request: JSON.stringify(document), title, dragging, since: performance.now(), stop: new AbortController(), source };
  const before = requests.underWay;
  if (requests.ask(asked)) await begin(asked);
  else if (before) {
    clearTimeout(patienceTimer);
    patienceTimer = window.setTimeout(() => void giveWay(before), before.since + PATIENCE_MS - performance.now());
  }
}

/** Takes the request that has just become the current one to its end. */
const begin = (asked: Asked): Promise<void> => whileBusy(async () => {
  clearTimeout(patienceTimer);
  asked.since = performance.now();
  showRunning(true, asked.dragging);
  if (!asked.dragging) say('Solving…');
  try {
    await carryOut(asked);
  } catch (error) {
    if (requests.enter({ phase: 'failed', asked, job: requests.job, error })) {
      if (!requests.hasWaiting) {
        showProblem(error, asked.turn);
        say('Not solved.');
      }
      goOn();
    }
  }
});

/** After the end of a request: the one that waited begins, or the page rests. */
function goOn(): void {
  const next = requests.next();
  if (next) {
    void begin(next);
    return;
  }
  clearTimeout(patienceTimer);
  showRunning(false);
  showStale();
  keep();
}

/** Waits for an answer, unless the request is stopped first. */
const unlessStopped = <T>(answer: Promise<T>, { signal }: AbortController): Promise<T> => new Promise((resolve, reject) => {
  signal.addEventListener('abort', () => reject(signal.reason as Error), { once: true });
  answer.then(resolve, reject);
});

async function carryOut(asked: Asked): Promise<void> {
  const { source, stop } = asked;
  const submission = source.submit(asked);
  // A job that is accepted after its request was given up is cancelled then.
  submission.then((job) => { if (stop.signal.aborted) void endJob(asked, job).catch(() => {}); }, () => {});
  let job = await unlessStopped(submission, stop);
  if (!requests.isCurrent(asked)) return;
  hideProblem(asked.turn);
  if (!hasEnded(job.status)) {
    requests.enter({ phase: 'running', asked, job });
    keep();
    job = await source.follow(job, asked);
  }
  if (job.status === 'failed') {
    if (requests.life.phase === 'submitting') requests.enter({ phase: 'running', asked, job });
    throw new JobFailed(job);
  }
  if (job.status === 'cancelled') {
    if (requests.enter({ phase: 'cancelled', asked })) {
      if (!requests.hasWaiting) say('Cancelled.');
      goOn();
    }
    return;
  }
  const mesh = await unlessStopped(source.mesh(job, asked), stop);
  if (requests.enter({ phase: 'shown', asked, job })) {
    present(asked, job, mesh);
    goOn();
  }
}

function present(asked: Asked, job: JobInfo, mesh: ResultMesh): void {
  const before = session.shown;
  clearTimeout(keepTimer);
  session.lastDuration = (performance.now() - asked.since) / 1000;
  show(job, mesh, asked.request, asked.dragging);
  // A film of a moment within a drag is of no use once it was superseded.
  if (before?.dragging && before.job.id !== job.id && !isOfPage(before.job)) plateau.delete(before.job.id).catch(() => {});
  if (!isOfPage(job)) {
    if (!asked.dragging) rememberJob(job, asked);
    void prepare(job.kind);
  } else if (!asked.dragging && !isStatic) keepTimer = window.setTimeout(() => void hand(asked), HAND_AFTER_MS);
}

/** Hands a result of this page on to the service, whose job then belongs to it, with a place among the recent jobs. */
async function hand(asked: Asked): Promise<void> {
  const { shown } = session;
  const isShown = (): boolean => session.shown === shown && shown !== null && shown.solved === asked.request;
  if (!isShown()) return;
  try {
    const first = await submit(asked.kind, asked.request);
    const job = hasEnded(first.status) ? first : await plateau.waitFor(first);
    showKept('kept');
    if (job.status !== 'succeeded') return;
    rememberJob(job, asked);
    if (!isShown()) return;
    shown!.job = job;
    nameJob(job);
    showPattern();
    keep();
  } catch (error) {
    // A service that refuses now or is busy keeps nothing either. The result stays, and the next one is handed on
    // again.
    showKept('lost');
    if (error instanceof ConnectionFailed && isShown()) keepTimer = window.setTimeout(() => void hand(asked), HAND_AGAIN_MS);
  }
}

/** A quiet sign for as long as the service cannot be reached. */
function showKept(state: 'kept' | 'lost'): void {
  $('unkept').hidden = state === 'kept';
}

const endJob = (asked: Asked, job: JobInfo | null): Promise<unknown> => (job && !hasEnded(job.status) ? asked.source.cancel(job) : Promise.resolve());

/** Ends a request that is under way, and its job. Gives null if the request is no longer under way. */
function end(asked: Asked): Promise<unknown> | null {
  const { job } = requests;
  if (!requests.enter({ phase: 'cancelled', asked })) return null;
  asked.stop.abort();
  return endJob(asked, job);
}

/** Makes room for the request that waits, which does not wait for the end of this one's job. */
function giveWay(asked: Asked): void {
  const ending = end(asked);
  if (!ending) return;
  ending.catch(() => {});
  goOn();
}

/** Ends the request under way, and forgets the one that waits, because another document takes the place of theirs. */
export function abandon(): void {
  requests.dropWaiting();
  const { underWay } = requests;
  if (!underWay) return;
  giveWay(underWay);
  say('');
}

/** Cancels the request under way, and what would come after it. */
export function giveUp(): void {
  requests.dropWaiting();
  const { underWay } = requests;
  if (!underWay) return;
  const ending = end(underWay);
  goOn();
  // A reload finds that it was cancelled, even at once.
  keepNow();
  const { life } = requests;
  say('Cancelling…');
  void whileBusy(async () => {
    try {
      await ending;
      if (requests.life === life) say('Cancelled.');
    } catch (error) {
      showProblem(error, underWay.turn);
      if (requests.life === life) say('Not cancelled.');
    }
  });
}

/** Shows how a request gets on until `end` is called. */
function reporter(asked: Asked, text = 'Solving'): { add: (progress: Progress) => void; connect: (now: boolean) => void; end: () => void } {
  const samples: Sample[] = [];
  const since = Date.now();
  let connected = true;
  const report = (progress: Progress | null, text?: string): void => {
    if (!requests.isCurrent(asked)) return;
    if (connected) showProgress(progress, samples, since, text);
    else say(`Connection interrupted, the job goes on, reconnecting · ${duration((Date.now() - since) / 1000)}`);
  };
  const ticking = window.setInterval(() => report(null), 500);
  report(null, text);
  return {
    connect: (now) => {
      connected = now;
      report(null);
    },
    add: (progress) => {
      const last = samples.at(-1);
      if (!last || last.iteration !== progress.iteration || last.phase !== progress.phase) {
        samples.push({ iteration: progress.iteration, phase: progress.phase, value: progress.objective_value ?? null, residual: progress.residual ?? null });
      }
      report(progress);
    },
    end: () => clearInterval(ticking),
  };
}

/** Shows how a job gets on until it has ended. */
async function follow(job: JobInfo, asked: Asked): Promise<JobInfo> {
  const progress = reporter(asked, job.status === 'queued' ? 'Waiting in the queue' : 'Running');
  try {
    return await plateau.waitFor(job, { signal: asked.stop.signal, onConnection: progress.connect, onProgress: progress.add });
  } finally {
    progress.end();
  }
}

/** During a drag, Cancel appears only where a move takes long. */
function showRunning(is: boolean, dragging = false): void {
  if (!is || !dragging) $('cancel').hidden = !is;
  $('running-charts').replaceChildren();
  const bar = $<HTMLProgressElement>('progress');
  clearTimeout(barTimer);
  if (is) {
    bar.removeAttribute('value');
    barTimer = window.setTimeout(() => { bar.hidden = $('cancel').hidden = false; }, BAR_AFTER_MS);
  } else bar.hidden = true;
}

function showProgress(progress: Progress | null, samples: Sample[], since: number, text?: string): void {
  const elapsed = duration((Date.now() - since) / 1000);
  const last = samples.at(-1);
  const bar = $<HTMLProgressElement>('progress');
  if (progress) {
    bar.value = progress.fraction;
    $('running-charts').replaceChildren(...(later.parts?.charts(samples, doc().kind === 'minimal_surface' ? 'Area' : 'Objective', toleranceOf(doc().request)) ?? []));
  }
  const parts = [
    bar.position > 0 && `${Math.round(bar.position * 100)} %`, text ?? (last ? humanise(last.phase) : 'Running'), last && last.iteration > 0 && `iteration ${number(last.iteration)}`, elapsed,
  ];
  say(parts.filter(Boolean).join(' · '));
}
