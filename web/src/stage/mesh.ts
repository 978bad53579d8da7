// A finished job's mesh as three.js reads it: one surface, and line sets with what they carry. A cable net has points in place
// of the surface: its geometry has no triangles.

import { BufferAttribute, BufferGeometry, type Line, type Mesh } from 'three';
import { GLTFLoader } from 'three/examples/jsm/loaders/GLTFLoader.js';
import type { Vec3 } from '../model/request';

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

interface Document { nodes: { name?: string; translation?: number[]; extras?: Record<string, { unit?: string }> }[]; asset: { extras?: Record<string, unknown> } }

const loader = new GLTFLoader();

export async function parseMesh(bytes: ArrayBuffer): Promise<ResultMesh> {
  const gltf = await loader.parseAsync(bytes, '');
  const document = gltf.parser.json as Document;
  const surface = await gltf.parser.getDependency('node', 0) as Mesh;
  const { geometry } = surface;
  const attributes = new Map<string, Float32Array>();
  for (const [name, attribute] of Object.entries(geometry.attributes)) {
    if (name.startsWith('_') && attribute instanceof BufferAttribute && attribute.itemSize === 1) {
      attributes.set(name.slice(1), attribute.array as Float32Array);
      geometry.deleteAttribute(name);
    }
  }
  geometry.deleteAttribute('color');
  if (!geometry.index) {
    geometry.setIndex([]);
    geometry.setAttribute('normal', new BufferAttribute(new Float32Array(3 * geometry.attributes.position!.count), 3));
  }
  const lines: LineSet[] = [];
  for (let index = 1; index < document.nodes.length; index += 1) {
    const node = await gltf.parser.getDependency('node', index) as Line;
    const parts: Line[] = [];
    node.traverse((each) => { if ((each as Line).isLine) parts.push(each as Line); });
    const segments = concat(parts.map(segmentsOf));
    const values: LineValues[] = [];
    const [only] = parts;
    if (only && parts.length === 1 && !only.geometry.index) {
      for (const [name, attribute] of Object.entries(only.geometry.attributes)) {
        if (!name.startsWith('_')) continue;
        const unit = Object.entries(document.nodes[index]!.extras ?? {}).find(([each]) => each.toLowerCase() === name)?.[1]?.unit ?? '';
        values.push({ name: name.slice(1), unit, values: attribute.array as Float32Array });
      }
    }
    lines.push({ name: document.nodes[index]!.name ?? 'lines', segments, values });
  }
  const [x = 0, y = 0, z = 0] = document.nodes[0]?.translation ?? [];
  return { geometry, attributes, lines, translation: [x, y, z], extras: document.asset.extras ?? {} };
}

export const hasSurface = ({ geometry }: ResultMesh): boolean => geometry.index!.count > 0;

/** Six numbers a segment, whatever the primitive's mode. */
export function segmentsOf(line: Line): Float32Array {
  const position = line.geometry.attributes.position as BufferAttribute;
  const order = line.geometry.index?.array ?? Uint32Array.from({ length: position.count }, (_, i) => i);
  const paired = (line as unknown as { isLineSegments?: boolean }).isLineSegments;
  const loop = (line as unknown as { isLineLoop?: boolean }).isLineLoop;
  const count = paired ? order.length >> 1 : Math.max(order.length - (loop ? 0 : 1), 0);
  const out = new Float32Array(6 * count);
  for (let i = 0; i < count; i += 1) {
    for (let end = 0; end < 2; end += 1) {
      const vertex = 3 * order[((paired ? 2 : 1) * i + end) % order.length]!;
      out.set((position.array as Float32Array).subarray(vertex, vertex + 3), 6 * i + 3 * end);
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
