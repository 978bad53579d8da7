// Reads the service's own binary glTF: one surface, and line sets as nodes of their own, all around one origin.

const ARRAYS = { 5121: Uint8Array, 5123: Uint16Array, 5125: Uint32Array, 5126: Float32Array };
const WIDTHS = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4 };
const LINES = 1, LINE_STRIP = 3;

export function parseGlb(buffer) {
  const words = new DataView(buffer);
  if (buffer.byteLength < 20 || words.getUint32(0, true) !== 0x46546c67) throw new Error('the mesh is not binary glTF');
  const textLength = words.getUint32(12, true);
  const document = JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, 20, textLength)));
  const start = 20 + textLength + 8;

  const accessor = (index) => {
    const { bufferView, byteOffset = 0, componentType, count, type } = document.accessors[index];
    const offset = start + (document.bufferViews[bufferView].byteOffset ?? 0) + byteOffset;
    return new ARRAYS[componentType](buffer, offset, count * WIDTHS[type]);
  };

  const [surface, ...lineNodes] = document.nodes;
  const { attributes, indices } = document.meshes[surface.mesh].primitives[0];
  return {
    extras: document.asset.extras,
    positions: accessor(attributes.POSITION),
    normals: accessor(attributes.NORMAL),
    colors: 'COLOR_0' in attributes ? accessor(attributes.COLOR_0) : null,
    triangles: accessor(indices),
    lines: lineNodes.map((node) => ({
      name: node.name,
      segments: concat(document.meshes[node.mesh].primitives.map((primitive) => segments(primitive, accessor))),
    })),
  };
}

/** Six numbers a segment, whatever the primitive's mode. */
function segments({ attributes, indices, mode }, accessor) {
  const positions = accessor(attributes.POSITION);
  const order = indices === undefined ? Uint32Array.from({ length: positions.length / 3 }, (_, i) => i) : accessor(indices);
  if (mode !== LINES && mode !== LINE_STRIP) return new Float32Array();
  const step = mode === LINES ? 2 : 1;
  const count = mode === LINES ? order.length >> 1 : Math.max(order.length - 1, 0);
  const out = new Float32Array(6 * count);
  for (let i = 0; i < count; i += 1) {
    for (let end = 0; end < 2; end += 1) {
      const vertex = 3 * order[step * i + end];
      out.set(positions.subarray(vertex, vertex + 3), 6 * i + 3 * end);
    }
  }
  return out;
}

function concat(arrays) {
  const out = new Float32Array(arrays.reduce((sum, array) => sum + array.length, 0));
  arrays.reduce((at, array) => (out.set(array, at), at + array.length), 0);
  return out;
}

/** Each edge of the triangles once, six numbers each. */
export function edges(positions, triangles) {
  const seen = new Set();
  const out = [];
  const count = positions.length / 3;
  for (let t = 0; t < triangles.length; t += 3) {
    for (let k = 0; k < 3; k += 1) {
      const a = triangles[t + k], b = triangles[t + (k + 1) % 3];
      const key = Math.min(a, b) * count + Math.max(a, b);
      if (seen.has(key)) continue;
      seen.add(key);
      out.push(a, b);
    }
  }
  const segments = new Float32Array(3 * out.length);
  out.forEach((vertex, i) => segments.set(positions.subarray(3 * vertex, 3 * vertex + 3), 3 * i));
  return segments;
}
