// Wavefront OBJ: its `l` lines, and where there are none the free edges of its faces. The usual loaders keep 32 bits of a
// coordinate; survey coordinates need 64.

import type { Vec3 } from '../model/request';
import { chains, FileFault, finite, type Polyline, polyline, quote } from './lines';

export function readObj(text: string): Polyline[] {
  const vertices: Vec3[] = [];
  const lines: Polyline[] = [];
  const edges = new Map<string, [number, number] | null>();
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
    } else if (word === 'l') lines.push(polyline(rest.map((item) => vertices[index(item)]!)));
    else if (word === 'f') {
      const corners = rest.map(index);
      corners.forEach((a, k) => {
        const b = corners[(k + 1) % corners.length]!;
        const key = `${Math.min(a, b)} ${Math.max(a, b)}`;
        edges.set(key, edges.has(key) ? null : [a, b]);
      });
    } else if (!/^(vn|vt|vp|p|o|g|s|mtllib|usemtl|mg|cstype|deg|curv|curv2|surf|parm|end)$/.test(word)) throw new FileFault(`${quote(raw)} is not OBJ.`, i + 1);
  });
  if (lines.length > 0) return lines.length > 1 && lines.every(({ points }) => points.length === 2) ? chains(lines.map(({ points }) => points as [Vec3, Vec3])) : lines;
  const free = [...edges.values()].filter((edge): edge is [number, number] => edge !== null);
  if (free.length > 0) return chains(free.map(([a, b]) => [vertices[a]!, vertices[b]!]));
  if (vertices.length > 0) return [polyline(vertices)];
  throw new FileFault('This OBJ file has no lines, no faces and no vertices.');
}
