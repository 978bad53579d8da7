// Cables along the boundaries of a tensile structure: which stretch each runs along, and how they follow when points of the
// boundaries come and go. A segment has the number of the point at which it begins.

import { coordinates, type Request } from './request';

interface Along { boundary?: number; from: number; to: number }
export interface Cable { name?: string | null; along?: Along | null; mode?: string; value: number; axial_stiffness?: number | null; weight?: number }
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

const chord = (request: Request, along: Along): number => {
  const points = stretch(request, along).map((point) => coordinates(boundaryOf(request, along.boundary ?? 0)[point]));
  let length = 0;
  for (let i = 1; i < points.length; i += 1) length += Math.hypot(...[0, 1, 2].map((axis) => (points[i]?.[axis] ?? 0) - (points[i - 1]?.[axis] ?? 0)));
  return length;
};

const rounded = (value: number): number => Number(value.toPrecision(2));

/** A value that a structure with this cable is likely to have an equilibrium for. */
export function likelyValue(request: Request, along: Along, mode: string): number {
  const length = chord(request, along) || 1;
  // A cable of force σ c has the radius c and sags by 13% of its chord c.
  const films = (Array.isArray(request.layers) ? request.layers : [request.film]) as ({ tension?: number } | undefined)[];
  const force = (films.reduce((sum, film) => sum + (Number(film?.tension) || 0), 0) || 1) * length;
  if (mode === 'force_density') return rounded(force / length);
  if (mode === 'length') return rounded(1.05 * length);
  if (mode === 'unstressed_length') return rounded(1.045 * length);
  if (mode === 'sag') return rounded(0.13 * length);
  return rounded(force);
}

/** Adds a cable between two points of a boundary, in its direction, and gives its number. Cables in its way are removed. */
export function addCable(request: Request, boundary: number, from: number, to: number): number {
  const cables = cablesOf(request);
  const along: Along = { boundary, from, to };
  const covered = stretch(request, along).slice(0, -1);
  const last = cables.at(-1);
  const kept = cables.filter((cable) => !cable.along || (cable.along.boundary ?? 0) !== boundary || !stretch(request, cable.along).slice(0, -1).some((segment) => covered.includes(segment)));
  const mode = last?.along ? last.mode ?? 'force' : 'force';
  const forces = ['force', 'end_tension', 'horizontal_component'];
  const value = last?.along && forces.includes(mode) ? last.value : likelyValue(request, along, mode);
  kept.push({ along, mode, value, ...(mode === 'unstressed_length' && { axial_stiffness: last?.axial_stiffness ?? 100 * value }) });
  request.cables = kept;
  return kept.length - 1;
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

/** Follows a point that was taken out of a boundary, which now has `count` points. Stretches without a segment go with it. */
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
