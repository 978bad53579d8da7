// What every reader of a file gives: polylines with what the file says of them, or one sentence about what is wrong
// and in which line.

import type { Kind } from 'plateau-client';
import type { Vec3 } from '../model/request';
import type { FileUnit } from './units';

/** `layer`: the layer, object or group of the file that the line belongs to. */
export interface Polyline { points: Vec3[]; closed: boolean; layer?: string }

export interface Drawing {
  format: string;
  lines: Polyline[];
  /** The unit that the file names; null if it names none. */
  unit: FileUnit | null;
  /** The axis that points up, where the file or its format says so. */
  up: 'y' | 'z' | null;
  /** Whether the coordinates have only the digits of 32-bit numbers. */
  single?: boolean;
  /** The kind whose result the file holds. */
  kind?: Kind;
  /** The layers that are taken at first; all of them unless given. */
  taken?: string[];
  /** Facts about the reading that a person should know. */
  notes: string[];
}

export class FileFault extends Error {
  constructor(what: string, line?: number) {
    super(line === undefined ? what : `Line ${line}: ${what}`);
  }
}

/** A quoted piece of a file, short enough for a sentence. */
export const quote = (text: string): string => `“${text.trim().slice(0, 24)}${text.trim().length > 24 ? '…' : ''}”`;

/**
 * A number of a text file: `1234.5`, `1234,5`, `1 234,5`, `1'234.5` or `1.234,5`. Lone commas and dots are decimal
 * signs.
 */
export function numeric(text: string): number {
  const bare = text.trim().replace(/(?<=\d)[\s\u00a0\u202f'’](?=\d{3}(?!\d))/g, '');
  const [comma, dot] = [bare.lastIndexOf(','), bare.lastIndexOf('.')];
  const plain = comma < 0 ? bare : dot < 0 ? (bare.indexOf(',') === comma ? bare.replace(',', '.') : bare.replaceAll(',', ''))
    : comma > dot ? bare.replaceAll('.', '').replace(',', '.') : bare.replaceAll(',', '');
  return plain === '' ? NaN : Number(plain);
}

export function finite(text: string, line: number): number {
  const value = numeric(text);
  if (text.trim() === '' || !Number.isFinite(value)) throw new FileFault(`${quote(text)} is not a number.`, line);
  return value;
}

/** A polyline whose last point repeats its first is closed and does not need the repetition. */
export function polyline(points: Vec3[], closed = false, layer?: string): Polyline {
  const [first] = points, last = points.at(-1);
  const repeats = points.length > 2 && first!.every((value, axis) => value === last![axis]);
  return { points: repeats ? points.slice(0, -1) : points, closed: closed || repeats, ...(layer !== undefined && { layer }) };
}

/** Loose segments joined to chains where their ends agree to `tolerance` of their whole size. */
export function chains(segments: [Vec3, Vec3][], tolerance = 1e-7, layer?: string): Polyline[] {
  const size = segments.reduce((most, ends) => ends.reduce((each, end) => Math.max(each, ...end.map(Math.abs)), most), 1e-300);
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
    found.push({ points: closed ? points.slice(0, -1) : points, closed, ...(layer !== undefined && { layer }) });
  });
  return found;
}
