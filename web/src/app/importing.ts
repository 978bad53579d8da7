// Files and text that are opened, and the card that says what was found in a drawing: its size, unit, layers and
// axis, each of which can be changed as long as nothing else has been.

import type { Kind } from 'plateau-client';
import { $ } from '../dom';
import { parseJson } from '../files/json';
import { type Drawing, FileFault, type Polyline } from '../files/lines';
import { openFile, openText, type Opened } from '../files/open';
import { boxOf, type FileUnit, type Length, mayBeDegrees, METRES, middleOf, toPlane } from '../files/units';
import { originFor } from '../model/frame';
import { isWhole, kindOf, KINDS, linesOf, metresOf, type Request, unitOf, type Vec3 } from '../model/request';
import { rescale } from '../model/rescale';
import { hideCard, showImport, showQuestion } from '../panels/card';
import { capital, count, number } from '../text';
import { opening } from './busy';
import { changed, load, replace } from './document';
import { showPanel } from './notes';
import { showProblem } from './problems';
import { doc, history, host, session } from './session';
import { solve } from './solving';

/** A file, or a text that was dropped or pasted. */
export const take = (given: File | string): Promise<void> => {
  const name = typeof given === 'string' ? '' : given.name;
  return opening<Opened>(() => (typeof given === 'string' ? openText(given) : openFile(given)), (opened) => {
    if ('lines' in opened) begin(opened, name);
    else takeRequest(opened.request, name);
  }, (error, turn) => showProblem({ title: name ? `${name} cannot be opened` : 'This cannot be opened', detail: error instanceof Error ? error.message : String(error) }, turn));
};

// ---- Drawings ----

/** What a person chooses of a file. */
interface Choice { unit: FileUnit; layers: Set<string>; up: 'y' | 'z'; local: boolean }

/** A drawing of this extent, in metres, is taken for a structure if the file names no unit. */
const LIKELY_M = [0.5, 1000] as const;

const layersOf = ({ lines }: Drawing): string[] => [...new Set(lines.map(({ layer }) => layer ?? ''))];

/** A file's polylines become the drawing; options stay. */
function begin(drawing: Drawing, name: string): void {
  const { request } = doc();
  const kind = drawing.kind === undefined || (drawing.kind === 'minimal_surface' && doc().kind !== 'ruled_surface') ? doc().kind : drawing.kind;
  const base = { kind, request: structuredClone(kind === doc().kind ? request : { units: unitOf(request), ...(request.up !== undefined && { up: request.up }) }) };
  const choice: Choice = { unit: drawing.unit ?? likelyUnit(drawing, base.request), layers: new Set(drawing.taken ?? layersOf(drawing)), up: drawing.up ?? (base.request.up === 'y' ? 'y' : 'z'), local: false };
  const use = (amend: boolean): void => {
    const { points, closed } = placed(drawing, choice, base.request);
    const document = documentOf(base.kind, base.request, points, closed);
    replace(base.kind, document, name || `${drawing.format} drawing`, { amend });
    changed();
    showCard();
  };
  const showCard = (): void => {
    const taken = drawing.lines.filter(({ layer }) => choice.layers.has(layer ?? ''));
    const far = originOf(drawing, choice, base.request).some((value) => value !== 0);
    const least = leastOf(base.kind);
    const short = taken.filter(({ points }) => points.length < least).length;
    showImport({
      title: name || `${drawing.format} drawing`,
      found: `${drawing.format}: ${count(taken.length, 'line')}, ${count(taken.reduce((sum, { points }) => sum + points.length, 0), 'point')}`,
      size: sizeOf(linesOf(doc().kind, doc().request).map(({ points }) => points as Vec3[]), doc().request),
      asks: drawing.unit === null,
      units: unitsFor(drawing).map((unit) => ({ value: unit, text: `${unit}: ${sizeOf(placed(drawing, { ...choice, unit, local: false }, base.request).points, base.request).replace(/, .*/, '')}` })),
      unit: choice.unit,
      layers: layersOf(drawing).map((layer) => ({ layer, lines: drawing.lines.filter((line) => (line.layer ?? '') === layer).length, taken: choice.layers.has(layer) })),
      up: choice.up, local: far ? choice.local : null,
      notes: [
        ...(choice.unit === 'degrees' ? [`Longitude and latitude were projected to a plane in metres around ${middleOf(taken).map((value) => number(value, 7)).join(', ')}.`] : []),
        ...(short > 0 ? [`${capital(count(short, 'line'))} of fewer than ${least} points ${short === 1 ? 'is' : 'are'} left out.`] : []),
        ...drawing.notes,
      ],
    }, {
      change: (change) => {
        const before = { ...choice, layers: new Set(choice.layers) };
        change(choice);
        try {
          use(true);
        } catch (error) {
          Object.assign(choice, before);
          showProblem({ title: 'This cannot be taken', detail: error instanceof Error ? error.message : String(error) });
          showCard();
        }
      },
      undo: () => {
        closeCard();
        $('undo').click();
      },
      close: closeCard,
    });
    session.card = { of: JSON.stringify(doc().request), close: closeCard };
  };
  use(false);
  showPanel('setup');
}

function closeCard(): void {
  session.card = null;
  hideCard();
}

/** The unit of a file that names none: that of the document, unless the drawing would have no likely size. */
function likelyUnit(drawing: Drawing, request: Request): Length {
  const { low, high } = boxOf(drawing.lines);
  const extent = Math.max(...low.map((value, axis) => high[axis]! - value));
  const fits = (unit: Length): boolean => extent * METRES[unit] >= LIKELY_M[0] && extent * METRES[unit] <= LIKELY_M[1];
  const own = unitOf(request) as Length;
  return [own, 'm' as const, 'mm' as const, 'cm' as const].find(fits) ?? own;
}

function unitsFor(drawing: Drawing): FileUnit[] {
  const offered: FileUnit[] = ['mm', 'cm', 'm', 'in', 'ft'];
  if (drawing.unit !== null && !offered.includes(drawing.unit)) offered.unshift(drawing.unit);
  if (!offered.includes('degrees') && mayBeDegrees(drawing.lines)) offered.push('degrees');
  return offered;
}

/** The lines that are taken, in metres for degrees, with the factor to the document's unit. */
function taken(drawing: Drawing, { unit, layers }: Choice, request: Request): { lines: Polyline[]; factor: number } {
  const lines = drawing.lines.filter(({ layer }) => layers.has(layer ?? ''));
  return unit === 'degrees' ? { lines: toPlane(lines), factor: 1 / metresOf(request) } : { lines, factor: METRES[unit] / metresOf(request) };
}

const turned = ([x, y, z]: Vec3, from: 'y' | 'z', to: 'y' | 'z'): Vec3 => (from === to ? [x, y, z] : from === 'y' ? [x, -z, y] : [x, z, -y]);

/** The lines in the document's unit and axes. Coordinates that need no change keep every digit. */
function placed(drawing: Drawing, choice: Choice, request: Request): { points: Vec3[][]; closed: boolean[] } {
  const { lines, factor } = taken(drawing, choice, request);
  const digits = drawing.single ? 9 : 15;
  const up = request.up === 'y' ? 'y' : 'z';
  const origin = choice.local ? originOf(drawing, choice, request) : [0, 0, 0];
  const scale = (value: number): number => (factor === 1 && !drawing.single ? value : Number((value * factor).toPrecision(digits)));
  const shift = (value: number, axis: number): number => (origin[axis] === 0 ? value : Number((value - origin[axis]!).toPrecision(12)));
  return {
    points: lines.map(({ points }) => points.map((point) => turned(point.map(scale) as Vec3, choice.up, up).map((value, axis) => shift(value, axis) + 0) as Vec3)),
    closed: lines.map(({ closed }) => closed),
  };
}

/** The round point near a drawing that lies far from zero; zero for the others. */
function originOf(drawing: Drawing, choice: Choice, request: Request): Vec3 {
  const { points } = placed(drawing, { ...choice, local: false }, request);
  return originFor(points.map((each) => ({ name: '', path: [], points: each, closed: true, planar: false })), request);
}

/** The extent of lines as words: `12.4 by 6.1 m, 3.2 m high`. */
export function sizeOf(lines: Vec3[][], request: Request): string {
  const { low, high } = boxOf(lines.map((points) => ({ points })));
  const unit = unitOf(request);
  const up = request.up === 'y' ? 1 : 2;
  const extent = low.map((value, axis) => high[axis]! - value);
  const across = extent.filter((_, axis) => axis !== up).sort((a, b) => b - a);
  if (!Number.isFinite(extent[0]!)) return 'nothing';
  const long = (value: number): string => number(Number(value.toPrecision(3)), 3);
  return `${across.map(long).join(' by ')} ${unit}${extent[up]! > 1e-9 * Math.max(...extent) ? `, ${long(extent[up]!)} ${unit} high` : ''}`;
}

const leastOf = (kind: Kind): number => (kind === 'ruled_surface' ? 1 : KINDS[kind].least);

/** A document of the kind with these lines in place of its own. */
function documentOf(kind: Kind, request: Request, all: Vec3[][], allClosed: boolean[]): Request {
  const { line, least } = KINDS[kind];
  const fits = all.map((points) => points.length >= leastOf(kind));
  const own = all.filter((_, i) => fits[i]), closed = allClosed.filter((_, i) => fits[i]);
  if (own.length === 0) throw new FileFault(all.length === 0 ? 'Choose at least one layer.' : `The longest line of the file has ${count(Math.max(...all.map((points) => points.length)), 'point')}; a ${line} needs ${least}.`);
  const next: Request = structuredClone(request);
  for (const field of ['normals', 'tangents', 'constraints', 'cables', 'free_points', 'supports']) delete next[field];
  // The file has no normals, without which this objective cannot be solved.
  if (next.objective === 'minimal_normal_variation') delete next.objective;
  if (typeof next.initial_mesh === 'object') delete next.initial_mesh;
  if (kind === 'ruled_surface') Object.assign(next, { directrices: own, closed: own.length > 1 && closed.every(Boolean) });
  else if (kind === 'minimal_surface' || kind === 'tensile_structure') next.boundaries = own;
  else if (kind === 'cable_net') Object.assign(next, netOf(own.map((points, i) => (closed[i] ? [...points, points[0]!] : points))), { cables: [{ force_density: 1 }], loads: [] });
  else {
    const bySize = [...own].sort((a, b) => extent(b) - extent(a));
    next.domain = { polygon: bySize[0], ...(bySize.length > 1 && { holes: bySize.slice(1) }) };
    next.edge_length ??= Number((extent(bySize[0]!) / 20).toPrecision(1));
  }
  return next;
}

/**
 * A net whose edges are the segments of lines. Equal points are joined, and the points with the fewest edges are
 * supports.
 */
function netOf(lines: Vec3[][]): { vertices: Vec3[]; edges: [number, number][]; supports: number[] } {
  const numbers = new Map<string, number>();
  const vertices: Vec3[] = [], counts: number[] = [];
  const numberOf = (point: Vec3): number => {
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
  const edges = lines.flatMap((line) => line.slice(1).map((point, i): [number, number] => [numberOf(line[i]!), numberOf(point)]));
  const fewest = Math.min(...counts);
  return { vertices, edges, supports: vertices.map((_, v) => v).filter((v) => counts[v] === fewest) };
}

function extent(points: Vec3[]): number {
  const { low, high } = boxOf([{ points }]);
  return Math.hypot(...low.map((value, axis) => high[axis]! - value));
}

// ---- Another unit of the drawing ----

/** Asks after a change of the document's unit whether the drawing is to keep its size or its numbers. */
export function unitChanged(before: Request): void {
  const { kind, request } = doc();
  const factor = metresOf(before) / metresOf(request);
  const points = host.lines.map((line) => line.points as Vec3[]);
  if (factor === 1 || points.length === 0) return;
  const converted = structuredClone(request);
  rescale(kind, converted, factor);
  showQuestion(`The drawing is ${sizeOf(points, before)}. Convert it to ${unitOf(request)}, or keep its numbers?`, [
    { text: `Convert: ${sizeOf(linesOf(kind, converted).map((line) => line.points as Vec3[]), request)}`, primary: true, act: () => {
      closeCard();
      history.amend((document) => { document.request = converted; });
      load();
      changed({ edited: true });
    } },
    { text: `Keep the numbers: ${sizeOf(points, request)}`, primary: false, act: closeCard },
  ]);
  session.card = { of: JSON.stringify(request), close: closeCard };
}

// ---- Requests ----

function takeRequest(request: Request, title: string | null): void {
  const { kind: named, ...rest } = request;
  const kind = kindOf(request) ?? doc().kind;
  if (named !== undefined && !(String(named) in KINDS)) throw new FileFault(`This server has no kind ${JSON.stringify(named)}.`);
  replace(kind, rest, title);
  changed();
  // The service says best what is missing or misspelt.
  if (!isWhole(kind, rest)) void solve();
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
    const before = new Set(host.lines.flatMap(({ points }) => points.map((point) => JSON.stringify(point))));
    const named = request.kind !== undefined || kindOf(request) ? request : { ...request, kind: doc().kind };
    // A drawing that shares no point with the drawing before loses its name.
    const same = linesOf(kindOf(named) ?? doc().kind, named).some(({ points }) => points.some((point) => before.has(JSON.stringify(point))));
    takeRequest(named, same ? doc().title : null);
    $<HTMLFormElement>('request-form').reset();
  } catch (error) {
    fault(error instanceof Error ? error.message : String(error));
  }
}
