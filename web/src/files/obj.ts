// Wavefront OBJ: its `l` lines, and where there are none the free edges of its faces, by object or group. The usual
// loaders keep 32 bits of a coordinate; survey coordinates need 64. Files of this service say their unit and axis in
// their head.

import type { Kind } from 'plateau-client';
import type { Vec3 } from '../model/request';
import { chains, type Drawing, FileFault, finite, type Polyline, polyline, quote } from './lines';
import { type FileUnit, METRES } from './units';

/** The objects of this service's files that hold what was drawn, and the kind that draws it. */
const DRAWN: Record<string, Kind> = { directrices: 'ruled_surface', boundaries: 'minimal_surface' };
type Free = Map<string, { ends: [number, number]; layer: string | undefined } | null>;

export function readObj(text: string): Drawing {
  const vertices: Vec3[] = [];
  const lines: Polyline[] = [];
  const edges: Free = new Map();
  let layer: string | undefined;
  text.split(/\r?\n/).forEach((raw, i) => {
    const [word, ...rest] = raw.replace(/#.*/, '').trim().split(/\s+/);
    if (!word) return;
    const index = (item: string): number => {
      const n = parseInt(item, 10);
      const found = n < 0 ? vertices.length + n : n - 1;
      if (!vertices[found]) throw new FileFault(`there is no vertex ${quote(item)}.`, i + 1);
      return found;
    };
    if (word === 'v') {
      if (rest.length < 3) throw new FileFault('a vertex needs x, y and z.', i + 1);
      vertices.push(rest.slice(0, 3).map((value) => finite(value, i + 1)) as Vec3);
    } else if (word === 'l') lines.push(polyline(rest.map((item) => vertices[index(item)]!), false, layer));
    else if (word === 'o' || word === 'g') layer = rest.join(' ') || undefined;
    else if (word === 'f') {
      const corners = rest.map(index);
      corners.forEach((a, k) => {
        const b = corners[(k + 1) % corners.length]!;
        const key = `${Math.min(a, b)} ${Math.max(a, b)}`;
        edges.set(key, edges.has(key) ? null : { ends: [a, b], layer });
      });
    } else if (!/^(vn|vt|vp|p|s|mtllib|usemtl|mg|cstype|deg|curv|curv2|surf|parm|end)$/.test(word)) throw new FileFault(`${quote(raw)} is not OBJ.`, i + 1);
  });
  return { format: 'OBJ', ...headOf(text), ...partsOf(vertices, lines, edges) };
}

/** The unit and the axis that a file's first lines name. Blender exports with y up unless it is told otherwise. */
function headOf(text: string): Pick<Drawing, 'unit' | 'up' | 'notes'> {
  const [, unit, up] = /^# unit (\w+), ([yz]) up/m.exec(text) ?? [];
  const ours = unit !== undefined && unit in METRES;
  return { unit: ours ? unit as FileUnit : null, up: up as 'y' | 'z' | undefined ?? (/^# Blender/.test(text) ? 'y' : null), notes: [] };
}

function partsOf(vertices: Vec3[], lines: Polyline[], edges: Free): Pick<Drawing, 'lines' | 'kind' | 'taken'> {
  const layers = new Set(lines.map(({ layer }) => layer));
  if (lines.length > 0) {
    const [drawn] = Object.keys(DRAWN).filter((name) => layers.has(name));
    return { lines: [...layers].flatMap((layer) => joined(lines.filter((line) => line.layer === layer), layer)), ...(drawn !== undefined && { kind: DRAWN[drawn]!, taken: [drawn] }) };
  }
  const free = [...edges.values()].filter((edge) => edge !== null);
  const groups = new Set(free.map(({ layer }) => layer));
  if (free.length > 0) return { lines: [...groups].flatMap((layer) => chains(free.filter((edge) => edge.layer === layer).map(({ ends: [a, b] }) => [vertices[a]!, vertices[b]!]), 1e-7, layer)) };
  if (vertices.length > 0) return { lines: [polyline(vertices)] };
  throw new FileFault('This OBJ file has no lines, no faces and no vertices.');
}

/** Lines of two points each are the segments of chains. */
const joined = (lines: Polyline[], layer: string | undefined): Polyline[] =>
  (lines.length > 1 && lines.every(({ points }) => points.length === 2) ? chains(lines.map(({ points }) => points as [Vec3, Vec3]), 1e-7, layer) : lines);
