// The drawing on the stage, and the strip below it: what to do next, the line being drawn, or the selected points.

import { $ } from '../dom';
import { cablesOf, stretch } from '../model/cables';
import { findings } from '../model/checks';
import { at, coordinates, isWhole, KINDS, type Request, type Vec3 } from '../model/request';
import { type Found, type Modes, showCable } from '../panels/cable';
import { capital, count } from '../text';
import { doc, embedded, host, server, session, sketch, stage, surface, tools } from './session';

/** The drawing on the stage, with what is wrong with it marked. */
export function redraw(dragging = false): void {
  sketch.group.visible = !session.viewing && !embedded;
  surface.drawn = sketch.group.visible;
  drawLines();
  if (!dragging) {
    host.faulty = new Set([...session.serverFaulty, ...findings(host.lines).flatMap(({ line, points }) => points.map((point) => `${line}/${point}`))]);
    stage.rememberWhetherAllIsSeen();
  }
  tools.refresh();
}

/** What can be placed on a tensile structure. main.ts names the functions, which come after the first film. */
export const rigs = { show: (): void => {}, hint: (): string => '' };

/** The cable that the stage shows as the chosen one. */
let drawnCable = -1;

/** The lines, and the cables along them. */
function drawLines(): void {
  drawnCable = tools.cable;
  const { request, kind } = doc();
  const course = ({ along, across, points }: Partial<ReturnType<typeof cablesOf>[number]>): Vec3[] =>
    (along ? stretch(request, along).map((point) => at(request, ['boundaries', along.boundary ?? 0, point])) : [across ?? points ?? []].flat()).map((point) => coordinates(point) ?? [0, 0, 0]);
  const masts = kind === 'tensile_structure' && !session.viewing && Array.isArray(request.masts) ? request.masts as { points: Vec3[] }[] : [];
  const cables = kind === 'tensile_structure' && !session.viewing ? cablesOf(request) : [];
  const segments = new Set(cables.flatMap(({ along }) => (along ? stretch(request, along).slice(0, -1).map((point) => `${along.boundary ?? 0}/${point}`) : [])));
  sketch.show(session.viewing ? [] : host.lines, doc().draft, host.frame, { courses: [...cables, ...masts].map(course), segments, chosen: tools.cable });
}

/** What a cable can hold constant, of the server's document. */
export function cableModes(): Modes {
  const schemas = (server.openapi as { components?: { schemas?: Record<string, { enum?: string[]; 'x-enum-descriptions'?: string[] }> } }).components?.schemas;
  const { enum: names = ['force'], 'x-enum-descriptions': help } = schemas?.CableMode ?? {};
  return names.map((name, i) => ({ name, help: help?.[i] }));
}

/** A cable, or the chosen one, in the result, if the result is that of the drawing. */
export function foundCable(index = tools.cable): Found | undefined {
  if (!session.shown || session.shown.job.kind !== 'tensile_structure') return undefined;
  const course = (request: Request): string => JSON.stringify(cablesOf(request)[index]?.along);
  if (course(session.shown.request) !== course(doc().request)) return undefined;
  return (session.shown.job.statistics as { cables?: Found[] } | null)?.cables?.[index];
}

export function showDock(): void {
  const { drawing, selection } = tools;
  const introduced = !$('intro').hidden && !drawing && !tools.measuring && selection.length === 0;
  $('intro').hidden = !introduced;
  $('drawing').hidden = !drawing;
  const cable = !drawing && selection.length === 0 ? cablesOf(doc().request)[tools.cable] : undefined;
  if (drawnCable !== tools.cable) {
    drawLines();
    tools.refresh();
  }
  $('measure').setAttribute('aria-pressed', String(tools.measuring));
  $('cabling').hidden = !tools.mayCable;
  $('cabling').setAttribute('aria-pressed', String(tools.cabling));
  rigs.show();
  $('cable').hidden = !cable;
  const points = selection.length > 0 && !tools.cabling;
  $('point').hidden = drawing || !points;
  $('hint').hidden = introduced || drawing || points || cable !== undefined;
  if (cable) showCable(doc().request, cable, tools.cable, cableModes());
  if (drawing) showLine();
  else if (points) showPoint();
  else $('hint').textContent = hint();
}

/** Whether the page is used by fingers, which have no wheel, no right button and no Enter. */
const byTouch = matchMedia('(pointer: coarse)').matches;

export function hint(): string {
  if (session.viewing) return 'The server keeps no drawing of this job: only its mesh is shown. Undo, or any edit, brings your drawing back.';
  if (session.mode === 'compare') return 'Each objective solved on the same rails; the best value of each row is bold. Drag beside the figures to turn all of them.';
  if (tools.measuring) return 'Click a point, a place of the surface or of the ground, and then another: the distance stands between them. Escape ends.';
  if (tools.cabling) return rigs.hint();
  if (session.mode === 'flat') return `The strip unrolled into the plane, to scale. Drag to move it, ${byTouch ? 'pinch' : 'wheel'} to zoom.`;
  if (host.lines.length === 0) return 'Nothing is drawn yet. Press Draw, open a file, or drop one here.';
  if (doc().kind === 'cable_net') return 'Drag a support to move it. The net is given by its request: its vertices, edges and targets.';
  if (!isWhole(doc().kind, doc().request)) return `A strip needs two ${KINDS[doc().kind].line}s: press Draw for the next one.`;
  if (byTouch) return 'Drag a point to move it. One finger beside the points turns the view, two move and zoom it.';
  return 'Drag a point to move it, or press the middle of an edge to add one. Drag the ground to orbit, right-drag to pan, wheel to zoom.';
}

/** What each click of a shape is, where their number is given. */
const STEPS: Record<string, string[]> = {
  arc: ['where the arc begins', 'a point on the arc', 'where the arc ends'], rectangle: ['a corner of the rectangle', 'the opposite corner'], circle: ['the centre of the circle', 'a point on the circle'],
};

/** The line that is being drawn. */
function showLine(): void {
  const { kind, draft } = doc();
  const { line } = KINDS[kind];
  const { least, shape, shapes } = tools;
  const first = kind === 'uniform_mesh' && host.lines.length === 0;
  const n = draft!.length;
  const what = first ? 'polygon' : line;
  const press = byTouch ? 'tap' : 'click';
  const end = byTouch ? 'Finish' : 'Enter';
  const select = $<HTMLSelectElement>('shape');
  for (const option of select.options) option.hidden = option.disabled = !shapes.includes(option.value as typeof shape);
  select.value = shape;
  const steps = STEPS[shape];
  $('drawing-hint').textContent = steps ? `${capital(press)} ${steps[Math.min(n, steps.length - 1)]!}.` : n === 0
    ? `${capital(press)} on the ground to begin the ${what}.`
    : n < least ? `${count(n, 'point')} of the ${what}: ${press} to add more.`
      : kind === 'ruled_surface' ? `${count(n, 'point')}: ${press} to add more, ${end} ends the rail.` : `${count(n, 'point')}: ${press} the first point, or press ${end}, to close the ${what}.`;
  $<HTMLButtonElement>('finish').disabled = n < least;
  $('level-name').textContent = `at ${'xyz'[host.frame.up]}`;
  if (document.activeElement !== $('level')) $<HTMLInputElement>('level').value = String(tools.level);
}

/** Makes a field as wide as its text, so that no digit of a coordinate is cut off. */
export const widen = (input: HTMLInputElement): void => { input.style.width = `calc(${Math.max(1.2 * input.value.length, 7)}ch + 26px)`; };

/** The selected point, or what several have in common. */
export function showPoint(): void {
  const { selection, only } = tools;
  const line = only && host.lines[only.line];
  $('point-name').textContent = line ? `${capital(line.name)}, ${only.point + 1} of ${line.points.length}` : count(selection.length, 'point');
  for (const input of document.querySelectorAll<HTMLInputElement>('#point [data-axis]')) {
    const values = new Set(selection.map((ref) => {
      const raw = host.lines[ref.line]?.points[ref.point];
      return Array.isArray(raw) ? raw[Number(input.dataset.axis)] as unknown : undefined;
    }));
    const [value] = values;
    if (document.activeElement === input && input.dataset.dirty) continue;
    input.value = values.size === 1 && value !== undefined && value !== null ? String(value) : '';
    widen(input);
    input.placeholder = values.size === 1 ? 'none' : 'various';
  }
  const edge = tools.edgeBefore();
  $('edge-field').hidden = !edge;
  const input = $<HTMLInputElement>('edge');
  if (edge && !(document.activeElement === input && input.dataset.dirty)) {
    input.value = String(Number(edge.length.toPrecision(7)));
    widen(input);
  }
  const onlyMoves = selection.some((ref) => host.lines[ref.line]?.only);
  $<HTMLButtonElement>('insert-point').disabled = !only || onlyMoves;
  $<HTMLButtonElement>('remove-line').disabled = onlyMoves;
  // A mast or a stay is deleted by its foot.
  $<HTMLButtonElement>('delete-point').disabled = onlyMoves && !(only && tools.mayCable);
  $('cable-from-point').hidden = !only || !tools.mayCable || onlyMoves;
}
