// Masts, stays, ridge cables and supports of a tensile structure. Their ends are coordinates. An end at a point of a
// boundary is joined to the boundary, and every other end is a support. A corner that masts and stays carry is no
// support itself. Its edges hang on cables.

import { addCable, cableAt, type Cable, cablesOf } from './cables';
import { coordinates, type Request, upAxisOf, type Vec3 } from './request';

export interface Mast { name?: string | null; points: Vec3[]; mode?: string; value: number }
/** A point of a boundary, by their numbers. */
export interface Corner { line: number; point: number }
interface BoundaryPoint { boundary?: number; point: number }

/** Angle between the directions of the two stays of a mast, in radians: the corner is held sideways, too. */
const SPREAD = 1.2;
/** Force of a ridge cable for each length of its chord, in tensions of the film. */
const RIDGE = 1.5;

const list = <T>(value: unknown): T[] => (Array.isArray(value) ? value as T[] : []);
export const mastsOf = (request: Request): Mast[] => list<Mast>(request.masts);
const boundary = (request: Request, line: number): Vec3[] => list<unknown>(list<unknown>(request.boundaries)[line]).map((point) => coordinates(point) ?? [0, 0, 0]);
const distance = (a: Vec3, b: Vec3): number => Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
const isSame = (a: unknown, b: Vec3): boolean => Array.isArray(a) && a.length === 3 && a.every((value, axis) => value === b[axis]);
const digits = (value: number, n: number): number => Number(value.toPrecision(n));

/** The members that end at a place: masts, and cables in the air. */
const membersAt = (request: Request, place: Vec3): (Mast | Cable)[] =>
  [...mastsOf(request), ...cablesOf(request)].filter(({ points }) => list(points).some((end) => isSame(end, place)));

/** Members that hold a length get the one between their ends. */
function measure(members: (Mast | Cable)[]): void {
  for (const member of members) if (member.mode === 'length' && member.points?.length === 2) member.value = digits(distance(member.points[0]!, member.points[1]!), 12);
}

/**
 * After a point moved: what ended there ends at its new place, and what holds a length has the new one. Without a point
 * it goes.
 */
export function follow(request: Request, from: Vec3, to: Vec3 | null): void {
  if (!to) {
    drop(request, [...membersAt(request, from), ...cablesOf(request).filter(({ across }) => list(across).some((end) => isSame(end, from)))]);
    return;
  }
  for (const { points, across } of [...mastsOf(request), ...cablesOf(request)] as Cable[]) {
    for (const ends of [list<unknown>(points), list<unknown>(across)]) ends.forEach((end, i) => { if (isSame(end, from)) ends[i] = [...to]; });
  }
  measure(membersAt(request, to));
}

function drop(request: Request, gone: (Mast | Cable)[]): void {
  if (gone.length === 0) return;
  request.cables = cablesOf(request).filter((each) => !gone.includes(each));
  request.masts = mastsOf(request).filter((each) => !gone.includes(each));
  if (mastsOf(request).length === 0) delete request.masts;
}

const isCorner = (each: BoundaryPoint, { line, point }: Corner): boolean => (each.boundary ?? 0) === line && each.point === point;
export const isFree = (request: Request, corner: Corner): boolean => list<BoundaryPoint>(request.free_points).some((each) => isCorner(each, corner));

/** Lets masts and stays carry a corner. Its edges are hung on cables, because an edge that is held ends at supports. */
function free(request: Request, { line, point }: Corner): void {
  const count = boundary(request, line).length;
  for (const from of [(point + count - 1) % count, point]) if (cableAt(request, line, from) < 0) addCable(request, line, from, (from + 1) % count);
  if (!isFree(request, { line, point })) request.free_points = [...list<BoundaryPoint>(request.free_points), { ...(line > 0 && { boundary: line }), point }];
}

/** The ground below the structure: its lowest level, or zero if that is not far below. With the structure's extent. */
function groundOf(request: Request): { level: number; extent: number } {
  const up = upAxisOf(request);
  const places = [...list<unknown>(request.boundaries).flatMap((_, line) => boundary(request, line)), ...[...mastsOf(request), ...cablesOf(request)].flatMap(({ points }) => list<Vec3>(points))];
  const extent = Math.max(...[0, 1, 2].map((axis) => Math.max(...places.map((place) => place[axis]!)) - Math.min(...places.map((place) => place[axis]!))));
  const lowest = Math.min(...places.map((place) => place[up]));
  return { level: lowest > 0 && lowest <= 2 * extent ? 0 : lowest, extent };
}

/** A place on the ground beside a corner, away from the middle of its boundary and turned by an angle. */
function outside(request: Request, { line, point }: Corner, turn: number): Vec3 {
  const points = boundary(request, line);
  const place = points[point]!;
  const [a, b] = upAxisOf(request) === 2 ? [0, 1] : [0, 2];
  const middle = (axis: number): number => points.reduce((sum, each) => sum + each[axis]!, 0) / points.length;
  const angle = Math.atan2(place[b]! - middle(b), place[a]! - middle(a)) + turn;
  const { level: ground } = groundOf(request);
  const reach = Math.max(place[upAxisOf(request)] - ground, 0);
  const anchor: Vec3 = [...place];
  anchor[a] = digits(place[a]! + reach * Math.cos(angle), 4);
  anchor[b] = digits(place[b]! + reach * Math.sin(angle), 4);
  anchor[upAxisOf(request)] = ground;
  return anchor;
}

const nameFor = (members: { name?: string | null }[], word: string): string => {
  for (let n = 1; ; n += 1) if (!members.some(({ name }) => name === `${word} ${n}`)) return `${word} ${n}`;
};

/**
 * Adds a cable in the air from a corner. Three members that hold their lengths place the corner; further ones hold a
 * force.
 */
function tie(request: Request, corner: Corner, anchor: Vec3): void {
  const place = boundary(request, corner.line)[corner.point]!;
  const members = membersAt(request, place);
  const isPlaced = members.filter(({ mode }) => mode === 'length').length >= 3;
  const edge = Math.max(...cablesOf(request).filter(({ along, mode }) => along && (mode ?? 'force') === 'force').map(({ value }) => value), 1);
  const stay: Cable = { name: nameFor(cablesOf(request), 'stay'), points: [[...place], anchor], ...(isPlaced ? { mode: 'force', value: digits(edge, 2) } : { mode: 'length', value: distance(place, anchor) }) };
  request.cables = [...cablesOf(request), stay];
}

/** Stands a mast under a corner, with two stays to the ground that hold it in its place. Returns why that cannot be. */
export function addMast(request: Request, corner: Corner): string | null {
  const up = upAxisOf(request);
  const place = boundary(request, corner.line)[corner.point]!;
  const foot: Vec3 = [...place];
  foot[up] = groundOf(request).level;
  if (!(place[up] > foot[up])) return 'Lift this corner first: a mast stands on the ground below it.';
  if (mastsOf(request).some(({ points }) => points.some((end) => isSame(end, place)))) return 'A mast carries this corner already.';
  free(request, corner);
  request.masts = [...mastsOf(request), { name: nameFor(mastsOf(request), 'mast'), points: [foot, [...place]], mode: 'length', value: distance(foot, place) }];
  const anchors = [-SPREAD / 2, SPREAD / 2].map((turn) => outside(request, corner, turn));
  for (const anchor of anchors) tie(request, corner, anchor);
  return null;
}

/**
 * Ties a corner to a place on the ground; without one, to the ground on the outside of the corner. Returns why that
 * cannot be.
 */
export function addStay(request: Request, corner: Corner, place: Vec3 | null): string | null {
  const { level, extent } = groundOf(request);
  // A pointer is not finer than a hundredth of the structure.
  const step = 10 ** (Math.floor(Math.log10(extent || 1)) - 2);
  const anchor = place?.map((value, axis) => (axis === upAxisOf(request) ? level : digits(Math.round(value / step) * step, 12))) as Vec3 | undefined ?? outside(request, corner, 0);
  if (!(distance(anchor, boundary(request, corner.line)[corner.point]!) > 0)) return 'Lift this corner first, or press the place where the stay ends.';
  free(request, corner);
  tie(request, corner, anchor);
  return null;
}

/** Runs a cable across the film between two points of boundaries. Returns why that cannot be. */
export function addRidge(request: Request, from: Corner, to: Corner): string | null {
  const ends = [from, to].map(({ line, point }) => boundary(request, line)[point]!);
  const count = boundary(request, from.line).length;
  const apart = (to.point - from.point + count) % count;
  if (from.line === to.line && (apart <= 1 || apart === count - 1)) return 'A ridge cable runs across the film: press a point that is no neighbour.';
  const films = (Array.isArray(request.layers) ? request.layers : [request.film]) as ({ tension?: number } | undefined)[];
  const tension = films.reduce((sum, film) => sum + (Number(film?.tension) || 0), 0) || 1;
  request.cables = [...cablesOf(request), { name: nameFor(cablesOf(request), 'ridge'), across: ends.map((end) => [...end] as Vec3), mode: 'force', value: digits(RIDGE * tension * distance(ends[0]!, ends[1]!), 2) }];
  return null;
}

/** Makes a corner a support, without what carried it; or frees one that is a support. */
export function hold(request: Request, corner: Corner): void {
  if (!isFree(request, corner)) {
    free(request, corner);
    return;
  }
  request.free_points = list<BoundaryPoint>(request.free_points).filter((each) => !isCorner(each, corner));
  drop(request, membersAt(request, boundary(request, corner.line)[corner.point]!));
  if (list(request.free_points).length === 0) delete request.free_points;
}
