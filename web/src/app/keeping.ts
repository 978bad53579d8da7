// What survives a reload: the document with its camera, and the jobs of this browser with their drawings.

import type { JobInfo, Kind } from 'plateau-client';
import { Frame } from '../model/frame';
import { KINDS, type Request, type Vec3 } from '../model/request';
import { isOfPage } from '../solvers';
import type { Pose } from '../stage/stage';
import type { Asked, Life } from './life';
import { toast } from './notes';
import { doc, embedded, host, isStale, later, session, stage } from './session';

const WORK = 'plateau.work', RECENT = 'plateau.recent';
const PAUSE_MS = 250;
/** A drawing of more characters is not kept with the list of recent jobs, which holds at most so many. */
const MOST_CHARACTERS = 200_000, MOST_RECENT = 20;

/** A document as it is kept, and as a link holds it. `phase` is how far its request had come, and `job` its job. */
export interface Kept {
  kind: Kind; request: Request; draft?: Vec3[] | null; title?: string | null; camera?: Pose; colour?: string; phase?: Life['phase']; job?: string | null;
}

export const isKept = (found: unknown): found is Kept => {
  const { kind, request } = (found ?? {}) as Partial<Kept>;
  return kind !== undefined && kind in KINDS && request !== null && typeof request === 'object';
};

let timer = 0;
let warned = false;

/** Keeps the document a moment later. */
export function keep(): void {
  clearTimeout(timer);
  timer = window.setTimeout(keepNow, PAUSE_MS);
}

export function keepNow(): void {
  if (embedded || !session.ready) return;
  const { kind, request, draft, title } = doc();
  const { requests: { life, job: own }, shown } = session;
  // A request that was asked for before an edit says nothing of the document as it is now.
  const isOwn = life.phase !== 'idle' && life.asked.kind === kind && life.asked.request === JSON.stringify(request);
  const phase = isOwn ? life.phase : 'idle';
  // The service knows no job of this page, and may have taken its result over meanwhile.
  const known = isOwn && own && !isOfPage(own) ? own : isStale() ? null : shown?.job;
  const job = known && !isOfPage(known) ? known.id : null;
  const kept: Kept = { kind, request, draft, title, camera: worldPose(), colour: session.colour, phase, job };
  const text = JSON.stringify(kept);
  try {
    sessionStorage.setItem(WORK, text);
    localStorage.setItem(WORK, text);
  } catch {
    // A drawing larger than the browser keeps is still in the page; it is only not there after a reload.
    if (!warned) toast('This drawing is too large to be kept by the browser: save it as a file.');
    warned = true;
  }
  later.parts?.pictureRecent();
}

/** What was being worked on in this tab, else in the last one. */
export function kept(): Kept | null {
  try {
    const found: unknown = JSON.parse(sessionStorage.getItem(WORK) ?? localStorage.getItem(WORK) ?? 'null');
    return isKept(found) ? found : null;
  } catch {
    return null;
  }
}

// ---- Camera ----

/** The camera in metres from the coordinates' zero, so that it does not depend on the stage's own origin. */
export function worldPose(): Pose {
  const { eye, target } = stage.pose();
  const shift = new Frame([0, 0, 0], doc().request).toScene(host.frame.origin);
  return { eye: eye.map((value, axis) => value + shift[axis]!) as Vec3, target: target.map((value, axis) => value + shift[axis]!) as Vec3 };
}

/** Puts the camera where a link or the last visit had it; the first result leaves it there. */
export function placeWorld({ eye, target }: Pose): void {
  session.cameraGiven = true;
  const shift = new Frame([0, 0, 0], doc().request).toScene(host.frame.origin);
  stage.place({ eye: eye.map((value, axis) => value - shift[axis]!) as Vec3, target: target.map((value, axis) => value - shift[axis]!) as Vec3 }, false);
  stage.rememberWhetherAllIsSeen();
}

// ---- Recent jobs ----

/** `picture`: the result as a small WebP, in base64. */
export interface RecentJob { id: string; title: string | null; kind: Kind; request: string; picture?: string }

export function recentJobs(): RecentJob[] {
  try {
    return JSON.parse(localStorage.getItem(RECENT) ?? '[]') as RecentJob[];
  } catch {
    return [];
  }
}

export function rememberJob(job: JobInfo, { request, title }: Asked): void {
  if (embedded || request.length > MOST_CHARACTERS) return;
  const before = recentJobs();
  const picture = before.find(({ id }) => id === job.id)?.picture;
  keepRecent([{ id: job.id, title, kind: job.kind, request, ...(picture && { picture }) }, ...before.filter(({ id }) => id !== job.id)]);
}

export function keepRecent(list: RecentJob[]): void {
  try {
    localStorage.setItem(RECENT, JSON.stringify(list.slice(0, MOST_RECENT)));
  } catch {
    localStorage.removeItem(RECENT);
  }
}
