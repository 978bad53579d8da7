// Cables along the boundaries of a tensile structure: which stretch each runs along, and how they follow when points of
// the boundaries come and go. A segment has the number of the point at which it begins.

import { coordinates, type Request, type Vec3 } from './request';

interface Along { boundary?: number; from: number; to: number }
export interface Cable { name?: string | null; along?: Along | null; across?: Vec3[] | null; points?: Vec3[] | null; mode?: string; value: number; axial_stiffness?: number | null; weight?: number }
interface BoundaryPoint { boundary?: number; point: number }
interface Support { along?: Along | null; boundary?: number | null; point?: BoundaryPoint | null }

const list = <T>(value: unknown): T[] => (Array.isArray(value) ? value as T[] : []);

export const cablesOf = (request: Request): Cable[] => list<Cable>(request.cables);

const boundaryOf = (request: Request, boundary: number): unknown[] => list<unknown>(list<unknown>(request.boundaries)[boundary]);

/** The points of a stretch in order, from its first to its last. */
export function stretch(request: Request, { boundary = 0, from, to }: Along): number[] {
  const count = boundaryOf(request, boundary).length;
  if (!(from < count && to < count && from >= 0 && to >= 0)) return [];
  const points = [from];
  while (points.at(-1) !== to && points.length <= count) points.push((points.at(-1)! + 1) % count);
  return points;
}

/** The number of the cable that runs along a segment; -1 for none. */
export const cableAt = (request: Request, boundary: number, segment: number): number =>
  cablesOf(request).findIndex(({ along }) => along && (along.boundary ?? 0) === boundary && stretch(request, along).slice(0, -1).includes(segment));

const difference = (a: Vec3, b: Vec3): Vec3 => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const dot = (a: Vec3, b: Vec3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const size = (a: Vec3): number => Math.hypot(...a);

function placesOf(request: Request, along: Along): Vec3[] {
  const points = boundaryOf(request, along.boundary ?? 0);
  return stretch(request, along).map((point) => coordinates(points[point]) ?? [0, 0, 0]);
}

/** The length of a stretch. Of a single edge it is the chord of its cable. */
function lengthOf(request: Request, along: Along): number {
  const places = placesOf(request, along);
  return places.slice(1).reduce((sum, place, i) => sum + size(difference(place, places[i]!)), 0);
}

/** The smaller of the angles between the chord of a stretch and the edges of the boundary beside it. */
function sharpestCorner(request: Request, along: Along): number {
  const boundary = along.boundary ?? 0;
  const points = boundaryOf(request, boundary).map((point) => coordinates(point) ?? [0, 0, 0] as Vec3);
  const count = points.length;
  const angle = (at: number, end: number, beside: number): number => {
    const [u, v] = [difference(points[end]!, points[at]!), difference(points[beside]!, points[at]!)];
    const sizes = size(u) * size(v);
    return sizes > 0 ? Math.acos(Math.min(1, Math.max(-1, dot(u, v) / sizes))) : Math.PI;
  };
  if (!points[along.from] || !points[along.to]) return Math.PI;
  return Math.min(angle(along.from, along.to, (along.from + count - 1) % count), angle(along.to, along.from, (along.to + 1) % count));
}

/**
 * Distance from the chord of a stretch to the nearest edge of the boundary that does not end where the stretch does.
 */
function clearance(request: Request, along: Along): number {
  const points = boundaryOf(request, along.boundary ?? 0).map((point) => coordinates(point) ?? [0, 0, 0] as Vec3);
  const [a, b] = [points[along.from], points[along.to]];
  if (!a || !b) return Infinity;
  const covered = stretch(request, along);
  const chord = [0.25, 0.5, 0.75].map((t): Vec3 => [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])]);
  return Math.min(...points.flatMap((from, i) => {
    const next = (i + 1) % points.length;
    return covered.includes(i) || covered.includes(next) ? [] : chord.map((place) => toSegment(place, from, points[next]!));
  }));
}

function toSegment(place: Vec3, from: Vec3, to: Vec3): number {
  const [u, v] = [difference(to, from), difference(place, from)];
  const t = Math.min(1, Math.max(0, dot(u, v) / (dot(u, u) || 1)));
  return size(difference(v, [t * u[0], t * u[1], t * u[2]]));
}

/** Sag of a new cable as a fraction of its chord. */
const SAG = 0.1;
/**
 * Largest part of a corner's angle between a cable and its chord. Two cables meet in a corner, so the film closes there
 * if each of them takes half. With 0.4, all of 500 random quadrilaterals and pentagons had an equilibrium; some had
 * angles of 20°.
 */
const CORNER = 0.4;
/**
 * Largest sag as a part of the clearance, because the film closes where opposite cables meet. With 0.4, all of 400
 * random quadrilaterals and pentagons had an equilibrium; without this limit a sliver among the first 100 had none.
 */
const CLEARANCE = 0.4;

/**
 * Radius of a new cable's arc over its chord. A film of tension σ pulls a cable of force F into an arc of the radius R
 * = F/σ. An arc that sags by s over the chord c has R = c²/(8s) + s/2, which is 1.3 c for s = 0.1 c. The arc meets its
 * chord at the angle asin(c/2R).
 */
function radiusOf(request: Request, along: Along, chord: number): number {
  const sag = Math.min(SAG, Math.max((CLEARANCE * clearance(request, along)) / chord, SAG / 100));
  const angle = Math.min(CORNER * sharpestCorner(request, along), Math.PI / 2);
  return Math.max(1 / (8 * sag) + sag / 2, 1 / (2 * Math.sin(Math.max(angle, 1e-3))));
}

const rounded = (value: number): number => Number(value.toPrecision(2));
/** Rounded to four digits, because a cable must be longer than its chord. */
const length = (value: number): number => Number(value.toPrecision(4));

/** The tension of the film, or of all layers together. Of a woven film it is the larger of its stresses. */
function tensionOf(request: Request): number {
  const films = (Array.isArray(request.layers) ? request.layers : [request.film]) as ({ tension?: number; warp?: number; weft?: number } | undefined)[];
  return films.reduce((sum, film) => sum + (Number(film?.tension) || Math.max(Number(film?.warp) || 0, Number(film?.weft) || 0)), 0) || 1;
}

/**
 * A value for a cable of this course by which it sags by a tenth of its chord, or less where that is too much for the
 * film.
 */
export function likelyValue(request: Request, along: Along, mode: string): number {
  const chord = lengthOf(request, along) || 1;
  const radius = radiusOf(request, along, chord);
  const arc = 2 * radius * Math.asin(1 / (2 * radius));
  if (mode === 'force_density') return rounded((tensionOf(request) * radius) / arc);
  if (mode === 'length') return length(arc * chord);
  // The studio's cables are stiff: they stretch by a hundredth.
  if (mode === 'unstressed_length') return length((arc * chord) / 1.01);
  if (mode === 'sag') return rounded((radius - Math.sqrt(radius * radius - 0.25)) * chord);
  return rounded(tensionOf(request) * radius * chord);
}

/**
 * Adds a cable between two points of a boundary, in its direction, and gives its number. Cables in its way are removed.
 * It holds constant what the last cable does, at a value of its own.
 */
export function addCable(request: Request, boundary: number, from: number, to: number): number {
  const cables = cablesOf(request);
  const along: Along = { boundary, from, to };
  const covered = stretch(request, along).slice(0, -1);
  const last = cables.at(-1);
  const kept = cables.filter((cable) => !cable.along || (cable.along.boundary ?? 0) !== boundary || !stretch(request, cable.along).slice(0, -1).some((segment) => covered.includes(segment)));
  const mode = last?.along ? last.mode ?? 'force' : 'force';
  const value = likelyValue(request, along, mode);
  kept.push({ along, mode, value, ...(mode === 'unstressed_length' && { axial_stiffness: 100 * likelyValue(request, along, 'force') }) });
  request.cables = kept;
  return kept.length - 1;
}

/** The edges of the boundaries along which no cable runs, as pairs of boundary and first point. */
export const bareEdges = (request: Request): [number, number][] => list<unknown[]>(request.boundaries).flatMap((points, boundary) =>
  list(points).flatMap((_, from): [number, number][] => (cableAt(request, boundary, from) < 0 ? [[boundary, from]] : [])));

/** Adds a cable along every edge of the boundaries that has none. */
export function hangAll(request: Request): void {
  for (const [boundary, from] of bareEdges(request)) addCable(request, boundary, from, (from + 1) % boundaryOf(request, boundary).length);
}

export function removeCable(request: Request, cable: number): void {
  cablesOf(request).splice(cable, 1);
}

/** What names points of boundaries: stretches, and single points. */
function references(request: Request): { stretches: Along[]; points: BoundaryPoint[] } {
  const supports = list<Support>(request.supports);
  return {
    stretches: [...cablesOf(request), ...supports].flatMap(({ along }) => (along ? [along] : [])),
    points: [...list<BoundaryPoint>(request.free_points), ...supports.flatMap(({ point }) => (point ? [point] : []))],
  };
}

/** Follows a point that was put into a boundary after the one with this number. */
export function pointInserted(request: Request, boundary: number, after: number): void {
  const { stretches, points } = references(request);
  for (const along of stretches.filter((each) => (each.boundary ?? 0) === boundary)) {
    if (along.from > after) along.from += 1;
    if (along.to > after) along.to += 1;
  }
  for (const each of points) if ((each.boundary ?? 0) === boundary && each.point > after) each.point += 1;
}

/**
 * Follows a point that was taken out of a boundary, which now has `count` points. Stretches without a segment go with
 * it.
 */
export function pointRemoved(request: Request, boundary: number, point: number, count: number): void {
  const { stretches, points } = references(request);
  const gone = new Set<unknown>();
  for (const along of stretches.filter((each) => (each.boundary ?? 0) === boundary)) {
    // A stretch that began or ended there ends at the neighbour inside it.
    if (along.from === point && along.to === (point + 1) % (count + 1)) gone.add(along);
    const to = along.to >= point ? along.to - 1 : along.to;
    along.from = (along.from > point ? along.from - 1 : along.from) % Math.max(count, 1);
    along.to = (to + count) % Math.max(count, 1);
    if (along.from === along.to) gone.add(along);
  }
  for (const each of points.filter((one) => (one.boundary ?? 0) === boundary)) {
    if (each.point === point) gone.add(each);
    else if (each.point > point) each.point -= 1;
  }
  drop(request, gone);
}

/** Follows a boundary that was removed. */
export function boundaryRemoved(request: Request, boundary: number): void {
  const { stretches, points } = references(request);
  const gone = new Set<unknown>([...stretches, ...points].filter((each) => (each.boundary ?? 0) === boundary));
  for (const each of [...stretches, ...points]) if ((each.boundary ?? 0) > boundary) each.boundary = (each.boundary ?? 0) - 1;
  for (const support of list<Support>(request.supports)) {
    if (support.boundary === boundary) gone.add(support);
    else if ((support.boundary ?? -1) > boundary) support.boundary! -= 1;
  }
  drop(request, gone);
}

function drop(request: Request, gone: Set<unknown>): void {
  const stays = (each: { along?: unknown; point?: unknown }): boolean => !gone.has(each) && !gone.has(each.along) && !gone.has(each.point);
  for (const field of ['cables', 'supports', 'free_points']) {
    if (Array.isArray(request[field])) request[field] = list<{ along?: unknown; point?: unknown }>(request[field]).filter(stays);
  }
}
