// A soft shadow on the ground below the model: its depth seen from below, blurred. Made again when the model changes only.

import {
  type Box3, Mesh, MeshBasicMaterial, NoBlending, type Object3D, OrthographicCamera, PlaneGeometry, type Scene, ShaderMaterial, WebGLRenderTarget,
  DoubleSide, type WebGLRenderer,
} from 'three';
import { BEHIND } from './grid';

const SIZE = 256;
/** The shadow's picture is this much larger than the model, so that the blur has room. */
const ROOM = 1.5;

const SEEN_FROM_BELOW = `
varying float height; uniform float ground, reach;
void main() { vec4 at = modelMatrix * vec4(position, 1.0); height = (at.y - ground) / reach; gl_Position = projectionMatrix * viewMatrix * at; }`;
const DARKNESS = `
varying float height;
void main() { gl_FragColor = vec4(0.0, 0.0, 0.0, 0.75 * pow(1.0 - clamp(height, 0.0, 1.0), 1.4)); }`;
const FLAT = 'varying vec2 at; void main() { at = uv; gl_Position = vec4(position.xy * 2.0, 0.0, 1.0); }';
const BLUR = `
varying vec2 at; uniform sampler2D picture; uniform vec2 step;
void main() {
  float sum = 0.0, weight = 0.0;
  for (float i = -8.0; i <= 8.0; i += 1.0) {
    float w = exp(-0.5 * i * i / 16.0);
    sum += w * texture2D(picture, at + i * step).a; weight += w;
  }
  gl_FragColor = vec4(0.0, 0.0, 0.0, sum / weight);
}`;

export class ContactShadow {
  readonly plane: Mesh<PlaneGeometry, MeshBasicMaterial>;
  private readonly targets = [new WebGLRenderTarget(SIZE, SIZE), new WebGLRenderTarget(SIZE, SIZE)] as const;
  private readonly camera = new OrthographicCamera(-1, 1, 1, -1, 0, 1);
  private readonly dark = new ShaderMaterial({
    vertexShader: SEEN_FROM_BELOW, fragmentShader: DARKNESS, side: DoubleSide, blending: NoBlending, uniforms: { ground: { value: 0 }, reach: { value: 1 } },
  });
  private readonly blur = new ShaderMaterial({
    vertexShader: FLAT, fragmentShader: BLUR, depthTest: false, depthWrite: false, blending: NoBlending,
    uniforms: { picture: { value: null }, step: { value: [0, 0] } },
  });
  private opacity = 0.5;
  private faded = false;
  private readonly page = new Mesh(new PlaneGeometry(1, 1), this.blur);

  constructor() {
    const material = new MeshBasicMaterial({ map: this.targets[0].texture, transparent: true, depthWrite: false, opacity: 0.5, toneMapped: false, ...BEHIND });
    this.plane = new Mesh(new PlaneGeometry(1, 1), material);
    this.plane.rotation.x = -Math.PI / 2;
    this.plane.renderOrder = -1;
    this.page.frustumCulled = false;
  }

  /** Draws the shadow of what `model` has as meshes. */
  update(renderer: WebGLRenderer, scene: Scene, model: Object3D, box: Box3, hidden: Object3D[]): void {
    const lines: Object3D[] = [];
    let any = false;
    model.traverse((each) => {
      if (each.userData.castsShadow) any ||= each.visible;
      else if ('isMesh' in each || 'isLine' in each || 'isPoints' in each) lines.push(each);
    });
    this.plane.visible = any;
    if (!any) return;
    const [width, depth] = [box.max.x - box.min.x, box.max.z - box.min.z];
    const size = Math.max(width, depth) * ROOM || 1;
    const reach = Math.max(box.max.y - box.min.y, 0.35 * size);
    const [x, z] = [(box.min.x + box.max.x) / 2, (box.min.z + box.max.z) / 2];
    const ground = box.min.y;
    this.plane.position.set(x, ground - 0.002 * size, z);
    this.plane.scale.setScalar(size);

    // Seen from below with the picture's upper side to the north, as the plane shows it.
    const { camera, dark, targets } = this;
    Object.assign(camera, { left: -size / 2, right: size / 2, top: size / 2, bottom: -size / 2, near: 0, far: 2 * reach + 0.1 * size });
    camera.position.set(x, ground + 2 * reach, z);
    camera.up.set(0, 0, -1);
    camera.lookAt(x, ground, z);
    camera.updateProjectionMatrix();
    dark.uniforms.ground!.value = ground;
    dark.uniforms.reach!.value = reach;

    const put = [...hidden, this.plane, ...lines].map((object) => [object, object.visible] as const);
    put.forEach(([object]) => { object.visible = false; });
    const before = renderer.getRenderTarget();
    const background = scene.background;
    scene.background = null;
    scene.overrideMaterial = dark;
    renderer.setRenderTarget(targets[0]);
    renderer.setScissorTest(false);
    renderer.clear();
    renderer.render(scene, camera);
    scene.overrideMaterial = null;
    scene.background = background;
    put.forEach(([object, visible]) => { object.visible = visible; });
    this.smear(renderer, targets[0], targets[1], [1.1 / SIZE, 0]);
    this.smear(renderer, targets[1], targets[0], [0, 1.1 / SIZE]);
    renderer.setRenderTarget(before);
  }

  private smear(renderer: WebGLRenderer, from: WebGLRenderTarget, to: WebGLRenderTarget, step: [number, number]): void {
    this.blur.uniforms.picture!.value = from.texture;
    this.blur.uniforms.step!.value = step;
    renderer.setRenderTarget(to);
    renderer.clear();
    renderer.render(this.page, this.camera);
  }

  style(opacity: number): void {
    this.opacity = opacity;
    this.fade(this.faded);
  }

  /** A film that is out of date has a faint shadow only. */
  fade(faded: boolean): void {
    this.faded = faded;
    this.plane.material.opacity = faded ? 0.25 * this.opacity : this.opacity;
  }
}
