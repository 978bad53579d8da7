// A finished job: its surface on the stage, its figures, warnings and downloads beside it, and whether it is still
// true.

import type { HistoryRow, JobInfo, MeshFormat, PatternFormat } from 'plateau-client';
import { $, el, save } from '../dom';
import { metresOf, type Request, unitOf, type Vec3 } from '../model/request';
import { showLegend } from '../panels/legend';
import { keyFigures } from '../panels/headlines';
import { fileOf, isOfPage } from '../solvers';
import { hasSurface, type ResultMesh } from '../stage/mesh';
import { firstOf, offered, quantity } from '../stage/quantities';
import { count, duration, fileName } from '../text';
import { ask } from './busy';
import { offerModes, setMode } from './modes';
import { dropReading, say, tagReactions } from './notes';
import { showProblem } from './problems';
import { doc, host, isStale, later, session, sketch, stage, surface } from './session';

/** How long a result may lag behind the drawing before it is shown as out of date. */
const STALE_MS = 450;
let staleTimer = 0;

export function forget(): void {
  session.shown = null;
  session.quantity = null;
  surface.show(null, '', host.frame);
  tagReactions();
  $('result').hidden = true;
  $('nothing').hidden = false;
  $('look').hidden = true;
  $('modes').hidden = true;
  showLegend(null);
  setMode('model');
}

/** Shows a result; `solved` is the request that it belongs to. */
export function show(job: JobInfo, mesh: ResultMesh, solved: string, whileDragging = false): void {
  const first = session.shown === null || session.shown.job.kind !== job.kind;
  const request = JSON.parse(solved) as Request;
  session.shown = { job, mesh, solved, request, dragging: whileDragging };
  dropReading();
  // A structure with cables is first seen by its forces. Another choice stays until another kind is shown.
  if (first && session.colour === 'plain') session.colour = firstOf(mesh);
  choose();
  surface.show(mesh, job.kind, host.frame, session.quantity);
  // The model is fitted into the room that the legend leaves.
  $('look').hidden = false;
  showLayers();
  tagReactions();
  stage.measure();
  stage.rememberWhetherAllIsSeen();
  if (first && !session.cameraGiven) stage.fit(false);
  session.cameraGiven = false;

  $('nothing').hidden = true;
  $('result').hidden = false;
  nameJob(job);
  const values = job.statistics as Record<string, unknown>;
  $('figures').replaceChildren(...keyFigures(job, unitOf(request), sizeOf(mesh, metresOf(request))));
  showReport();
  // STL has only triangles.
  offer($('downloads'), ['glb', 'gltf', 'obj', 'ply', ...(hasSurface(mesh) ? ['stl' as const] : [])], job);
  const pattern = Boolean(job.links.pattern && values.flat_pattern);
  $('pattern-box').hidden = !pattern;
  if (pattern) offer($('pattern-downloads'), ['svg', 'dxf'], job);
  offerModes(job.kind === 'ruled_surface', pattern);
  sayHowItWent(job, mesh);
  showStale();
}

/** The parts of the report that come after the first film. */
export function showReport(): void {
  const { shown } = session;
  if (!later.parts || !shown) return;
  const { job, mesh, request } = shown;
  const unit = unitOf(request);
  const { x, y, z } = surface.group.position;
  const toRequest = (at: Vec3): Vec3 => host.frame.fromScene([at[0] + x, at[1] + y, at[2] + z]);
  const { result, numerics } = later.parts.statistics(job, unit);
  const samples = later.parts.samplesOf((job.statistics as Record<string, unknown>).history as HistoryRow[] | undefined);
  $('charts').replaceChildren(...later.parts.charts(samples, 'Area', toleranceOf(request)));
  $('details').replaceChildren(...later.parts.details(job, { mesh, request, toRequest }, unit, fileName(doc().title) ?? job.kind.replaceAll('_', '-')));
  $('warnings').replaceChildren(...later.parts.warnings(job.warnings, unit));
  $('statistics').replaceChildren(...result);
  $('numbers').replaceChildren(...numerics);
}

/** The extent of a model along x, up and z, in the request's unit. */
function sizeOf({ geometry }: ResultMesh, metres: number): [number, number, number] {
  geometry.computeBoundingBox();
  const { min, max } = geometry.boundingBox!;
  return [max.x - min.x, max.y - min.y, max.z - min.z].map((value) => value / metres) as [number, number, number];
}

/** Names the job of the service that a result belongs to. */
export function nameJob(job: JobInfo): void {
  $('job-id').parentElement!.hidden = isOfPage(job);
  $('job-id').textContent = job.id;
}

/** The residual that a request is solved to, where its kind has one. */
export const toleranceOf = (request: Request): number | null => (typeof request.tolerance === 'number' ? request.tolerance : doc().kind === 'minimal_surface' ? 1e-6 : null);

function sayHowItWent(job: JobInfo, mesh: ResultMesh): void {
  const time = (Date.parse(job.finished_at ?? '') - Date.parse(job.started_at ?? '')) / 1000;
  // The server keeps results: the same request again takes no time.
  const how = time > 0 ? `Solved in ${duration(time)}` : 'Solved';
  const { converged } = job.statistics as { converged?: boolean };
  const segments = mesh.lines.filter(({ name }) => name.startsWith('cables')).reduce((sum, line) => sum + line.segments.length / 6, 0);
  const size = hasSurface(mesh) ? count(mesh.geometry.index!.count / 3, 'triangle') : count(segments, 'edge');
  say(`${how}: ${size}.${converged === false ? ' Not converged.' : ''}`);
}

function offer(box: HTMLElement, formats: (MeshFormat | PatternFormat)[], job: JobInfo): void {
  box.replaceChildren(...formats.map((format) => el('button', {
    type: 'button',
    onclick: async () => {
      const turn = ask();
      try {
        save(new Blob([await fileOf(job, format)]), `${fileName(doc().title) ?? `${job.kind.replaceAll('_', '-')}${isOfPage(job) ? '' : `-${job.id}`}`}.${format}`);
      } catch (error) {
        showProblem(error, turn);
      }
    },
  }, format.toUpperCase())));
}

/** What is shown as a result must be one of the drawing; while a new one is on its way, for a moment it need not be. */
export function showStale(): void {
  const stale = isStale();
  for (const button of document.querySelectorAll<HTMLButtonElement>('#downloads button, #pattern-downloads button')) button.disabled = stale;
  clearTimeout(staleTimer);
  const apply = (): void => {
    $('result').classList.toggle('stale', stale);
    $('stale').hidden = !stale;
    // A line that is being drawn must be seen, also where it runs behind the film.
    surface.setGhost(stale || doc().draft !== null);
    stage.shadow.fade(stale);
    stage.invalidate();
  };
  if (stale && session.requests.underWay && session.lastDuration * 1000 < STALE_MS) staleTimer = window.setTimeout(apply, STALE_MS);
  else apply();
}

// ---- What is looked at ----

/** Shows the surface in the colours of the quantity that was chosen. */
export function showQuantity(): void {
  if (!session.shown) return;
  choose();
  surface.colourBy(session.quantity);
  // The legend takes or leaves room.
  stage.keepInside(false);
}

/** The quantities that the result offers, and the values and legend of the chosen one. */
function choose(): void {
  const { shown } = session;
  if (!shown) return;
  const { mesh, job, request } = shown;
  const list = offered(mesh, job.kind);
  const select = $<HTMLSelectElement>('quantity');
  const has = list.some(({ id }) => id === session.colour);
  // A moment within a drag may have no values. The colours come back with the result at its end.
  if (!has && shown.dragging) {
    session.quantity = null;
    showLegend(null);
    return;
  }
  if (!has) session.colour = 'plain';
  select.replaceChildren(...list.map(({ id, label: name }) => el('option', { value: id }, name)));
  select.value = session.colour;
  session.quantity = quantity(mesh, session.colour, unitOf(request), metresOf(request));
  // The largest force is the line that is seen best, before a dark ground and a bright one.
  if (session.quantity?.id.startsWith('line:') && session.quantity.scale === 'sequential' && document.documentElement.dataset.theme !== 'dark') session.quantity.scale = 'lines';
  showLegend(session.quantity);
}

function showLayers(): void {
  const names: Record<keyof typeof surface.layers, string> = { surface: 'Surface', edges: 'Mesh', lines: 'Lines', reactions: 'Reactions' };
  const mesh = session.shown?.mesh;
  const has = (name: keyof typeof surface.layers): boolean => {
    if (name === 'reactions') return mesh?.lines.some((line) => line.name === 'reactions' && line.segments.length > 0) ?? false;
    return name === 'lines' || !mesh || hasSurface(mesh);
  };
  $('layers').replaceChildren(...(Object.keys(names) as (keyof typeof surface.layers)[]).filter(has).map((name) => {
    const button = el('button', { type: 'button', 'aria-pressed': String(surface.layers[name]) }, names[name]);
    button.addEventListener('click', () => {
      surface.setLayers({ [name]: !surface.layers[name] });
      button.setAttribute('aria-pressed', String(surface.layers[name]));
      tagReactions();
      stage.measure();
      stage.keepInside(true);
    });
    return button;
  }), drawingLayer(), ...moreLayers);
}

/** Buttons of layers that modules loaded later add. */
export const moreLayers: HTMLElement[] = [];

function drawingLayer(): HTMLElement {
  const button = el('button', { type: 'button', 'aria-pressed': String(sketch.group.visible) }, 'Drawing');
  button.addEventListener('click', () => {
    sketch.group.visible = !sketch.group.visible;
    surface.drawn = sketch.group.visible;
    surface.restyle();
    button.setAttribute('aria-pressed', String(sketch.group.visible));
    stage.invalidate();
  });
  return button;
}
