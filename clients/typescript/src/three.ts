/** Into three.js, which is a peer dependency of this entry alone. */
import { BufferAttribute, BufferGeometry } from 'three';
import type { Mesh } from './mesh.js';

export interface GeometryOptions {
  /** The axis that points up in the geometry; by default the mesh's own. From z to y, (x, y, z) becomes (x, z, -y). */
  up?: 'y' | 'z';
}

/**
 * A geometry in the mesh's unit, with normals, around the mesh's origin: three.js keeps f32, which would be off by
 * centimetres at survey coordinates. `userData.origin` is where the object belongs, in the geometry's axes; put it into
 * the object's position, or leave it out to look at the mesh near zero. The attribute `mean_curvature` is set where it is
 * known.
 */
export function toBufferGeometry(mesh: Mesh<unknown>, options: GeometryOptions = {}): BufferGeometry {
  const up = options.up ?? mesh.up;
  const turned = (x: number, y: number, z: number): [number, number, number] =>
    up === mesh.up ? [x, y, z] : up === 'y' ? [x, z, -y] : [x, -z, y];
  const [ox, oy, oz] = mesh.origin;
  const positions = new Float32Array(mesh.vertices.length);
  for (let i = 0; i < positions.length; i += 3) {
    positions.set(turned(mesh.vertices[i]! - ox, mesh.vertices[i + 1]! - oy, mesh.vertices[i + 2]! - oz), i);
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(positions, 3));
  geometry.setIndex(new BufferAttribute(mesh.triangles, 1));
  if (mesh.meanCurvature) {
    geometry.setAttribute('mean_curvature', new BufferAttribute(new Float32Array(mesh.meanCurvature), 1));
  }
  geometry.computeVertexNormals();
  geometry.userData = { origin: turned(ox, oy, oz), unit: mesh.unit, up };
  return geometry;
}
