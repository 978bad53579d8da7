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

/**
 * Loose pieces joined to chains where their ends agree to `tolerance` of the pieces' extent. A chain ends where more
 * than two pieces meet.
 */
export const chains = (pieces: Vec3[][], tolerance = 1e-7, layer?: string): Polyline[] =>
  chainsOf(pieces, tolerance).map(({ points, closed }) => ({ points, closed, ...(layer !== undefined && { layer }) }));

/**
 * The lines of a layer: loose pieces are joined to chains. Open lines remain as they are, except where they close a
 * loop of loose pieces.
 */
export function joined(loose: Vec3[][], lines: Polyline[], layer: string): Polyline[] {
  const open = lines.filter(({ closed }) => !closed);
  const loops = chainsOf([...loose, ...open.map(({ points }) => points)], 1e-7)
    .filter(({ closed, pieces }) => closed && pieces.some((i) => i < loose.length) && pieces.some((i) => i >= loose.length));
  const taken = new Set(loops.flatMap(({ pieces }) => pieces));
  return [
    ...lines.filter((line) => line.closed || !taken.has(loose.length + open.indexOf(line))), ...loops.map(({ points }) => ({ points, closed: true, layer })),
    ...chains(loose.filter((_, i) => !taken.has(i)), 1e-7, layer),
  ];
}

function chainsOf(pieces: Vec3[][], tolerance: number): { points: Vec3[]; closed: boolean; pieces: number[] }[] {
  const nodes = nodesOf(pieces, tolerance);
  const at: number[][] = [];
  nodes.forEach((both, i) => { for (const node of both) (at[node] ??= []).push(i); });
  const used = new Set<number>();
  const follow = (from: number): { points: Vec3[]; end: number; taken: number[] } => {
    const points: Vec3[] = [], taken: number[] = [];
    for (let here = from; ;) {
      const next = at[here]!.length <= 2 ? at[here]!.find((i) => !used.has(i)) : undefined;
      if (next === undefined) return { points, end: here, taken };
      used.add(next);
      taken.push(next);
      const [a, b] = nodes[next]!;
      points.push(...(a === here ? pieces[next]!.slice(1) : pieces[next]!.slice(0, -1).reverse()));
      here = a === here ? b : a;
    }
  };
  return nodes.flatMap(([a, b], i) => {
    if (used.has(i)) return [];
    used.add(i);
    const forth = follow(b), back = follow(a);
    const points = [...back.points.reverse(), ...pieces[i]!, ...forth.points];
    const closed = points.length > 3 && forth.end === back.end;
    return [{ points: closed ? points.slice(0, -1) : points, closed, pieces: [...back.taken, i, ...forth.taken] }];
  });
}

/**
 * The numbers of the places at which each piece begins and ends. Ends that are nearer than `tolerance` of the extent
 * share a place.
 */
function nodesOf(pieces: Vec3[][], tolerance: number): [number, number][] {
  const [low, high]: [Vec3, Vec3] = [[Infinity, Infinity, Infinity], [-Infinity, -Infinity, -Infinity]];
  for (const point of pieces.flat()) {
    point.forEach((value, axis) => {
      low[axis] = Math.min(low[axis]!, value);
      high[axis] = Math.max(high[axis]!, value);
    });
  }
  // Far from zero the coordinates themselves are rounded.
  const reach = Math.max(1e-300, ...low.flatMap((value, axis) => [tolerance * (high[axis]! - value), 1e-15 * Math.abs(value), 1e-15 * Math.abs(high[axis]!)]));
  const cells = new Map<string, { point: Vec3; node: number }[]>();
  const steps = [0, -1, 1];
  let count = 0;
  const nodeOf = (point: Vec3): number => {
    const [x, y, z] = point.map((value, axis) => Math.floor((value - low[axis]!) / reach)) as Vec3;
    // An end within reach lies in the same cell or in one beside it.
    for (const dx of steps) {
      for (const dy of steps) {
        for (const dz of steps) {
          const near = cells.get(`${x + dx},${y + dy},${z + dz}`)?.find((each) => Math.hypot(...point.map((value, axis) => value - each.point[axis]!)) <= reach);
          if (near) return near.node;
        }
      }
    }
    const cell = `${x},${y},${z}`;
    cells.set(cell, [...cells.get(cell) ?? [], { point, node: count }]);
    count += 1;
    return count - 1;
  };
  return pieces.map((piece) => [nodeOf(piece[0]!), nodeOf(piece.at(-1)!)]);
}
