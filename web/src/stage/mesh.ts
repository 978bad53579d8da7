// A finished job's mesh as three.js reads it: one surface, and line sets with what they carry. A cable net has points in place
// of the surface: its geometry has no triangles.

import { BufferAttribute, BufferGeometry } from 'three';
import { Frame } from '../model/frame';
import type { Request, Vec3 } from '../model/request';
import { LINE_LOOP, LINES, type Node, type Primitive, readGlb } from './glb';

export interface LineValues { name: string; unit: string; values: Float32Array }
export interface LineSet { name: string; segments: Float32Array; values: LineValues[] }
export interface ResultMesh {
  geometry: BufferGeometry;
  /** Vertex attributes that are not positions, normals or colours, by name without the underscore. */
  attributes: Map<string, Float32Array>;
  lines: LineSet[];
  /** Where the positions' zero lies: the node's translation, metres, y up, f64. */
  translation: Vec3;
  extras: Record<string, unknown>;
}

export async function parseMesh(bytes: ArrayBuffer): Promise<ResultMesh> {
  const { document: { nodes = [], meshes = [], asset }, read } = readGlb(bytes);
  const floats = (accessor: number): Float32Array => read(accessor).array as Float32Array;
  const [first, ...others] = nodes.filter(({ mesh }) => mesh !== undefined);
  const primitives = ({ mesh }: Node): Primitive[] => meshes[mesh!]!.primitives;
  const [surface] = primitives(first!);
  const geometry = new BufferGeometry();
  const attributes = new Map<string, Float32Array>();
  for (const [name, accessor] of Object.entries(surface!.attributes)) {
    const { array, size } = read(accessor);
    if (name === 'POSITION' || name === 'NORMAL') geometry.setAttribute(name.toLowerCase(), new BufferAttribute(array, size));
    else if (name.startsWith('_') && size === 1) attributes.set(name.slice(1).toLowerCase(), array as Float32Array);
  }
  geometry.setIndex(surface!.indices === undefined ? [] : new BufferAttribute(read(surface!.indices).array, 1));
  // A cable net has points only.
  if (!geometry.attributes.normal) geometry.setAttribute('normal', new BufferAttribute(new Float32Array(3 * geometry.attributes.position!.count), 3));
  const lines = others.map((node): LineSet => {
    const parts = primitives(node);
    const segments = concat(parts.map(({ attributes: { POSITION: position }, indices, mode }) => segmentsOf(floats(position!), indices === undefined ? null : read(indices).array, mode)));
    const values: LineValues[] = [];
    const [only] = parts;
    if (only && parts.length === 1 && only.indices === undefined) {
      for (const [name, accessor] of Object.entries(only.attributes)) {
        if (name.startsWith('_')) values.push({ name: name.slice(1).toLowerCase(), unit: node.extras?.[name]?.unit ?? '', values: floats(accessor) });
      }
    }
    return { name: node.name ?? 'lines', segments, values };
  });
  const [x = 0, y = 0, z = 0] = first!.translation ?? [];
  return { geometry, attributes, lines, translation: [x, y, z], extras: asset.extras ?? {} };
}

/** A mesh of vertices in the request's own unit and axes, three numbers each, without lines and attributes. */
export function meshOf(vertices: Float64Array, triangles: Uint32Array, request: Request): ResultMesh {
  const { metres, up } = new Frame([0, 0, 0], request);
  const [x, y, z] = vertices as unknown as Vec3;
  // Each move of a drag makes a mesh, so that the coordinates are turned here and not point by point by the frame.
  const positions = new Float32Array(vertices.length);
  for (let i = 0; i < vertices.length; i += 3) {
    const a = (vertices[i]! - x) * metres, b = (vertices[i + 1]! - y) * metres, c = (vertices[i + 2]! - z) * metres;
    positions[i] = a;
    positions[i + 1] = up === 2 ? c : b;
    positions[i + 2] = up === 2 ? -b : c;
  }
  const translation = new Frame([0, 0, 0], request).toScene([x, y, z]);
  const geometry = new BufferGeometry().setIndex(new BufferAttribute(triangles, 1)).setAttribute('position', new BufferAttribute(positions, 3));
  geometry.computeVertexNormals();
  return { geometry, attributes: new Map(), lines: [], translation, extras: {} };
}

export const hasSurface = ({ geometry }: ResultMesh): boolean => geometry.index!.count > 0;

/** Six numbers a segment of a line of glTF: pairs of points, a loop, or a chain. */
export function segmentsOf(positions: Float32Array, indices: ArrayLike<number> | null, mode: number | undefined): Float32Array {
  const order = indices ?? Uint32Array.from({ length: positions.length / 3 }, (_, i) => i);
  const paired = mode === LINES;
  const count = paired ? order.length >> 1 : Math.max(order.length - (mode === LINE_LOOP ? 0 : 1), 0);
  const out = new Float32Array(6 * count);
  for (let i = 0; i < count; i += 1) {
    for (let end = 0; end < 2; end += 1) {
      const vertex = 3 * order[((paired ? 2 : 1) * i + end) % order.length]!;
      out.set(positions.subarray(vertex, vertex + 3), 6 * i + 3 * end);
    }
  }
  return out;
}

function concat(arrays: Float32Array[]): Float32Array {
  const out = new Float32Array(arrays.reduce((sum, array) => sum + array.length, 0));
  let at = 0;
  for (const array of arrays) {
    out.set(array, at);
    at += array.length;
  }
  return out;
}

export interface Edges { ends: Uint32Array; faces: Int32Array }

/** Each edge of the triangles once: its two vertices, and its first two faces (-1 for none). */
export function edgesOf(geometry: BufferGeometry): Edges {
  const index = geometry.index!.array;
  const vertices = geometry.attributes.position!.count;
  const seen = new Map<number, number>();
  const ends: number[] = [], faces: number[] = [];
  for (let t = 0; t < index.length; t += 3) {
    for (let k = 0; k < 3; k += 1) {
      const a = index[t + k]!, b = index[t + ((k + 1) % 3)]!;
      const key = Math.min(a, b) * vertices + Math.max(a, b);
      const known = seen.get(key);
      if (known === undefined) {
        seen.set(key, ends.length / 2);
        ends.push(a, b);
        faces.push(t / 3, -1);
      } else if (faces[2 * known + 1] === -1) faces[2 * known + 1] = t / 3;
    }
  }
  return { ends: Uint32Array.from(ends), faces: Int32Array.from(faces) };
}
