// Reads a mesh with the loaders of three.js, as a page would: node scripts/read_with_three.mjs FILE. Prints a line of JSON
// with the number of corners, and then the corners of all triangles in the scene's coordinates as little-endian f64.
import { readFile } from 'node:fs/promises';
import { extname } from 'node:path';

const load = (name) => import(new URL(`../web/node_modules/three/${name}`, import.meta.url));
globalThis.self = globalThis;
globalThis.ProgressEvent ??= class ProgressEvent extends Event {};
const { Mesh, Vector3 } = await load('build/three.module.js');

const path = process.argv[2];
const bytes = await readFile(path);
const buffer = bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength);
const kind = extname(path);
let scene;
if (kind === '.glb' || kind === '.gltf') {
  const { GLTFLoader } = await load('examples/jsm/loaders/GLTFLoader.js');
  scene = (await new GLTFLoader().parseAsync(kind === '.glb' ? buffer : bytes.toString(), '')).scene;
} else if (kind === '.obj') {
  const { OBJLoader } = await load('examples/jsm/loaders/OBJLoader.js');
  scene = new OBJLoader().parse(bytes.toString());
} else {
  const name = kind === '.ply' ? 'PLYLoader' : 'STLLoader';
  const loaders = await load(`examples/jsm/loaders/${name}.js`);
  scene = new Mesh(new loaders[name]().parse(buffer));
}
scene.updateMatrixWorld(true);

const corners = [];
scene.traverse((object) => {
  if (!object.isMesh) return;
  const { position } = object.geometry.attributes;
  const index = object.geometry.index;
  const count = index ? index.count : position.count;
  for (let k = 0; k < count; k++) {
    const vertex = new Vector3().fromBufferAttribute(position, index ? index.getX(k) : k);
    corners.push(...vertex.applyMatrix4(object.matrixWorld).toArray());
  }
});
process.stdout.write(`${JSON.stringify({ vertices: corners.length / 3 })}\n`);
process.stdout.write(new Uint8Array(Float64Array.from(corners).buffer));
