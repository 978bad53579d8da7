// What can be seen to be wrong with a drawing before it is sent, so that the offending points can be marked. The service is
// the judge: these findings only say where.

import { coordinates, isLoose, isPoint, type Line, type Vec3 } from './request';

export interface Finding { line: number; points: number[]; text: string }

/** Neighbours nearer than this fraction of the size count as one point, as the service has it. */
const SAME = 1e-9;
/** Lines with more points are not searched for crossings while they are edited. */
const MOST_SEGMENTS = 800;

const sub = (a: Vec3, b: Vec3): Vec3 => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const cross = (a: Vec3, b: Vec3): Vec3 => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const dot = (a: Vec3, b: Vec3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const size = (a: Vec3): number => Math.hypot(...a);

export function findings(lines: Line[]): Finding[] {
  return lines.flatMap((line, index) => (isLoose(line) ? unsound(line, index) : [...unsound(line, index), ...geometry(line, index)]));
}

function unsound(line: Line, index: number): Finding[] {
  return line.points.flatMap((point, i) => (isPoint(point) ? [] : [{ line: index, points: [i], text: `${line.name}, point ${i + 1} is not three numbers` }]));
}

function geometry(line: Line, index: number): Finding[] {
  const points = line.points.map(coordinates);
  if (points.some((point) => point === null) || points.length < 2) return [];
  const known = points as Vec3[];
  const extent = Math.max(...known.map((point) => size(sub(point, known[0]!))), 0);
  const found: Finding[] = [];
  const last = line.closed && known.length > 2 ? known.length : known.length - 1;
  for (let i = 0; i < last; i += 1) {
    const next = (i + 1) % known.length;
    if (size(sub(known[i]!, known[next]!)) <= SAME * extent) {
      found.push({ line: index, points: [i, next], text: `${line.name}, points ${i + 1} and ${next + 1} are the same` });
    }
  }
  if (line.closed && extent > 0 && collinear(known, extent)) {
    return [...found, { line: index, points: known.map((_, i) => i), text: `${line.name}: all points lie on one line` }];
  }
  // Equal neighbours meet everything that each other meets; they are said already.
  const repeated = new Set(found.map(({ points: [, second] }) => second));
  const kept = known.map((_, i) => i).filter((i) => !repeated.has(i));
  if (line.closed && kept.length <= MOST_SEGMENTS) found.push(...crossings(line, index, kept.map((i) => known[i]!), kept, extent));
  return found;
}

function collinear(points: Vec3[], extent: number): boolean {
  const first = points[0]!;
  const far = points.reduce((a, b) => (size(sub(b, first)) > size(sub(a, first)) ? b : a));
  const along = sub(far, first);
  return points.every((point) => size(cross(along, sub(point, first))) <= 1e-9 * extent * extent);
}

/** Segments of one loop that meet although they are no neighbours; `numbers` are the points' indices in the line. */
function crossings(line: Line, index: number, points: Vec3[], numbers: number[], extent: number): Finding[] {
  const found: Finding[] = [];
  const n = points.length;
  for (let i = 0; i < n && found.length < 4; i += 1) {
    for (let j = i + 2; j < n && found.length < 4; j += 1) {
      if (i === 0 && j === n - 1) continue;
      const [a, b, c, d] = [points[i]!, points[(i + 1) % n]!, points[j]!, points[(j + 1) % n]!];
      if (distance(a, b, c, d) > SAME * extent) continue;
      const ends = [i, (i + 1) % n, j, (j + 1) % n].map((k) => numbers[k]!);
      const [p, q, r, s] = ends.map((k) => k + 1);
      found.push({ line: index, points: ends, text: `${line.name}: the edge from point ${p} to ${q} meets the edge from ${r} to ${s}` });
    }
  }
  return found;
}

/** The distance between the segments a-b and c-d. */
function distance(a: Vec3, b: Vec3, c: Vec3, d: Vec3): number {
  const u = sub(b, a), v = sub(d, c), w = sub(a, c);
  const uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), uw = dot(u, w), vw = dot(v, w);
  const determinant = uu * vv - uv * uv;
  const clamp = (x: number): number => Math.min(1, Math.max(0, x));
  let s = determinant > 1e-14 * uu * vv ? clamp((uv * vw - vv * uw) / determinant) : 0;
  let t = vv > 0 ? clamp((uv * s + vw) / vv) : 0;
  s = uu > 0 ? clamp((uv * t - uw) / uu) : 0;
  t = vv > 0 ? clamp((uv * s + vw) / vv) : 0;
  return size(sub([a[0] + s * u[0], a[1] + s * u[1], a[2] + s * u[2]], [c[0] + t * v[0], c[1] + t * v[1], c[2] + t * v[2]]));
}
