// Reads glTF: the files of the service, and the lines of other programs' files. Three.js's loader also knows textures, skins and
// animations, and is forty times as large.

type Numbers = Float32Array | Uint32Array | Uint16Array | Uint8Array;
interface Accessor { bufferView?: number; byteOffset?: number; componentType: number; count: number; type: string; sparse?: object }
export interface Primitive { attributes: Record<string, number>; indices?: number; mode?: number }
export interface Node {
  name?: string; mesh?: number; children?: number[]; matrix?: number[]; translation?: number[]; rotation?: number[]; scale?: number[];
  extras?: Record<string, { unit?: string }>;
}
interface Document {
  buffers?: { uri?: string; byteLength: number }[]; accessors?: Accessor[];
  bufferViews?: { buffer: number; byteOffset?: number; byteStride?: number }[];
  meshes?: { primitives: Primitive[] }[]; nodes?: Node[]; scenes?: { nodes?: number[] }[]; scene?: number;
  asset: { extras?: Record<string, unknown> }; extensionsRequired?: string[];
}
export interface Gltf {
  document: Document;
  /** The numbers of an accessor, `size` for each of its items. */
  read(accessor: number): { array: Numbers; size: number };
}

const COMPONENTS: Record<number, { new(buffer: ArrayBuffer, start: number, length: number): Numbers; new(length: number): Numbers; BYTES_PER_ELEMENT: number }> = {
  5121: Uint8Array, 5123: Uint16Array, 5125: Uint32Array, 5126: Float32Array,
};
const SIZES: Record<string, number> = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4 };
/** "glTF", "JSON". */
const MAGIC = 0x46546c67, JSON_CHUNK = 0x4e4f534a;
/** Modes of primitives. */
export const LINES = 1, LINE_LOOP = 2, LINE_STRIP = 3;

/** Reads a GLB file. Its arrays are views of these bytes. */
export function readGlb(bytes: ArrayBuffer): Gltf {
  const header = new DataView(bytes);
  if (bytes.byteLength < 20 || header.getUint32(0, true) !== MAGIC || header.getUint32(16, true) !== JSON_CHUNK) throw new Error('it does not begin as a GLB file does.');
  const length = header.getUint32(12, true);
  const document = JSON.parse(new TextDecoder().decode(new Uint8Array(bytes, 20, length))) as Document;
  // The binary chunk follows with its own length and type.
  return reader(document, [{ bytes, start: 20 + length + 8 }]);
}

/** Reads glTF as JSON text, with its data embedded. */
export function readGltfText(text: string): Gltf {
  const document = JSON.parse(text) as Document;
  return reader(document, (document.buffers ?? []).map(({ uri = '' }) => {
    const [, data] = /^data:[^,]*;base64,(.*)$/s.exec(uri) ?? [];
    if (data === undefined) throw new Error('its data lies in another file; save it as GLB or with embedded buffers.');
    return { bytes: Uint8Array.from(atob(data), (c) => c.charCodeAt(0)).buffer, start: 0 };
  }));
}

function reader(document: Document, buffers: { bytes: ArrayBuffer; start: number }[]): Gltf {
  const read: Gltf['read'] = (index) => {
    const { bufferView, byteOffset = 0, componentType, count, type, sparse } = document.accessors![index]!;
    const size = SIZES[type], Type = COMPONENTS[componentType];
    if (size === undefined || !Type || bufferView === undefined || sparse) throw new Error('its data is stored in a way that is not known here.');
    const { buffer, byteOffset: ofView = 0, byteStride } = document.bufferViews![bufferView]!;
    const { bytes, start } = buffers[buffer]!;
    const begin = start + ofView + byteOffset, stride = byteStride ?? size * Type.BYTES_PER_ELEMENT;
    if (stride === size * Type.BYTES_PER_ELEMENT) return { array: new Type(bytes, begin, size * count), size };
    const array = new Type(size * count);
    for (let item = 0; item < count; item += 1) array.set(new Type(bytes, begin + item * stride, size), item * size);
    return { array, size };
  };
  return { document, read };
}
