// glTF: its line primitives, in metres with y up.

import { Matrix4, Quaternion, Vector3 } from 'three';
import type { Vec3 } from '../model/request';
import { type Gltf, LINE_LOOP, LINE_STRIP, LINES, type Node, readGlb, readGltfText } from '../stage/glb';
import { segmentsOf } from '../stage/mesh';
import { chains, type Drawing, FileFault, type Polyline } from './lines';

/** Deepest nesting of nodes. A file whose nodes contain themselves ends here. */
const DEEPEST = 64;

export function readGltf(content: ArrayBuffer | string): Drawing {
  const found: Polyline[] = [];
  try {
    const gltf = typeof content === 'string' ? readGltfText(content) : readGlb(content);
    const { nodes = [], scenes = [], scene = 0, extensionsRequired = [] } = gltf.document;
    if (extensionsRequired.length > 0) throw new Error(`it needs ${extensionsRequired.join(', ')}.`);
    const children = new Set(nodes.flatMap((node) => node.children ?? []));
    const roots = scenes[scene]?.nodes ?? nodes.map((_, i) => i).filter((i) => !children.has(i));
    for (const root of roots) visit(gltf, root, new Matrix4(), 0, found);
  } catch (error) {
    throw new FileFault(`This is not glTF that can be read: ${error instanceof Error ? error.message : String(error)}`);
  }
  if (found.length === 0) throw new FileFault('This glTF file has no lines.');
  return { format: 'glTF', lines: found, unit: 'm', up: 'y', single: true, notes: [] };
}

function visit(gltf: Gltf, index: number, outer: Matrix4, depth: number, found: Polyline[]): void {
  const node = gltf.document.nodes?.[index];
  if (!node || depth > DEEPEST) return;
  const place = outer.clone().multiply(matrixOf(node));
  for (const { attributes, indices, mode } of node.mesh === undefined ? [] : gltf.document.meshes![node.mesh]!.primitives) {
    if (mode === undefined || ![LINES, LINE_LOOP, LINE_STRIP].includes(mode) || attributes.POSITION === undefined) continue;
    const array = segmentsOf(gltf.read(attributes.POSITION).array as Float32Array, indices === undefined ? null : gltf.read(indices).array, mode);
    const at = (i: number): Vec3 => new Vector3().fromArray(array, i).applyMatrix4(place).toArray();
    const segments: [Vec3, Vec3][] = [];
    for (let i = 0; i < array.length; i += 6) segments.push([at(i), at(i + 3)]);
    if (segments.length > 0) found.push(...chains(segments, 1e-6, node.name));
  }
  for (const child of node.children ?? []) visit(gltf, child, place, depth + 1, found);
}

function matrixOf({ matrix, translation = [0, 0, 0], rotation = [0, 0, 0, 1], scale = [1, 1, 1] }: Node): Matrix4 {
  if (matrix) return new Matrix4().fromArray(matrix);
  return new Matrix4().compose(new Vector3().fromArray(translation), new Quaternion().fromArray(rotation), new Vector3().fromArray(scale));
}
