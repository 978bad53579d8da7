// From the document to a result: one job at a time, live, with its progress, and cancelled on demand.

import * as api from '../api/client';
import type { Job } from '../api/client';
import { $ } from '../dom';
import { KINDS } from '../model/request';
import { charts, phaseName, type Sample } from '../panels/chart';
import { parseMesh } from '../stage/mesh';
import { duration, number } from '../text';
import { whileBusy } from './busy';
import { keep, rememberJob } from './keeping';
import { say } from './notes';
import { hideProblem, showProblem } from './problems';
import { show, showStale, toleranceOf } from './result';
import { doc, type Run, session } from './session';

/** In live mode, a job that takes longer than this is cancelled when its input has changed. */
const PATIENCE_MS = 2000;
/** A job of less than this needs no progress bar: one that blinks disturbs. */
const BAR_AFTER_MS = 300;

type Submit = (run: Run) => Promise<Job>;
/** Where the next run gets its job: from the document as it is then, or from a job that is there already. */
let next: Submit | null = null;
let barTimer = 0;

/** Solves the document; in live mode what changed meanwhile is solved next. */
export const solve = (): Promise<void> => start(({ kind, request }) => api.submit(KINDS[kind].path, JSON.parse(request)));

/** Follows a job that belongs to the document as it is: after a reload, or from the list of recent jobs. */
export const adopt = (job: Job): Promise<void> => start(() => Promise.resolve(job));

/** One job at a time: while one runs, the last that was asked for waits. */
async function start(submit: Submit): Promise<void> {
  next = submit;
  const { run } = session;
  if (run) {
    if (run.generation !== session.generation || performance.now() - run.since > PATIENCE_MS) void cancel();
    return;
  }
  await whileBusy(async () => {
    showRunning(true);
    while (next) {
      const from = next;
      next = null;
      const { kind, request, title } = doc();
      const started: Run = {
        job: null, since: performance.now(), cancelled: false, dragging: document.querySelector('canvas:active') !== null,
        request: JSON.stringify(request), kind, title, generation: session.generation,
      };
      session.run = started;
      try {
        await carryOut(started, from);
      } catch (error) {
        if (!next) {
          showProblem(error);
          say('Not solved.');
        }
      } finally {
        session.run = null;
      }
    }
    showRunning(false);
    showStale();
  });
}

/** Takes a job from its submission, or from wherever it is, to its end. */
async function carryOut(run: Run, submit: Submit): Promise<void> {
  if (!run.dragging) say('Solving…');
  session.pendingJob = null;
  run.job = await submit(run);
  hideProblem();
  if (run.cancelled) run.job = await api.cancel(run.job);
  if (!api.hasEnded(run.job)) run.job = await follow(run.job);
  session.pendingJob = null;
  const { job } = run;
  if (job.status === 'failed') {
    if (next) return;
    showProblem(job.error ?? {});
    say('Not solved.');
  } else if (job.status === 'cancelled') {
    if (!next) say('Cancelled.');
  } else {
    const mesh = await parseMesh(await api.getBytes(`${job.links.mesh}?format=glb`));
    if (run.generation !== session.generation || session.viewing) return;
    const before = session.shown;
    session.lastDuration = (performance.now() - run.since) / 1000;
    show(job, mesh, run.request, run.dragging);
    // A film of a moment within a drag is of no use once it was superseded.
    if (before?.dragging && before.job.id !== job.id) api.remove(before.job).catch(() => {});
    if (!run.dragging) rememberJob(job, run);
  }
  keep();
}

/** Shows how a job gets on until it has ended. */
async function follow(job: Job): Promise<Job> {
  session.pendingJob = job.id;
  keep();
  const samples: Sample[] = [];
  const since = Date.now();
  const ticking = window.setInterval(() => showProgress(null, samples, since), 500);
  showProgress(null, samples, since, job.status === 'queued' ? 'Waiting in the queue' : 'Running');
  try {
    return await api.follow(job, (progress) => {
      const last = samples.at(-1);
      if (!last || last.iteration !== progress.iteration || last.phase !== progress.phase) {
        samples.push({ iteration: progress.iteration, phase: progress.phase, value: progress.objective_value ?? null, residual: progress.residual ?? null });
      }
      showProgress(progress, samples, since);
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

function showProgress(progress: api.Progress | null, samples: Sample[], since: number, text?: string): void {
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
  void cancel();
}

/** Cancels on the server; a job that is still being submitted, as soon as it has an id. */
async function cancel(): Promise<void> {
  const { run } = session;
  if (!run) return;
  run.cancelled = true;
  if (!run.job) return;
  try {
    await api.cancel(run.job);
  } catch (error) {
    showProblem(error);
  }
}
