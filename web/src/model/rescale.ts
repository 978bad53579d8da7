// A request in another unit of length: its coordinates, and every other value that holds a length.

import type { Kind } from 'plateau-client';
import { cablesOf } from './cables';
import { coordinates, linesOf, type Request, type Vec3 } from './request';

type Values = Record<string, unknown>;

/** The powers of length in the fields of a request, by their paths. A step `*` stands for every item of a list. */
const POWERS: Record<string, number> = {
  'resolution.edge_length': 1, 'edge_length': 1, 'length_tolerance': 1, 'sampling.tolerance': 1, 'rail_tolerance': 1,
  'pressure': -2, 'volume': 3, 'film.tension': -1, 'film.warp': -1, 'film.weft': -1, 'film.weight': -2, 'layers.*.tension': -1, 'layers.*.warp': -1, 'layers.*.weft': -1, 'layers.*.weight': -2,
  'chambers.*.pressure': -2, 'chambers.*.volume': 3, 'cables.*.weight': -1, 'cables.*.force_density': -1, 'cables.*.length': 1, 'least_force_density': -1,
  'supports.*.on.circle.radius': 1, 'supports.*.on.cylinder.radius': 1, 'supports.*.on.sphere.radius': 1, 'supports.*.on.torus.radius': 1, 'supports.*.on.torus.tube_radius': 1, 'supports.*.on.mesh.rounding': 1,
};
/** The points of a request that are no points of its lines, or lists of them. */
const POINTS = [
  'initial_mesh.vertices', 'cables.*.points', 'cables.*.across', 'joints', 'masts.*.points', 'film.direction.along', 'film.direction.radial.point', 'layers.*.direction.along', 'layers.*.direction.radial.point',
  'rings.*.hub', 'supports.*.on.circle.centre', 'supports.*.on.cylinder.point', 'supports.*.on.line.point', 'supports.*.on.mesh.vertices', 'supports.*.on.plane.point', 'supports.*.on.sphere.centre', 'supports.*.on.torus.centre',
];
/** Powers of length in the values of cables and masts, by what they hold constant. */
const OF_MODE: Record<string, number> = { force_density: -1, length: 1, unstressed_length: 1, sag: 1 };

/** Rounds off the error of a product. */
const round = (value: number): number => Number(value.toPrecision(14));

/** Multiplies all lengths of a request by a factor, in place. Angles, shares and forces stay. */
export function rescale(kind: Kind, request: Request, factor: number): void {
  const scaled = (value: unknown, power: number): unknown => (typeof value === 'number' ? round(value * factor ** power) : value);
  const points = (value: unknown): unknown => (Array.isArray(value) ? value.map((each) => (Array.isArray(each) ? points(each) : scaled(each, 1))) : value);
  for (const line of linesOf(kind, request)) {
    line.points.forEach((point, i) => { if (coordinates(point)) line.points[i] = points(point) as Vec3; });
  }
  for (const [path, power] of Object.entries(POWERS)) visit(request, path.split('.'), (value) => scaled(value, power));
  for (const path of POINTS) visit(request, path.split('.'), points);
  const masts = Array.isArray(request.masts) ? request.masts as { mode?: string; value?: unknown }[] : [];
  for (const each of [...cablesOf(request), ...masts] as { mode?: string; value?: unknown }[]) {
    if (each.value !== undefined) each.value = scaled(each.value, OF_MODE[each.mode ?? 'force'] ?? 0);
  }
}

function visit(within: unknown, [step, ...rest]: string[], change: (value: unknown) => unknown): void {
  if (step === '*') {
    if (Array.isArray(within)) within.forEach((each) => visit(each, rest, change));
    return;
  }
  if (within === null || typeof within !== 'object' || !(step! in within)) return;
  const values = within as Values;
  if (rest.length === 0) values[step!] = change(values[step!]);
  else visit(values[step!], rest, change);
}
