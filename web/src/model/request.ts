// Requests as plain JSON: where their polylines are, and what a JSON Pointer into one means to a person.

import type { Kind } from 'plateau-client';

export type Vec3 = [number, number, number];
export type Request = Record<string, unknown>;
export type Path = (string | number)[];

/** `lines` is empty for a kind whose points are moved but not drawn. */
interface KindFacts { path: string; label: string; noun: string; line: string; lines: string[]; least: number; purpose: string }

export const KINDS: Record<Kind, KindFacts> = {
  minimal_surface: { path: '/v1/minimal-surfaces', label: 'Film', noun: 'film', line: 'boundary', lines: ['boundaries'], least: 3, purpose: 'A membrane of least area on its boundary' },
  ruled_surface: { path: '/v1/ruled-surfaces', label: 'Strip', noun: 'strip', line: 'rail', lines: ['directrices'], least: 2, purpose: 'A ruled strip between two rails' },
  uniform_mesh: { path: '/v1/uniform-meshes', label: 'Lattice', noun: 'lattice', line: 'hole', lines: ['domain', 'holes'], least: 3, purpose: 'A gridshell or floor of equal members' },
  tensile_structure: { path: '/v1/tensile-structures', label: 'Tensile', noun: 'tensile structure', line: 'boundary', lines: ['boundaries'], least: 3, purpose: 'A film with cables, pressure and weight in equilibrium' },
  cable_net: { path: '/v1/cable-nets', label: 'Net', noun: 'cable net', line: 'net', lines: [], least: 2, purpose: 'A net of cables with target forces and lengths' },
};

const METRES: Record<string, number> = { mm: 0.001, cm: 0.01, m: 1, in: 0.0254, ft: 0.3048 };
/** The unit of length: `units` itself, or its `length` where there is a unit of force beside it. */
export const unitOf = (request: Request): string => {
  const length = String(asObject(request.units)?.length ?? request.units);
  return length in METRES ? length : 'm';
};
export const metresOf = (request: Request): number => METRES[unitOf(request)] ?? 1;
export const upAxisOf = (request: Request): 1 | 2 => (request.up === 'y' ? 1 : 2);

/** A polyline of a request. Its points are the request's own arrays; some may not be points at all. */
export interface Line {
  name: string; path: Path; points: unknown[]; closed: boolean; planar: boolean;
  /** The points that are drawn and can be moved; all of them unless given. None is added or removed then. */
  only?: Set<number>;
}

const isNumber = (value: unknown): value is number => typeof value === 'number' && Number.isFinite(value);
export const isPoint = (value: unknown): value is number[] => Array.isArray(value) && value.length === 3 && value.every(isNumber);

/**
 * Where a point of a request is drawn: a coordinate that is no number counts as 0; null if nothing about it is a point.
 */
export function coordinates(point: unknown): Vec3 | null {
  if (!Array.isArray(point) || !point.some(isNumber)) return null;
  return [0, 1, 2].map((axis) => (isNumber(point[axis]) && Math.abs(point[axis]) < 1e150 ? point[axis] : 0)) as Vec3;
}

/** Every polyline of a request that can be drawn and edited. */
export function linesOf(kind: Kind, request: Request): Line[] {
  const found: Line[] = [];
  const one = (name: string, path: Path, points: unknown, closed: boolean, planar = false): void => {
    if (Array.isArray(points)) found.push({ name, path, points, closed, planar });
  };
  const many = (name: string, path: Path, list: unknown, closed: boolean, planar = false): void => {
    if (Array.isArray(list)) list.forEach((points, i) => one(`${name} ${i + 1}`, [...path, i], points, closed, planar));
  };
  if (kind === 'ruled_surface') many('rail', ['directrices'], request.directrices, request.closed === true);
  if (kind === 'tensile_structure') {
    many('boundary', ['boundaries'], request.boundaries, true);
    // Masts and cables in the air are moved by the ends that are supports.
    const members = (list: unknown): { name?: unknown; points?: unknown; hub?: unknown }[] => (Array.isArray(list) ? list.map((each) => asObject(each) ?? {}) : []);
    const tied = new Set([request.boundaries, [request.joints], [members(request.rings).map(({ hub }) => hub)]].flat(2).filter(Array.isArray).map(String));
    for (const list of ['masts', 'cables']) {
      members(request[list]).forEach(({ name, points }, i) => {
        const only = new Set([0, 1].filter((end) => Array.isArray(points) && !tied.has(String(points[end]))));
        if (Array.isArray(points) && only.size > 0) found.push({ name: typeof name === 'string' ? name : `${singular(list)} ${i + 1}`, path: [list, i, 'points'], points, closed: false, planar: false, only });
      });
    }
  }
  // The other vertices of a net are only where form finding begins.
  if (kind === 'cable_net' && Array.isArray(request.vertices)) {
    const supports = new Set((Array.isArray(request.supports) ? request.supports as unknown[] : []).filter(Number.isInteger) as number[]);
    found.push({ name: 'vertices', path: ['vertices'], points: request.vertices, closed: false, planar: false, only: supports });
  }
  if (kind === 'minimal_surface') {
    many('boundary', ['boundaries'], request.boundaries, true);
    const constraints = asObject(request.constraints);
    many('rope', ['constraints', 'polylines'], constraints?.polylines, false);
    if (Array.isArray(constraints?.points) && constraints.points.length > 0) one('fixed points', ['constraints', 'points'], constraints.points, false);
  }
  const domain = asObject(request.domain);
  if (domain) {
    one('polygon', ['domain', 'polygon'], domain.polygon, true, true);
    many('hole', ['domain', 'holes'], domain.holes, true, true);
    many('boundary', ['domain', 'boundaries'], domain.boundaries, true);
    for (const patch of ['bezier', 'nurbs']) many('control row', ['domain', patch, 'control_points'], asObject(domain[patch])?.control_points, false);
  }
  return found;
}

const asObject = (value: unknown): Record<string, unknown> | null =>
  (value !== null && typeof value === 'object' && !Array.isArray(value) ? value as Record<string, unknown> : null);

/** Points that are no chain: they are drawn as points, without a line through them. */
export const isLoose = (line: Line): boolean => line.only !== undefined || (line.path[0] === 'constraints' && line.path[1] === 'points');
/** Whether a point of a line is drawn. */
export const isShown = (line: Line, point: number): boolean => line.only?.has(point) ?? true;

/** The value that a path leads to. */
export function at(request: Request, path: Path): unknown {
  return path.reduce<unknown>((value, step) => (value as Record<string | number, unknown> | undefined)?.[step], request);
}

export interface Place { text: string; line?: number; point?: number; axis?: number; field?: string }

const SINGULAR: Record<string, string> = { vertices: 'vertex', boundaries: 'boundary', directrices: 'rail' };
const singular = (list: string): string => SINGULAR[list] ?? list.replace(/s$/, '').replaceAll('_', ' ');

/** The steps of a pointer as words: `edges`, `4` is edge 5. */
const wordsOf = (steps: string[]): string[] => steps.flatMap((step, i) => {
  const isNumbered = /^\d+$/.test(steps[i + 1] ?? '');
  if (!/^\d+$/.test(step)) return isNumbered ? [] : [step.replaceAll('_', ' ')];
  const list = steps[i - 1] ?? '';
  return [`${/^\d*$/.test(list) ? '' : `${singular(list)} `}${Number(step) + 1}`];
});

/** A pointer as words counted from 1, and the point or the field that it names. */
export function place(lines: Line[], pointer: string): Place {
  const steps = pointer.split('/').slice(1).map((step) => step.replaceAll('~1', '/').replaceAll('~0', '~'));
  const index = lines.findIndex((line) => line.path.every((step, i) => String(step) === steps[i]));
  if (index < 0) {
    // A pointer to the whole list names all its lines; to a companion of a line (normals, tangents) the same point.
    const companion = /^(normals|tangents)$/.test(steps[0] ?? '') ? lines.findIndex((line) => line.path[0] === 'directrices' && String(line.path[1]) === steps[1]) : -1;
    if (companion >= 0 && /^\d+$/.test(steps[2] ?? '')) {
      return { text: `${steps[0]} of ${lines[companion]!.name}, point ${Number(steps[2]) + 1}`, line: companion, point: Number(steps[2]), field: steps[0]! };
    }
    return { text: wordsOf(steps).join(', ') || 'the request', ...(steps[0] !== undefined && { field: steps[0] }) };
  }
  const line = lines[index]!;
  const [point, axis] = steps.slice(line.path.length).map(Number);
  if (point === undefined || !Number.isInteger(point)) return { text: line.name, line: index };
  const suffix = axis === undefined ? '' : `, ${'xyz'[axis] ?? 'coordinate'}`;
  return { text: `${line.name}, point ${point + 1}${suffix}`, line: index, point: Math.min(point, line.points.length - 1), ...(axis !== undefined && { axis }) };
}

/** A request with nothing drawn yet. */
export function blank(kind: Kind): Request {
  if (kind === 'ruled_surface') return { directrices: [] };
  if (kind === 'uniform_mesh') return { domain: {}, edge_length: 1 };
  if (kind === 'tensile_structure') return { boundaries: [], film: { tension: 1 } };
  if (kind === 'cable_net') return { vertices: [], edges: [], supports: [], cables: [{ force_density: 1 }] };
  return { boundaries: [] };
}

/** Whether there is enough drawn to ask for a solution. */
export function isWhole(kind: Kind, request: Request): boolean {
  const lines = linesOf(kind, request);
  if (kind === 'ruled_surface') return lines.length >= 2;
  if (kind === 'cable_net') return Array.isArray(request.edges) && request.edges.length > 0;
  return lines.length >= 1 || (kind === 'uniform_mesh' && Object.keys(asObject(request.domain) ?? {}).length > 0);
}

/** The kind that a request's own fields speak for. */
export function kindOf(request: Request): Kind | null {
  if (typeof request.kind === 'string') return request.kind in KINDS ? request.kind as Kind : null;
  if ('boundaries' in request) return 'minimal_surface';
  if ('directrices' in request) return 'ruled_surface';
  if ('edges' in request) return 'cable_net';
  return 'domain' in request ? 'uniform_mesh' : null;
}

/** A request as text, with each point on one line. */
export const print = (request: unknown): string =>
  JSON.stringify(request, null, 1).replace(/\[\s+([^[\]{}]*?)\s+\]/g, (_, inner: string) => `[${inner.replace(/\s+/g, ' ')}]`);
