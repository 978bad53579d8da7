// The jobs of this server: each with its drawing where this browser knows it, else the mesh alone.

import type { JobInfo } from 'plateau-client';
import { plateau } from '../api';
import { $, el } from '../dom';
import { Frame } from '../model/frame';
import { KINDS, type Request, type Vec3 } from '../model/request';
import { parseMesh, type ResultMesh } from '../stage/mesh';
import { opening } from './busy';
import { replace, showDocument } from './document';
import { redraw } from './drawing';
import { type RecentJob, recentJobs } from './keeping';
import { say } from './notes';
import { showProblem } from './problems';
import { forget, show } from './result';
import { FIRST_VIEW, host, session, stage } from './session';
import { abandon, adopt } from './solving';

export async function showRecent(): Promise<void> {
  const box = $('recent-list');
  box.replaceChildren(el('p', { className: 'quiet' }, 'Asking the server…'));
  $<HTMLDialogElement>('recent').showModal();
  try {
    const { jobs } = await plateau.getJson<{ jobs: JobInfo[] }>('v1/jobs?limit=30');
    const known = new Map(recentJobs().map((each) => [each.id, each]));
    const rows = jobs.map((job) => {
      const mine = known.get(job.id);
      const open = el('button', { type: 'button', disabled: !['succeeded', 'running', 'queued'].includes(job.status) }, 'Open');
      open.setAttribute('aria-label', `Open ${mine?.title ?? job.kind} of ${job.created_at}`);
      open.addEventListener('click', () => {
        $<HTMLDialogElement>('recent').close();
        void openJob(job, mine);
      });
      return el('tr', {}, el('th', { scope: 'row' }, mine?.title ?? KINDS[job.kind].label), el('td', {}, job.status), el('td', {}, new Date(job.created_at).toLocaleString()), el('td', {}, open));
    });
    box.replaceChildren(rows.length > 0 ? el('table', { className: 'plain' }, el('tbody', {}, ...rows)) : el('p', { className: 'quiet' }, 'No jobs yet.'));
  } catch (error) {
    box.replaceChildren(el('p', { className: 'fault' }, error instanceof Error ? error.message : String(error)));
  }
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
