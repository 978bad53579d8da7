// From the document to a result: one job at a time, live, with its progress, and cancelled on demand.

import { hasEnded, type JobInfo, JobFailed, type Progress, type Request as ApiRequest } from 'plateau-client';
import { plateau } from '../api';
import { $ } from '../dom';
import { charts, phaseName, type Sample } from '../panels/chart';
import { parseMesh } from '../stage/mesh';
import { duration, number } from '../text';
import { ask, whileBusy } from './busy';
import { keep, rememberJob } from './keeping';
import { say } from './notes';
import { hideProblem, showProblem } from './problems';
import { show, showStale, toleranceOf } from './result';
import { doc, type Run, session } from './session';

/** In live mode, a job that takes longer than this is cancelled when its input has changed. */
const PATIENCE_MS = 2000;
/** A job of less than this needs no progress bar: one that blinks disturbs. */
const BAR_AFTER_MS = 300;
/** Seconds that the answer to a submission waits for the end, so that a quick job comes back finished. */
const SHORT_WAIT_S = 1;

type Submit = (run: Run) => Promise<JobInfo>;
/** Where the next run gets its job: from the document as it is then, or from a job that is there already. */
let next: { submit: Submit; turn: number } | null = null;
let barTimer = 0;
let patienceTimer = 0;

/** Solves the document; in live mode what changed meanwhile is solved next. */
export const solve = (): Promise<void> => start(async ({ kind, request, stop: { signal } }) => {
  const asked = { ...JSON.parse(request) as object, kind } as ApiRequest;
  return (await plateau.submit(asked, { waitS: SHORT_WAIT_S, signal })).info;
});

/** Follows a job that belongs to the document as it is: after a reload, or from the list of recent jobs. */
export const adopt = (job: JobInfo): Promise<void> => start(() => Promise.resolve(job));

/** One job at a time: while one runs, the last that was asked for waits. */
async function start(submit: Submit): Promise<void> {
  next = { submit, turn: ask() };
  if (session.run) {
    giveWay(session.run);
    return;
  }
  await whileBusy(async () => {
    showRunning(true);
    while (next) {
      const { submit: from, turn } = next;
      next = null;
      const { kind, request, title } = doc();
      const run: Run = {
        job: null, since: performance.now(), stop: new AbortController(), dragging: document.querySelector('canvas:active') !== null,
        request: JSON.stringify(request), kind, title, generation: session.generation,
      };
      session.run = run;
      try {
        await carryOut(run, from, turn).catch((error: unknown) => {
          if (!run.stop.signal.aborted) throw error;
          return cancelled(run);
        });
      } catch (error) {
        if (!next && run.generation === session.generation) {
          showProblem(error, turn);
          say('Not solved.');
        }
      } finally {
        session.run = null;
        clearTimeout(patienceTimer);
        keep();
      }
    }
    showRunning(false);
    showStale();
  });
}

/** A run makes room for the next: at once if the document is another one, else when the patience with it has ended. */
function giveWay({ generation, since, stop }: Run): void {
  clearTimeout(patienceTimer);
  if (generation !== session.generation) stop.abort();
  else patienceTimer = window.setTimeout(() => stop.abort(), since + PATIENCE_MS - performance.now());
}

/** Takes a job from its submission, or from wherever it is, to its end. */
async function carryOut(run: Run, submit: Submit, turn: number): Promise<void> {
  if (!run.dragging) say('Solving…');
  session.pending = null;
  run.job = await submit(run);
  hideProblem(turn);
  if (!hasEnded(run.job.status)) {
    session.pending = { id: run.job.id, kind: run.kind, request: run.request };
    keep();
    run.job = await follow(run.job, run.stop.signal);
    session.pending = null;
  }
  const { job } = run;
  if (job.status === 'failed') throw new JobFailed(job);
  if (job.status === 'cancelled') {
    if (!next) say('Cancelled.');
  } else {
    const mesh = await parseMesh(await plateau.download(job.id, 'glb', run.stop.signal));
    if (run.generation !== session.generation || session.viewing) return;
    const before = session.shown;
    session.lastDuration = (performance.now() - run.since) / 1000;
    show(job, mesh, run.request, run.dragging);
    // A film of a moment within a drag is of no use once it was superseded.
    if (before?.dragging && before.job.id !== job.id) plateau.delete(before.job.id).catch(() => {});
    if (!run.dragging) rememberJob(job, run);
  }
}

/** Shows how a job gets on until it has ended. */
async function follow(job: JobInfo, signal: AbortSignal): Promise<JobInfo> {
  const samples: Sample[] = [];
  const since = Date.now();
  let connected = true;
  const report = (progress: Progress | null, text?: string): void => {
    if (connected) showProgress(progress, samples, since, text);
    else say(`Connection interrupted, the job goes on, reconnecting · ${duration((Date.now() - since) / 1000)}`);
  };
  const ticking = window.setInterval(() => report(null), 500);
  report(null, job.status === 'queued' ? 'Waiting in the queue' : 'Running');
  try {
    return await plateau.waitFor(job, {
      signal,
      onConnection: (now) => {
        connected = now;
        report(null);
      },
      onProgress: (progress) => {
        const last = samples.at(-1);
        if (!last || last.iteration !== progress.iteration || last.phase !== progress.phase) {
          samples.push({ iteration: progress.iteration, phase: progress.phase, value: progress.objective_value ?? null, residual: progress.residual ?? null });
        }
        report(progress);
      },
    });
  } finally {
    clearInterval(ticking);
    $('running-charts').replaceChildren();
  }
}

function showRunning(is: boolean): void {
  $('cancel').hidden = !is;
  const bar = $<HTMLProgressElement>('progress');
  clearTimeout(barTimer);
  if (is) {
    bar.removeAttribute('value');
    barTimer = window.setTimeout(() => { bar.hidden = false; }, BAR_AFTER_MS);
  } else bar.hidden = true;
}

function showProgress(progress: Progress | null, samples: Sample[], since: number, text?: string): void {
  const elapsed = duration((Date.now() - since) / 1000);
  const last = samples.at(-1);
  const bar = $<HTMLProgressElement>('progress');
  if (progress) {
    bar.value = progress.fraction;
    $('running-charts').replaceChildren(...charts(samples, doc().kind === 'minimal_surface' ? 'Area' : 'Objective', toleranceOf(doc().request)));
  }
  const parts = [
    bar.position > 0 && `${Math.round(bar.position * 100)} %`, text ?? (last ? phaseName(last.phase) : 'Running'), last && last.iteration > 0 && `iteration ${number(last.iteration)}`, elapsed,
  ];
  say(parts.filter(Boolean).join(' · '));
}

/** Cancels the job under way, and what would come after it. */
export function giveUp(): void {
  next = null;
  session.run?.stop.abort();
}

/** Cancels on the server the job of a run that was stopped. What comes next does not wait for that. */
async function cancelled({ job }: Run): Promise<void> {
  const cancelling = job && !hasEnded(job.status) ? plateau.cancel(job.id) : Promise.resolve();
  if (next) {
    cancelling.catch(() => {});
    return;
  }
  say('Cancelling…');
  await cancelling;
  session.pending = null;
  say('Cancelled.');
}
