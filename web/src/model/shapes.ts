// Lines that are drawn by a few of their points: rectangles, circles, arcs and curves through points.

import { type Vec3 } from './request';

export type Shape = 'points' | 'curve' | 'arc' | 'rectangle' | 'circle';

/** The clicks after which a shape is whole. The others end on demand. */
export const CLICKS: Partial<Record<Shape, number>> = { arc: 3, rectangle: 2, circle: 2 };
/** Shapes that are closed lines. */
export const CLOSED: Shape[] = ['rectangle', 'circle'];

/** Points of a full circle, and of a curve between two of its points. */
const ROUND = 32, PER_SPAN = 6;

const mix = (a: Vec3, b: Vec3, t: number): Vec3 => a.map((value, axis) => value + t * (b[axis]! - value)) as Vec3;
const settle = (point: Vec3): Vec3 => point.map((value) => Number(value.toPrecision(10))) as Vec3;

/**
 * The points of a shape that is given by some of its points. `up` is the axis that points up; `closed` says whether
 * the line is.
 */
export function pointsOf(shape: Shape, given: Vec3[], up: 1 | 2, closed: boolean): Vec3[] {
  const [u, v] = up === 2 ? [0, 1] as const : [0, 2] as const;
  const [a, b, c] = given;
  if (shape === 'curve' && given.length > 2) return curve(given, closed).map(settle);
  if (shape === 'rectangle' && a && b) {
    const [right, far]: [Vec3, Vec3] = [[...a], [...b]];
    right[u] = b[u];
    far[u] = a[u];
    far[up] = a[up];
    return [a, right, [...b], far];
  }
  if (shape === 'circle' && a && b) return around(a, u, v, Math.atan2(b[v] - a[v], b[u] - a[u]), 2 * Math.PI, Math.hypot(b[u] - a[u], b[v] - a[v]), ROUND).slice(0, -1).map(settle);
  if (shape === 'arc' && a && b && c) return arc(a, b, c, u, v).map(settle);
  return given;
}

/** Points on a circle about a centre, from an angle on. */
const around = (centre: Vec3, u: number, v: number, from: number, span: number, radius: number, steps: number): Vec3[] => Array.from({ length: steps + 1 }, (_, i) => {
  const point: Vec3 = [...centre];
  point[u] = centre[u]! + radius * Math.cos(from + (span * i) / steps);
  point[v] = centre[v]! + radius * Math.sin(from + (span * i) / steps);
  return point;
});

/**
 * The arc from `a` through `b` to `c` in the plan, whose heights go evenly from `a` to `c`. A straight line where
 * they lie on one.
 */
function arc(a: Vec3, b: Vec3, c: Vec3, u: number, v: number): Vec3[] {
  const [bx, by, cx, cy] = [b[u]! - a[u]!, b[v]! - a[v]!, c[u]! - a[u]!, c[v]! - a[v]!];
  const d = 2 * (bx * cy - by * cx);
  if (Math.abs(d) < 1e-9 * (bx * bx + by * by + cx * cx + cy * cy)) return [a, b, c];
  const [bb, cc] = [bx * bx + by * by, cx * cx + cy * cy];
  const [ox, oy] = [(cy * bb - by * cc) / d, (bx * cc - cx * bb) / d];
  const centre: Vec3 = [...a];
  centre[u] = a[u]! + ox;
  centre[v] = a[v]! + oy;
  const angle = (point: Vec3): number => Math.atan2(point[v]! - centre[v]!, point[u]! - centre[u]!);
  const turn = 2 * Math.PI;
  const from = angle(a);
  const forward = (((angle(c) - from) % turn) + turn) % turn;
  // Counter-clockwise where the three points are.
  const span = d > 0 ? forward : forward - turn;
  const steps = Math.max(4, Math.ceil((ROUND * Math.abs(span)) / turn));
  const up = 3 - u - v;
  return around(centre, u, v, from, span, Math.hypot(ox, oy), steps).map((point, i) => {
    point[up] = a[up]! + ((c[up]! - a[up]!) * i) / steps;
    return i === 0 ? a : i === steps ? c : point;
  });
}

/**
 * Points of a curve through the given ones, `steps` from each to the next: the centripetal Catmull-Rom curve, because
 * it has no loops and no cusps between points at uneven distances. Ends are continued by reflection.
 */
export function curve(given: Vec3[], closed: boolean, steps = PER_SPAN): Vec3[] {
  const n = given.length;
  const at = (i: number): Vec3 => (closed ? given[(i + n) % n]! : given[i] ?? mix(given[i < 0 ? 1 : n - 2]!, given[i < 0 ? 0 : n - 1]!, 2));
  const spans = Array.from({ length: closed ? n : n - 1 }, (_, i) => {
    const [p, q, r, s] = [at(i - 1), at(i), at(i + 1), at(i + 2)];
    const parameter = (from: Vec3, to: Vec3): number => Math.sqrt(Math.hypot(...from.map((value, axis) => to[axis]! - value)));
    // Points that coincide take the parameter of the span between them.
    const b = parameter(q, r) || 1;
    const [a, c] = [parameter(p, q) || b, parameter(r, s) || b];
    return Array.from({ length: steps }, (__, k): Vec3 => q.map((value, axis) => {
      const [t, before, next, after] = [k / steps, p[axis]!, r[axis]!, s[axis]!];
      const rise = next - value;
      const [m, o] = [rise + b * ((value - before) / a - (next - before) / (a + b)), rise + b * ((after - next) / c - (after - value) / (b + c))];
      return value + t * (m + t * (3 * rise - 2 * m - o + t * (m + o - 2 * rise)));
    }) as Vec3);
  });
  return [...spans.flat(), ...(closed ? [] : [given.at(-1)!])];
}
