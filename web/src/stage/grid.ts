// The ground: a grid whose step follows the zoom, fading towards the horizon.

import { Color, DoubleSide, Mesh, PlaneGeometry, ShaderMaterial, type Vector3 } from 'three';

const VERTEX = `
varying vec2 at; uniform vec2 middle; uniform float size;
void main() {
  at = middle + position.xy * size * vec2(1.0, -1.0);
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`;

const FRAGMENT = `
varying vec2 at; uniform vec2 middle; uniform float step1, reach, strength; uniform vec3 ink;
float lines(float spacing) {
  vec2 cell = at / spacing;
  vec2 width = fwidth(cell);
  vec2 near = abs(fract(cell - 0.5) - 0.5) / width;
  // A grid finer than a few pixels is grey noise: it fades out before.
  float fine = 1.0 - smoothstep(0.12, 0.4, max(width.x, width.y));
  return (1.0 - min(min(near.x, near.y), 1.0)) * fine;
}
void main() {
  float fade = 1.0 - smoothstep(0.25, 1.0, length(at - middle) / reach);
  float alpha = max(lines(step1) * 0.45, lines(step1 * 10.0)) * fade * fade * strength;
  if (alpha < 0.004) discard;
  gl_FragColor = vec4(ink, alpha);
  #include <colorspace_fragment>
}`;

/**
 * Puts the ground behind whatever lies on it, seen from any side: further back than the surface's own offset (`surface.ts`),
 * which alone would let the ground show through a film that lies on it.
 */
export const BEHIND = { polygonOffset: true, polygonOffsetFactor: 3, polygonOffsetUnits: 4 };

export class Grid {
  readonly mesh: Mesh<PlaneGeometry, ShaderMaterial>;
  /** The grid's fine step, in metres. */
  step = 1;

  constructor() {
    const uniforms = {
      middle: { value: [0, 0] }, size: { value: 1 }, step1: { value: 1 }, reach: { value: 1 }, strength: { value: 0.5 }, ink: { value: new Color('#5b6b73') },
    };
    const material = new ShaderMaterial({ uniforms, vertexShader: VERTEX, fragmentShader: FRAGMENT, transparent: true, depthWrite: false, side: DoubleSide, ...BEHIND });
    this.mesh = new Mesh(new PlaneGeometry(1, 1), material);
    this.mesh.rotation.x = -Math.PI / 2;
    this.mesh.renderOrder = -2;
    this.mesh.frustumCulled = false;
  }

  place(centre: Vector3, radius: number, level: number): void {
    const { uniforms } = this.mesh.material;
    const reach = radius * 4.5;
    this.step = 10 ** Math.floor(Math.log10(radius / 2.5));
    // The middle lies on a line, so that the shader's 32 bits count from a line too.
    const coarse = this.step * 10;
    const [x, z] = [Math.round(centre.x / coarse) * coarse, Math.round(centre.z / coarse) * coarse];
    // A little below what lies on the ground, so that a flat model hides it.
    this.mesh.position.set(x, level - 0.004 * radius, z);
    this.mesh.scale.setScalar(2 * reach);
    Object.assign(uniforms.middle!, { value: [0, 0] });
    uniforms.size!.value = 2 * reach;
    uniforms.step1!.value = this.step;
    uniforms.reach!.value = reach;
  }

  style(ink: string, strength: number): void {
    (this.mesh.material.uniforms.ink!.value as Color).set(ink);
    this.mesh.material.uniforms.strength!.value = strength;
  }
}
