// glTF: its line primitives, in metres with y up, turned to the request's axes by whoever opens the file.

import { type Line, Vector3 } from 'three';
import { GLTFLoader } from 'three/examples/jsm/loaders/GLTFLoader.js';
import type { Vec3 } from '../model/request';
import { segmentsOf } from '../stage/mesh';
import { chains, FileFault, type Polyline } from './lines';

interface Document { buffers?: { uri?: string; byteLength: number }[]; bufferViews?: { buffer: number; byteOffset?: number }[] }

/**
 * glTF as JSON, its embedded buffers in one binary chunk: the loader would fetch their data URIs, which the page's policy
 * does not allow.
 */
function binary(text: string): ArrayBuffer {
  const document = JSON.parse(text) as Document;
  const starts: number[] = [];
  const parts: Uint8Array[] = [];
  let length = 0;
  for (const { uri = '' } of document.buffers ?? []) {
    const [, data] = /^data:[^,]*;base64,(.*)$/s.exec(uri) ?? [];
    if (data === undefined) throw new Error('its data lies in another file; save it as GLB or with embedded buffers.');
    const part = Uint8Array.from(atob(data), (c) => c.charCodeAt(0));
    starts.push(length);
    parts.push(part);
    length += (part.length + 3) & ~3;
  }
  for (const view of document.bufferViews ?? []) {
    view.byteOffset = (view.byteOffset ?? 0) + (starts[view.buffer] ?? 0);
    view.buffer = 0;
  }
  document.buffers = [{ byteLength: length }];
  const json = new TextEncoder().encode(JSON.stringify(document));
  const jsonLength = (json.length + 3) & ~3;
  const bytes = new Uint8Array(12 + 8 + jsonLength + 8 + length).fill(0x20, 20, 20 + jsonLength);
  const header = new DataView(bytes.buffer);
  [0x46546c67, 2, bytes.length, jsonLength, 0x4e4f534a].forEach((word, i) => header.setUint32(4 * i, word, true));
  bytes.set(json, 20);
  header.setUint32(20 + jsonLength, length, true);
  header.setUint32(24 + jsonLength, 0x004e4942, true);
  parts.forEach((part, i) => bytes.set(part, 28 + jsonLength + starts[i]!));
  return bytes.buffer;
}

export async function readGltf(content: ArrayBuffer | string): Promise<Polyline[]> {
  const found: Polyline[] = [];
  try {
    const gltf = await new GLTFLoader().parseAsync(typeof content === 'string' ? binary(content) : content, '');
    gltf.scene.updateMatrixWorld(true);
    gltf.scene.traverse((object) => {
      const line = object as Line;
      if (!line.isLine) return;
      const array = segmentsOf(line);
      const at = (i: number): Vec3 => new Vector3().fromArray(array, i).applyMatrix4(line.matrixWorld).toArray();
      const segments: [Vec3, Vec3][] = [];
      for (let i = 0; i < array.length; i += 6) segments.push([at(i), at(i + 3)]);
      if (segments.length > 0) found.push(...chains(segments, 1e-6));
    });
  } catch (error) {
    throw new FileFault(`This is not glTF that can be read: ${error instanceof Error ? error.message : String(error)}`);
  }
  if (found.length === 0) throw new FileFault('This glTF file has no lines.');
  return found;
}
