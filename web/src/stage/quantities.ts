// What can be read off a result: values at its vertices or along its lines, with an honest scale.

import { Vector3 } from 'three';
import { humanise, number } from '../text';
import type { Scale } from './colours';
import { type Edges, edgesOf, hasSurface, type LineSet, type ResultMesh } from './mesh';

export interface Quantity {
  id: string;
  label: string;
  unit: string;
  /** One value a vertex of the surface, or one a segment of `segments`. */
  at: 'vertex' | 'segment';
  values: Float32Array;
  segments?: Float32Array;
  scale: Scale;
  /** The ends of the scale. */
  low: number;
  high: number;
  /** Whether all values are zero as far as the computation can tell. */
  nought: boolean;
  /** Values no larger than this are called zero. */
  noise: number;
}

/**
 * A mean curvature times the model's radius below this is called zero: a surface bends by less than a ten-thousandth of a
 * radian over its own size. Converged films of 32-bit meshes lie at 1e-6 and below.
 */
const CURVATURE_NOISE = 1e-4;
/** Lengths that differ by less than this fraction are shown as equal. */
const LENGTH_NOISE = 1e-6;

/** Values along lines that differ by less than this fraction are shown as equal. */
const VALUE_NOISE = 1e-3;

/** The quantities that a result offers; values are computed when one is chosen. */
export function offered(mesh: ResultMesh, kind: string): { id: string; label: string }[] {
  const found = [{ id: 'plain', label: 'Plain' }];
  for (const name of mesh.attributes.keys()) found.push({ id: name, label: humanise(name) });
  // A net has no triangles.
  if (hasSurface(mesh)) found.push({ id: 'edge_length', label: 'Edge length' });
  if (hasSurface(mesh) && kind !== 'minimal_surface') found.push({ id: 'bending', label: 'Bending (fold angle)' });
  const names = new Set(along(mesh).flatMap((line) => line.values.map(({ name }) => name)));
  names.delete('length');
  for (const name of names) found.push({ id: `line:${name}`, label: humanise(name) });
  return found;
}

/** The lines that have values to be coloured by. The arrows of reactions are a layer of their own, with other magnitudes. */
const along = (mesh: ResultMesh): LineSet[] => mesh.lines.filter(({ name }) => name !== 'reactions');

/** The quantity that a result shows first: the forces of its cables, if it has some. */
export const firstOf = (mesh: ResultMesh): string => (mesh.lines.some(({ name, values }) => name.startsWith('cables') && values.some((each) => each.name === 'force')) ? 'line:force' : 'plain');

/** `metres`: metres of the request's unit, in which people read lengths. */
export function quantity(mesh: ResultMesh, id: string, unit: string, metres: number): Quantity | null {
  if (id === 'plain') return null;
  if (id === 'mean_curvature') return curvature(mesh, unit, metres);
  if (id === 'edge_length' || id === 'bending') return alongEdges(mesh, id, unit, metres);
  if (id.startsWith('line:')) return carried(mesh, id.slice(5));
  const values = mesh.attributes.get(id);
  return values ? scaled({ id, label: humanise(id), unit: '', at: 'vertex', values }, 0) : null;
}

type Plain = Pick<Quantity, 'id' | 'label' | 'unit' | 'at' | 'values' | 'segments'>;

function scaled(plain: Plain, noise: number): Quantity {
  let low = Infinity, high = -Infinity;
  for (const value of plain.values) {
    if (!Number.isFinite(value)) continue;
    low = Math.min(low, value);
    high = Math.max(high, value);
  }
  if (low > high) [low, high] = [0, 0];
  const largest = Math.max(Math.abs(low), Math.abs(high));
  const nought = largest <= noise;
  if (low < 0 && high > 0) return { ...plain, scale: 'diverging', low: -largest, high: largest, nought, noise };
  return { ...plain, scale: 'sequential', low, high, nought, noise };
}

/**
 * The service's mean curvature, which has no sign, with the sign of the surface's bend relative to its normals: positive where
 * it bends towards them.
 */
function curvature(mesh: ResultMesh, unit: string, metres: number): Quantity {
  const size = mesh.attributes.get('mean_curvature')!;
  const values = new Float32Array(size.length);
  const sign = bendSigns(mesh);
  let signed = false;
  for (let i = 0; i < size.length; i += 1) {
    values[i] = size[i]! * metres * (size[i]! < 0 ? 1 : sign[i]!);
    signed ||= values[i]! < 0;
  }
  mesh.geometry.computeBoundingSphere();
  const radius = mesh.geometry.boundingSphere!.radius / metres;
  const noise = radius > 0 ? CURVATURE_NOISE / radius : 0;
  const found = scaled({ id: 'mean_curvature', label: 'Mean curvature', unit: `1/${unit}`, at: 'vertex', values }, noise);
  const largest = Math.max(Math.abs(found.low), Math.abs(found.high));
  return { ...found, scale: 'diverging', low: -largest, high: largest };
}

/** +1 or -1 a vertex: on which side of the tangent plane its neighbours lie, weighted by cotangents. */
function bendSigns(mesh: ResultMesh): Float32Array {
  const { position, normal } = mesh.geometry.attributes;
  const index = mesh.geometry.index!.array;
  const sum = new Float64Array(position!.count);
  const at = (i: number): Vector3 => new Vector3().fromBufferAttribute(position!, i);
  const n = new Vector3();
  for (let t = 0; t < index.length; t += 3) {
    const corner = [index[t]!, index[t + 1]!, index[t + 2]!];
    const points = corner.map(at);
    for (let k = 0; k < 3; k += 1) {
      const [i, j] = [(k + 1) % 3, (k + 2) % 3];
      const u = points[i]!.clone().sub(points[k]!), v = points[j]!.clone().sub(points[k]!);
      const weight = u.dot(v) / Math.max(u.clone().cross(v).length(), 1e-30);
      const edge = points[j]!.clone().sub(points[i]!);
      sum[corner[i]!]! += weight * edge.dot(n.fromBufferAttribute(normal!, corner[i]!));
      sum[corner[j]!]! -= weight * edge.dot(n.fromBufferAttribute(normal!, corner[j]!));
    }
  }
  return Float32Array.from(sum, (value) => (value < 0 ? -1 : 1));
}

function alongEdges(mesh: ResultMesh, id: string, unit: string, metres: number): Quantity {
  const edges = edgesOf(mesh.geometry);
  const position = mesh.geometry.attributes.position!.array;
  const keep: number[] = [];
  for (let e = 0; e < edges.ends.length / 2; e += 1) if (id === 'edge_length' || edges.faces[2 * e + 1] !== -1) keep.push(e);
  const segments = new Float32Array(6 * keep.length), values = new Float32Array(keep.length);
  const normals = id === 'bending' ? faceNormals(mesh) : null;
  keep.forEach((e, i) => {
    const a = 3 * edges.ends[2 * e]!, b = 3 * edges.ends[2 * e + 1]!;
    for (let axis = 0; axis < 3; axis += 1) {
      segments[6 * i + axis] = position[a + axis]!;
      segments[6 * i + 3 + axis] = position[b + axis]!;
    }
    if (normals) values[i] = foldAngle(normals, edges, e);
    else values[i] = Math.hypot(position[a]! - position[b]!, position[a + 1]! - position[b + 1]!, position[a + 2]! - position[b + 2]!) / metres;
  });
  const bending = id === 'bending';
  const found = scaled({ id, label: bending ? 'Bending (fold angle)' : 'Edge length', unit: bending ? '°' : unit, at: 'segment', values, segments }, bending ? 0.01 : 0);
  return bending ? { ...found, low: 0 } : found;
}

function faceNormals(mesh: ResultMesh): Vector3[] {
  const { position } = mesh.geometry.attributes;
  const index = mesh.geometry.index!.array;
  const at = (i: number): Vector3 => new Vector3().fromBufferAttribute(position!, index[i]!);
  return Array.from({ length: index.length / 3 }, (_, t) => {
    const a = at(3 * t);
    return at(3 * t + 1).sub(a).cross(at(3 * t + 2).sub(a)).normalize();
  });
}

const foldAngle = (normals: Vector3[], { faces }: Edges, e: number): number =>
  (normals[faces[2 * e]!]!.angleTo(normals[faces[2 * e + 1]!]!) * 180) / Math.PI;

function carried(mesh: ResultMesh, name: string): Quantity | null {
  const sets = along(mesh).flatMap((line) => line.values.filter((each) => each.name === name).map((each) => ({ line, each })));
  if (sets.length === 0) return null;
  const total = sets.reduce((sum, { each }) => sum + each.values.length / 2, 0);
  const values = new Float32Array(total), segments = new Float32Array(6 * total);
  let at = 0;
  for (const { line, each } of sets) {
    segments.set(line.segments, 6 * at);
    for (let i = 0; i < each.values.length; i += 2) values[at + i / 2] = each.values[i]!;
    at += each.values.length / 2;
  }
  const found = scaled({ id: `line:${name}`, label: humanise(name), unit: sets[0]!.each.unit, at: 'segment', values, segments }, 0);
  // A force that is the same along a cable deviates by the error of the mesh.
  if (found.high - found.low > VALUE_NOISE * Math.max(Math.abs(found.low), Math.abs(found.high))) return found;
  const middle = Number(((found.low + found.high) / 2).toPrecision(4));
  return { ...found, low: middle, high: middle };
}

/** A value's place on the scale, from 0 to 1. Noise lies in the middle of a diverging scale. */
export function fraction(q: Quantity, value: number): number {
  if (q.nought) return q.scale === 'diverging' ? 0.5 : 0;
  const span = q.high - q.low;
  if (!(span > LENGTH_NOISE * Math.max(Math.abs(q.low), Math.abs(q.high)))) return 0.5;
  return (value - q.low) / span;
}

export const reading = (q: Quantity, value: number): string =>
  `${q.label} ${Math.abs(value) <= q.noise ? '≈ 0' : `${number(value, 4)}`}${q.unit === '°' ? '°' : q.unit && ` ${q.unit}`}`;

/** How many values fall into each of `bins` equal steps of the scale. */
export function histogram(q: Quantity, bins: number): number[] {
  const counts = new Array<number>(bins).fill(0);
  for (const value of q.values) if (Number.isFinite(value)) counts[Math.min(bins - 1, Math.max(0, Math.floor(fraction(q, value) * bins)))]! += 1;
  return counts;
}
