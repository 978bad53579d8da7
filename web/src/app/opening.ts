// Other documents: examples, files, links, recent jobs, and the drawing of another kind. What is fetched first keeps the page
// busy from the press on.

import type { JobInfo, Kind } from 'plateau-client';
import { plateau, published } from '../api';
import { $, el } from '../dom';
import { FileFault, type Polyline } from '../files/lines';
import { parseJson } from '../files/json';
import type { Opened } from '../files/open';
import { Frame } from '../model/frame';
import { kindOf, KINDS, isWhole, metresOf, type Request, type Vec3 } from '../model/request';
import { unpack } from '../panels/share';
import { parseMesh, type ResultMesh } from '../stage/mesh';
import { count } from '../text';
import { opening } from './busy';
import { changed, isLive, replace, showDocument, startBlank } from './document';
import { redraw } from './drawing';
import { isKept, type Kept, placeWorld, type RecentJob, recentJobs } from './keeping';
import { say, toast } from './notes';
import { showProblem } from './problems';
import { forget, show } from './result';
import { doc, embedded, FIRST_VIEW, host, server, session, stage } from './session';
import { abandon, adopt } from './solving';

// ---- Examples and kinds ----

export interface Example { kind: Kind; title: string; request: Request }

export const fetchExample = (name: string): Promise<Example> => published<Example>(`v1/examples/${encodeURIComponent(name)}`);

export const openExample = (name: string): Promise<void> => opening(() => fetchExample(name), (example) => {
  const { kind: _, ...request } = example.request;
  forget();
  replace(example.kind, request, example.title);
  changed();
  if (!isLive()) say('Ready.');
}, showProblem);

/** What was last drawn of each kind, to come back to. */
const drafts = new Map<Kind, { request: Request; title: string | null }>();
/** The example that a kind begins with. Its result has no warning. */
const FIRST_OF: Partial<Record<Kind, string>> = { ruled_surface: 'wavy-strip', uniform_mesh: 'courtyard', tensile_structure: 'four-point-sail', cable_net: 'four-cables' };

export function switchKind(kind: Kind): void {
  const before = doc();
  if (before.kind === kind) return;
  drafts.set(before.kind, { request: structuredClone(before.request), title: before.title });
  const own = drafts.get(kind);
  const first = server.examples.find((each) => each.kind === kind);
  if (own) {
    replace(kind, own.request, own.title);
    changed();
  } else if (first) void openExample(FIRST_OF[kind] ?? first.name);
  else startBlank(kind);
}

// ---- Files and text ----

/** A file, or a text that was dropped or pasted. */
export const take = (read: () => Promise<Opened>, name: string): Promise<void> => opening(read, (opened) => {
  if ('lines' in opened) takeLines(opened.lines, opened.format, opened.metres, name);
  else takeRequest(opened.request, name);
}, (error, turn) => showProblem({ title: name ? `${name} cannot be opened` : 'This cannot be opened', detail: error instanceof Error ? error.message : String(error) }, turn));

/** A file's polylines become the drawing; options stay. */
function takeLines(lines: Polyline[], format: string, metres: boolean, name: string): void {
  const { kind, request } = doc();
  const { line, least } = KINDS[kind];
  const factor = metres ? 1 / metresOf(request) : 1;
  const own = lines.map(({ points }) => points.map(([x, y, z]): Vec3 => {
    const turned: Vec3 = metres && request.up !== 'y' ? [x, -z, y] : [x, y, z];
    return metres ? turned.map((value) => Number((value * factor).toPrecision(9))) as Vec3 : turned;
  }));
  const short = own.findIndex((points) => points.length < (kind === 'ruled_surface' ? 1 : least));
  if (short >= 0) throw new FileFault(`Line ${short + 1} of the file has ${count(own[short]!.length, 'point')}; a ${line} needs ${least}.`);
  const next: Request = { ...structuredClone(request) };
  for (const field of ['normals', 'tangents', 'constraints', 'cables', 'free_points', 'supports']) delete next[field];
  // The file has no normals, without which this objective cannot be solved.
  if (next.objective === 'minimal_normal_variation') delete next.objective;
  if (typeof next.initial_mesh === 'object') delete next.initial_mesh;
  if (kind === 'ruled_surface') Object.assign(next, { directrices: own, closed: lines.length > 1 && lines.every(({ closed }) => closed) });
  else if (kind === 'minimal_surface' || kind === 'tensile_structure') next.boundaries = own;
  else if (kind === 'cable_net') Object.assign(next, netOf(lines.map(({ closed }, i) => (closed ? [...own[i]!, own[i]![0]!] : own[i]!))), { cables: [{ force_density: 1 }], loads: [] });
  else {
    const bySize = [...own].sort((a, b) => extent(b) - extent(a));
    next.domain = { polygon: bySize[0], ...(bySize.length > 1 && { holes: bySize.slice(1) }) };
  }
  replace(kind, next, name || `${format} drawing`);
  changed();
  toast(`${format}: ${count(own.length, 'line')}, ${count(own.reduce((sum, points) => sum + points.length, 0), 'point')}. Undo brings back what was there.`);
}

/** A net whose edges are the segments of lines. Equal points are joined, and the points with the fewest edges are supports. */
function netOf(lines: Vec3[][]): { vertices: Vec3[]; edges: [number, number][]; supports: number[] } {
  const numbers = new Map<string, number>();
  const vertices: Vec3[] = [], counts: number[] = [];
  const number = (point: Vec3): number => {
    const key = point.join(' ');
    const known = numbers.get(key) ?? vertices.length;
    if (known === vertices.length) {
      numbers.set(key, known);
      vertices.push(point);
      counts.push(0);
    }
    counts[known]! += 1;
    return known;
  };
  const edges = lines.flatMap((line) => line.slice(1).map((point, i): [number, number] => [number(line[i]!), number(point)]));
  const fewest = Math.min(...counts);
  return { vertices, edges, supports: vertices.map((_, v) => v).filter((v) => counts[v] === fewest) };
}

const extent = (points: Vec3[]): number => {
  const spans = [0, 1, 2].map((axis) => Math.max(...points.map((point) => point[axis]!)) - Math.min(...points.map((point) => point[axis]!)));
  return Math.hypot(...spans);
};

function takeRequest(request: Request, title: string | null): void {
  const { kind: named, ...rest } = request;
  const kind = kindOf(request) ?? doc().kind;
  if (named !== undefined && !(String(named) in KINDS)) throw new FileFault(`This server has no kind ${JSON.stringify(named)}.`);
  replace(kind, rest, title);
  changed();
}

/** The request that was written by hand. */
export function applyRequest(): void {
  const fault = (text: string): void => {
    $('request-fault').textContent = text;
    $('request-fault').hidden = false;
  };
  try {
    const request = parseJson($<HTMLTextAreaElement>('request').value) as Request;
    if (request === null || typeof request !== 'object' || Array.isArray(request)) {
      fault('A request is an object, { … }.');
      return;
    }
    takeRequest(request.kind !== undefined || kindOf(request) ? request : { ...request, kind: doc().kind }, doc().title);
    $<HTMLFormElement>('request-form').reset();
  } catch (error) {
    fault(error instanceof Error ? error.message : String(error));
  }
}

// ---- Links ----

/** What the link in the address holds; null without one, and, said in a note, for a damaged one. */
export async function linked(): Promise<Kept | null> {
  const [, packed] = /^#s=(.+)$/.exec(location.hash) ?? [];
  if (!packed) return null;
  try {
    const found = await unpack(packed);
    if (!embedded) window.history.replaceState(null, '', location.pathname + location.search);
    if (isKept(found)) return found;
  } catch {
    // Said below.
  }
  toast('This link is damaged: it does not hold a request.');
  return null;
}

/** Opens a link that was put into the address of an open studio: only the hash changes. */
export const openLink = (): Promise<void> => opening(linked, (found) => {
  if (!found) return;
  const { kind, request, title, camera, colour } = found;
  forget();
  session.colour = colour ?? 'plain';
  replace(kind, request, title ?? null);
  if (camera) placeWorld(camera);
  changed();
  if (!isWhole(kind, request)) say('');
}, showProblem);

// ---- Recent jobs ----

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
    forget();
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
  stage.fit(false, FIRST_VIEW);
  showDocument();
}
