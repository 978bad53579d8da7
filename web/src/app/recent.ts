// The jobs of this server: each with its drawing where this browser knows it, else the mesh alone.

import type { JobInfo } from 'plateau-client';
import { plateau } from '../api';
import { $, el } from '../dom';
import { Frame } from '../model/frame';
import { KINDS, linesOf, type Request, type Vec3 } from '../model/request';
import { parseMesh, type ResultMesh } from '../stage/mesh';
import { count } from '../text';
import { opening } from './busy';
import { replace, showDocument } from './document';
import { redraw } from './drawing';
import { keepRecent, type RecentJob, recentJobs } from './keeping';
import { say } from './notes';
import { showProblem } from './problems';
import { forget, show } from './result';
import { FIRST_VIEW, host, isStale, session, stage } from './session';
import { abandon, adopt } from './solving';

export async function showRecent(): Promise<void> {
  const box = $('recent-list');
  box.replaceChildren(el('p', { className: 'quiet' }, 'Asking the server…'));
  $<HTMLDialogElement>('recent').showModal();
  try {
    pictureRecent();
    const { jobs } = await plateau.getJson<{ jobs: JobInfo[] }>('v1/jobs?limit=30');
    const known = new Map(recentJobs().map((each) => [each.id, each]));
    const rows = jobs.map((job) => {
      const mine = known.get(job.id);
      const open = el('button', { type: 'button', disabled: !['succeeded', 'running', 'queued'].includes(job.status) }, 'Open');
      const name = nameOf(job, mine);
      open.setAttribute('aria-label', `Open ${name} of ${job.created_at}`);
      open.addEventListener('click', () => {
        $<HTMLDialogElement>('recent').close();
        void openJob(job, mine);
      });
      return el('tr', {}, el('td', {}, picture(mine)), el('th', { scope: 'row' }, name), el('td', {}, job.status), el('td', {}, new Date(job.created_at).toLocaleString()), el('td', {}, open));
    });
    box.replaceChildren(rows.length > 0 ? el('table', { className: 'plain' }, el('tbody', {}, ...rows)) : el('p', { className: 'quiet' }, 'No jobs yet.'));
  } catch (error) {
    box.replaceChildren(el('p', { className: 'fault' }, error instanceof Error ? error.message : String(error)));
  }
}

/** The name of a job: that of its drawing, else what its client called it, else what is drawn. */
function nameOf(job: JobInfo, mine: RecentJob | undefined): string {
  const { label } = job as { label?: string | null };
  const given = mine?.title ?? label;
  if (given || !mine) return given || KINDS[job.kind].label;
  const lines = linesOf(mine.kind, JSON.parse(mine.request) as Request);
  return `${KINDS[mine.kind].label}: ${count(lines.length, 'line')}, ${count(lines.reduce((sum, { points }) => sum + points.length, 0), 'point')}`;
}

/** Pixels of the pictures of recent jobs: as wide as they are shown on screens with two pixels for one. */
const WIDTH = 144, HEIGHT = 96;

/** The picture of a job, or an empty frame. */
function picture(mine: RecentJob | undefined): HTMLElement {
  if (!mine?.picture) return el('span', { className: 'recent-picture' });
  const url = URL.createObjectURL(new Blob([Uint8Array.from(atob(mine.picture), (letter) => letter.charCodeAt(0))], { type: 'image/webp' }));
  return el('img', { className: 'recent-picture', alt: '', src: url, onload: () => URL.revokeObjectURL(url) });
}

/** The job whose picture is kept, so that the list is not read again after every change. */
let pictured: string | null = null;

/** Keeps a picture of the result that is shown, with its recent job. */
export function pictureRecent(): void {
  const { shown, mode } = session;
  if (!shown || shown.job.id === pictured || isStale() || mode !== 'model' || !stage.renderer) return;
  const list = recentJobs();
  const mine = list.find(({ id }) => id === shown.job.id);
  if (!mine) return;
  pictured = mine.id;
  if (mine.picture) return;
  const small = Object.assign(document.createElement('canvas'), { width: WIDTH, height: HEIGHT });
  const context = small.getContext('2d')!;
  context.imageSmoothingQuality = 'high';
  // The picture of the stage is there until the browser composes the next frame.
  stage.draw();
  const { width, height } = stage.canvas;
  const scale = Math.min(width / WIDTH, height / HEIGHT);
  context.drawImage(stage.canvas, (width - WIDTH * scale) / 2, (height - HEIGHT * scale) / 2, WIDTH * scale, HEIGHT * scale, 0, 0, WIDTH, HEIGHT);
  [, mine.picture] = small.toDataURL('image/webp', 0.7).split(',') as [string, string];
  keepRecent(list);
}

/** With its drawing, where this browser knows it; else the mesh alone. */
const openJob = (listed: JobInfo, mine: RecentJob | undefined): Promise<void> => opening(async () => {
  const job = await plateau.getJson<JobInfo>(`v1/jobs/${listed.id}`);
  const mesh = mine || job.status !== 'succeeded' ? null : await parseMesh(await plateau.download(job.id, 'glb'));
  return { job, mesh };
}, ({ job, mesh }) => {
  if (mine) {
    replace(mine.kind, JSON.parse(mine.request) as Request, mine.title);
    void adopt(job);
  } else if (mesh) viewMesh(job, mesh);
  else say('This job has no result yet, and this browser does not know its drawing.');
}, showProblem);

function viewMesh(job: JobInfo, mesh: ResultMesh): void {
  abandon();
  session.viewing = true;
  forget();
  const { unit, up } = mesh.extras as { unit?: string; up?: string };
  const request: Request = { units: unit, up };
  const [x, y, z] = (mesh.extras.origin as Vec3 | undefined) ?? [0, 0, 0];
  host.frame = new Frame([x, y, z], request);
  redraw();
  show(job, mesh, JSON.stringify(request));
  stage.view(FIRST_VIEW);
  showDocument();
}
