// What every reader of a file gives: polylines, or one sentence about what is wrong and in which line.

import type { Vec3 } from '../model/request';

export interface Polyline { points: Vec3[]; closed: boolean }

export class FileFault extends Error {
  constructor(what: string, line?: number) {
    super(line === undefined ? what : `Line ${line}: ${what}`);
  }
}

/** A quoted piece of a file, short enough for a sentence. */
export const quote = (text: string): string => `“${text.trim().slice(0, 24)}${text.trim().length > 24 ? '…' : ''}”`;

export function finite(text: string, line: number): number {
  const value = Number(text.trim());
  if (text.trim() === '' || !Number.isFinite(value)) throw new FileFault(`${quote(text)} is not a number.`, line);
  return value;
}

/** A polyline whose last point repeats its first is closed and does not need the repetition. */
export function polyline(points: Vec3[], closed = false): Polyline {
  const [first] = points, last = points.at(-1);
  const repeats = points.length > 2 && first!.every((value, axis) => value === last![axis]);
  return { points: repeats ? points.slice(0, -1) : points, closed: closed || repeats };
}

/** Loose segments joined to chains where their ends agree to `tolerance` of their whole size. */
export function chains(segments: [Vec3, Vec3][], tolerance = 1e-7): Polyline[] {
  const size = Math.max(...segments.flat(1).flat().map(Math.abs), 1e-300);
  const step = size * tolerance;
  const name = (point: Vec3): string => point.map((value) => Math.round(value / step)).join(',');
  const at = new Map<string, number[]>();
  segments.forEach(([a, b], i) => {
    for (const end of [a, b]) {
      const list = at.get(name(end)) ?? [];
      list.push(i);
      at.set(name(end), list);
    }
  });
  const used = new Set<number>();
  const follow = (from: Vec3): Vec3[] => {
    const out: Vec3[] = [];
    for (let here = from; ;) {
      const around = at.get(name(here)) ?? [];
      const next = around.length <= 2 ? around.find((i) => !used.has(i)) : undefined;
      if (next === undefined) return out;
      used.add(next);
      const [a, b] = segments[next]!;
      here = name(a) === name(here) ? b : a;
      out.push(here);
    }
  };
  const found: Polyline[] = [];
  segments.forEach(([a, b], i) => {
    if (used.has(i)) return;
    used.add(i);
    const forth = follow(b), back = follow(a);
    const points = [...back.reverse(), a, b, ...forth];
    const closed = points.length > 3 && name(points[0]!) === name(points.at(-1)!);
    found.push({ points: closed ? points.slice(0, -1) : points, closed });
  });
  return found;
}
