// The stage: renderer, camera, light, ground, and drawing only when something has changed.

import CameraControls from 'camera-controls';
import {
  NeutralToneMapping, Box3, Color, DirectionalLight, Group, Matrix4, type Object3D, PerspectiveCamera, Quaternion, Raycaster,
  Scene, Sphere, Spherical, Vector2, Vector3, Vector4, WebGLRenderer,
} from 'three';
import type { Vec3 } from '../model/request';
import { studioLight } from './environment';
import { Grid } from './grid';
import { ContactShadow } from './shadow';

CameraControls.install({ THREE: { Box3, Matrix4, Quaternion, Raycaster, Sphere, Spherical, Vector2, Vector3, Vector4 } });

/** Field of view across the stage's smaller side. */
const FIELD = 30;
/** Field of view of a view along an axis. Its rays are parallel to half a pixel over a model's depth. */
const PARALLEL = 0.04;
const MOST_PIXELS_PER_PIXEL = 2;
/** Speed of a pinch, by which fingers that end twice as far apart show the model about twice as large. The wheel does not use it. */
const PINCH_SPEED = 2.5;

export interface Pose { eye: Vec3; target: Vec3 }
export interface Bounds { low: Vec3; high: Vec3; points: Float32Array[]; offsets: Vec3[] }

/** A part of the stage that is drawn with a scene of its own, such as a tile of the comparison. */
export interface Tile { element: HTMLElement; group: Group }

export class Stage {
  readonly renderer: WebGLRenderer | null;
  readonly scene = new Scene();
  readonly camera = new PerspectiveCamera(FIELD, 1, 0.1, 1000);
  readonly controls: CameraControls;
  readonly model = new Group();
  readonly grid = new Grid();
  readonly shadow: ContactShadow;
  /** Called before each frame. */
  beforeDraw: () => void = () => {};
  /** Called after each frame. */
  onDraw: () => void = () => {};
  /** Called when the camera has come to rest. */
  onRest: () => void = () => {};
  /** Points that must be seen, and their box, in the scene's coordinates. */
  content: () => Vec3[] = () => [];
  tiles: Tile[] | null = null;
  width = 1;
  height = 1;
  /** The field of view across the smaller side: that of a person, or nearly none. */
  private field = FIELD;
  /** Draws so far. */
  frames = 0;
  private dirty = true;
  private running = false;
  private last = 0;
  private sphere = new Sphere(new Vector3(), 5);
  private wasInside = true;
  /** Whether nobody has moved the camera since everything was shown. */
  private fitted = false;

  constructor(readonly canvas: HTMLCanvasElement, readonly insets: () => { top: number; right: number; bottom: number; left: number }) {
    this.renderer = makeRenderer(canvas);
    this.shadow = new ContactShadow();
    this.scene.add(this.model, this.grid.mesh, this.shadow.plane);
    const sun = new DirectionalLight(0xfff8ee, 1.8);
    sun.position.set(-3.4, 2.2, 0.6);
    this.scene.add(sun, studioLight());
    this.controls = new CameraControls(this.camera, canvas);
    Object.assign(this.controls, { smoothTime: 0.12, draggingSmoothTime: 0.05, minPolarAngle: 0.001, maxPolarAngle: Math.PI - 0.001, dollyToCursor: true, dollySpeed: PINCH_SPEED });
    const { ACTION } = CameraControls;
    Object.assign(this.controls.mouseButtons, { left: ACTION.ROTATE, right: ACTION.TRUCK, middle: ACTION.TRUCK, wheel: ACTION.NONE });
    for (const event of ['controlstart', 'control', 'transitionstart'] as const) this.controls.addEventListener(event, () => this.wake());
    this.controls.addEventListener('controlstart', () => {
      this.fitted = false;
      if ([ACTION.ROTATE, ACTION.TOUCH_ROTATE].some((action) => action === this.controls.currentAction)) this.leaveParallel();
    });
    this.controls.addEventListener('rest', () => this.onRest());
    canvas.addEventListener('wheel', (event) => this.onWheel(event), { passive: false });
    canvas.addEventListener('webglcontextlost', (event) => event.preventDefault());
    canvas.addEventListener('webglcontextrestored', () => this.invalidate());
    new ResizeObserver(() => this.resize()).observe(canvas);
    this.resize();
  }

  // ---- Drawing ----

  invalidate(): void {
    this.dirty = true;
    this.wake();
  }

  private wake(): void {
    if (this.running) return;
    this.running = true;
    this.last = performance.now();
    requestAnimationFrame((now) => this.tick(now));
  }

  private tick(now: number): void {
    const elapsed = Math.min(Math.max(now - this.last, 1) / 1000, 0.1);
    this.last = now;
    const moved = this.controls.update(elapsed);
    if (moved || this.dirty) this.draw();
    if (moved || this.dirty) requestAnimationFrame((next) => this.tick(next));
    else this.running = false;
  }

  draw(): void {
    this.dirty = false;
    this.frames += 1;
    const { renderer, camera } = this;
    const distance = camera.position.distanceTo(this.sphere.center);
    camera.near = Math.max(distance - 4 * this.sphere.radius, distance * 0.004);
    camera.far = distance + 40 * this.sphere.radius;
    camera.updateProjectionMatrix();
    camera.updateMatrixWorld();
    this.beforeDraw();
    if (renderer) {
      if (this.tiles) this.drawTiles(renderer, this.tiles);
      else {
        renderer.setScissorTest(false);
        renderer.setViewport(0, 0, this.width, this.height);
        renderer.render(this.scene, camera);
      }
    }
    this.onDraw();
  }

  private drawTiles(renderer: WebGLRenderer, tiles: Tile[]): void {
    const box = this.canvas.getBoundingClientRect();
    renderer.setScissorTest(false);
    renderer.clear();
    renderer.setScissorTest(true);
    const shown = [this.model, this.grid.mesh, this.shadow.plane].map((object) => [object, object.visible] as const);
    shown.forEach(([object]) => { object.visible = false; });
    for (const { element, group } of tiles) {
      const tile = element.getBoundingClientRect();
      const top = Math.max(tile.top, box.top), bottom = Math.min(tile.bottom, box.bottom);
      if (bottom <= top || tile.width < 1) continue;
      renderer.setViewport(tile.left - box.left, box.bottom - tile.bottom, tile.width, tile.height);
      renderer.setScissor(tile.left - box.left, box.bottom - bottom, tile.width, bottom - top);
      this.camera.aspect = tile.width / tile.height;
      this.camera.fov = verticalField(this.camera.aspect, this.field);
      this.camera.updateProjectionMatrix();
      this.scene.add(group);
      renderer.render(this.scene, this.camera);
      this.scene.remove(group);
    }
    shown.forEach(([object, visible]) => { object.visible = visible; });
    renderer.setScissorTest(false);
    this.shape();
  }

  /** A picture of the stage as it is, `scale` times as large. */
  async picture(scale: number, background: string | null): Promise<Blob> {
    const { renderer } = this;
    if (!renderer) throw new Error('there is no picture without WebGL 2');
    const ratio = renderer.getPixelRatio();
    renderer.setPixelRatio(scale);
    renderer.setSize(this.width, this.height, false);
    this.scene.background = background === null ? null : new Color(background);
    this.draw();
    const blob = await new Promise<Blob | null>((resolve) => { this.canvas.toBlob(resolve, 'image/png'); });
    this.scene.background = null;
    renderer.setPixelRatio(ratio);
    renderer.setSize(this.width, this.height, false);
    this.draw();
    if (!blob) throw new Error('the browser makes no picture of this size');
    return blob;
  }

  private resize(): void {
    const { clientWidth, clientHeight } = this.canvas;
    if (clientWidth === 0 || clientHeight === 0) return;
    this.width = clientWidth;
    this.height = clientHeight;
    if (this.renderer) {
      this.renderer.setPixelRatio(Math.min(window.devicePixelRatio || 1, MOST_PIXELS_PER_PIXEL));
      this.renderer.setSize(clientWidth, clientHeight, false);
    }
    this.shape();
    this.keepInside(false);
    this.draw();
  }

  /** What was seen whole stays seen whole, and as large as there is room for unless somebody has moved the camera. */
  keepInside(animated: boolean): void {
    if (this.fitted || (this.wasInside && !this.allInside())) this.fit(animated);
  }

  private shape(): void {
    this.camera.aspect = this.width / this.height;
    this.camera.fov = verticalField(this.camera.aspect, this.field);
    this.camera.updateProjectionMatrix();
  }

  /** After a change of the model: the box that clipping, grid and shadow go by. */
  measure(): void {
    const points = this.content();
    const box = new Box3();
    points.forEach((point) => box.expandByPoint(new Vector3(...point)));
    if (box.isEmpty()) box.set(new Vector3(-5, 0, -5), new Vector3(5, 0, 5));
    box.getBoundingSphere(this.sphere);
    if (this.sphere.radius === 0) this.sphere.radius = 1;
    this.grid.place(this.sphere.center, this.sphere.radius, box.min.y);
    if (this.renderer) this.shadow.update(this.renderer, this.scene, this.model, box, [this.grid.mesh]);
    this.invalidate();
  }

  /** Whether nothing moves and everything is drawn. */
  get isAtRest(): boolean { return !this.running; }
  get radius(): number { return this.sphere.radius; }
  get centre(): Vector3 { return this.sphere.center; }

  // ---- Camera ----

  /** Shows everything, from the direction that the camera has or from the one given, as large as the free part of the stage allows. */
  fit(animated: boolean, direction?: Vec3): void {
    const points = this.content();
    const from = direction ? new Vector3(...direction) : this.camera.position.clone().sub(this.controls.getTarget(new Vector3()));
    if (from.lengthSq() === 0) from.set(0.6, 0.55, 0.8);
    from.normalize();
    const side = new Vector3(0, 1, 0).cross(from);
    if (side.lengthSq() < 1e-9) side.set(1, 0, 0);
    side.normalize();
    const up = from.clone().cross(side);
    const seen = points.length > 0 ? points.map((point) => new Vector3(...point).sub(this.sphere.center)) : corners(this.sphere.radius);
    const { top, right, bottom, left } = this.insets();
    const tangent = Math.tan((verticalField(this.width / this.height, this.field) * Math.PI) / 360);
    // The free part of the picture, in the picture's own coordinates: half its height is `tangent`.
    const pixel = (2 * tangent) / this.height;
    const halfX = Math.max(this.width - left - right, this.width / 4) * pixel / 2;
    const halfY = Math.max(this.height - top - bottom, this.height / 4) * pixel / 2;
    const xs = seen.map((point) => point.dot(side)), ys = seen.map((point) => point.dot(up)), zs = seen.map((point) => point.dot(from));
    let distance = this.sphere.radius, centreX = 0, centreY = 0;
    // The nearest eye on the line through a centre from which every point is inside; the centre follows the picture's box.
    for (let round = 0; round < 6; round += 1) {
      distance = 0;
      for (let i = 0; i < seen.length; i += 1) {
        const reach = Math.max(Math.abs(xs[i]! - centreX) / halfX, Math.abs(ys[i]! - centreY) / halfY);
        distance = Math.max(distance, zs[i]! + reach, zs[i]! + 0.02 * this.sphere.radius);
      }
      let [lowX, highX, lowY, highY] = [Infinity, -Infinity, Infinity, -Infinity];
      for (let i = 0; i < seen.length; i += 1) {
        const depth = distance - zs[i]!;
        lowX = Math.min(lowX, (xs[i]! - centreX) / depth); highX = Math.max(highX, (xs[i]! - centreX) / depth);
        lowY = Math.min(lowY, (ys[i]! - centreY) / depth); highY = Math.max(highY, (ys[i]! - centreY) / depth);
      }
      centreX += ((lowX + highX) / 2) * distance;
      centreY += ((lowY + highY) / 2) * distance;
    }
    distance *= 1.02;
    const shiftX = ((right - left) / 2) * pixel * distance, shiftY = ((top - bottom) / 2) * pixel * distance;
    const target = this.sphere.center.clone().addScaledVector(side, centreX + shiftX).addScaledVector(up, centreY + shiftY);
    this.place({ eye: target.clone().addScaledVector(from, distance).toArray(), target: target.toArray() }, animated);
    this.fitted = this.wasInside = true;
  }

  /**
   * The camera; in a parallel view one with perspective that shows the whole depth of the model from the same
   * direction.
   */
  pose(): Pose {
    const target = this.controls.getTarget(new Vector3());
    const eye = this.controls.getPosition(new Vector3()).sub(target);
    if (this.isParallel) eye.setLength(eye.length() * nearness(this.field) + this.sphere.radius);
    eye.add(target);
    return { eye: eye.toArray(), target: target.toArray() };
  }

  /** Whether the view is a parallel projection. */
  get isParallel(): boolean { return this.field === PARALLEL; }

  private leaveParallel(): void {
    if (!this.isParallel) return;
    const pose = this.pose();
    this.field = FIELD;
    this.shape();
    this.place(pose, false);
  }

  place({ eye, target }: Pose, animated: boolean): void {
    this.fitted = false;
    const calm = !animated || matchMedia('(prefers-reduced-motion: reduce)').matches;
    void this.controls.setLookAt(...eye, ...target, !calm);
    if (calm) this.controls.update(0);
    this.invalidate();
  }

  /** Looks from a direction, without a change of the distance. */
  look(direction: Vec3): void {
    this.leaveParallel();
    this.fit(true, direction);
  }

  /** Shows everything from a direction at once, in perspective. */
  view(direction: Vec3): void {
    this.leaveParallel();
    this.fit(false, direction);
  }

  /** Looks along an axis, in parallel projection. */
  lookAlong(direction: Vec3): void {
    this.field = PARALLEL;
    this.shape();
    this.fit(false, direction);
  }

  orbit(azimuth: number, polar: number): void {
    this.fitted = false;
    this.leaveParallel();
    void this.controls.rotate(azimuth, polar, true);
    this.wake();
  }

  pan(x: number, y: number): void {
    this.fitted = false;
    const size = this.pixelAt(this.controls.getTarget(new Vector3()));
    void this.controls.truck(-x * size, -y * size, true);
    this.wake();
  }

  private onWheel(event: WheelEvent): void {
    event.preventDefault();
    const lines = event.deltaMode === 1 ? 16 : 1;
    const { x, y } = this.local(event);
    this.zoom(x, y, Math.exp(Math.max(-1, Math.min(1, event.deltaY * lines * 0.0016))));
  }

  /**
   * Scales eye and target about the point under the cursor, which therefore stays under it: on the surface, else on the plane
   * through the target.
   */
  zoom(x: number, y: number, factor: number): void {
    const target = this.controls.getTarget(new Vector3()), eye = this.controls.getPosition(new Vector3());
    const span = eye.distanceTo(target) * factor * nearness(this.field);
    if (span < this.sphere.radius * 1e-3 || span > this.sphere.radius * 60) return;
    const ray = this.ray(x, y);
    const hit = this.under(x, y);
    let fixed: Vector3;
    if (hit) fixed = hit;
    else {
      const forward = target.clone().sub(eye).normalize();
      const along = ray.direction.dot(forward);
      fixed = ray.origin.clone().addScaledVector(ray.direction, target.clone().sub(ray.origin).dot(forward) / along);
    }
    eye.sub(fixed).multiplyScalar(factor).add(fixed);
    target.sub(fixed).multiplyScalar(factor).add(fixed);
    this.place({ eye: eye.toArray(), target: target.toArray() }, false);
    this.onRest();
  }

  /** What lies on the surface under a pixel; set by whoever owns the surface. */
  under: (x: number, y: number) => Vector3 | null = () => null;

  // ---- Between pixels and the scene ----

  local(event: MouseEvent): { x: number; y: number } {
    const box = this.canvas.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  }

  project(point: Vec3): { x: number; y: number; visible: boolean } {
    const seen = new Vector3(...point).project(this.camera);
    return { x: ((seen.x + 1) / 2) * this.width, y: ((1 - seen.y) / 2) * this.height, visible: seen.z < 1 };
  }

  ray(x: number, y: number): { origin: Vector3; direction: Vector3 } {
    const raycaster = new Raycaster();
    raycaster.setFromCamera(new Vector2((x / this.width) * 2 - 1, 1 - (y / this.height) * 2), this.camera);
    return raycaster.ray;
  }

  /** The size of a pixel at a point. */
  pixelAt(point: Vector3): number {
    const forward = this.camera.getWorldDirection(new Vector3());
    const depth = point.clone().sub(this.camera.position).dot(forward);
    return (2 * Math.max(depth, 1e-9) * Math.tan((this.camera.fov * Math.PI) / 360)) / this.height;
  }

  /** Where the ray through a pixel meets a plane; null if it does not, or far away. */
  onPlane(x: number, y: number, point: Vector3, normal: Vector3): Vector3 | null {
    const { origin, direction } = this.ray(x, y);
    const along = direction.dot(normal);
    if (Math.abs(along) < 1e-6) return null;
    const reach = point.clone().sub(origin).dot(normal) / along;
    if (reach <= 0 || reach > 60 * this.sphere.radius + origin.distanceTo(point)) return null;
    return origin.clone().addScaledVector(direction, reach);
  }

  private allInside(): boolean {
    return this.content().every((point) => {
      const { x, y, visible } = this.project(point);
      return visible && x >= 0 && y >= 0 && x <= this.width && y <= this.height;
    });
  }

  /** To be called when the camera rests or the model changes: whether a smaller stage must show everything still. */
  rememberWhetherAllIsSeen(): void {
    this.camera.updateMatrixWorld();
    this.wasInside = this.allInside();
  }
}

const verticalField = (aspect: number, field: number): number =>
  (aspect >= 1 ? field : (Math.atan(Math.tan((field * Math.PI) / 360) / aspect) * 360) / Math.PI);

/** How much nearer the eye of a person's field of view stands to see as much as one of this field. */
const nearness = (field: number): number => Math.tan((field * Math.PI) / 360) / Math.tan((FIELD * Math.PI) / 360);

const corners = (r: number): Vector3[] => [-1, 1].flatMap((x) => [-1, 1].map((z) => new Vector3(x * r * 0.7, 0, z * r * 0.7)));

function makeRenderer(canvas: HTMLCanvasElement): WebGLRenderer | null {
  // three.js logs an error where there is no WebGL 2; the page says it in its own words.
  const context = canvas.getContext('webgl2', { antialias: true, alpha: true, powerPreference: 'high-performance' });
  if (!context) return null;
  const renderer = new WebGLRenderer({ canvas, context, antialias: true, alpha: true });
  renderer.setClearColor(0x000000, 0);
  renderer.toneMapping = NeutralToneMapping;
  renderer.toneMappingExposure = 1;
  renderer.debug.checkShaderErrors = false;
  return renderer;
}

export function dispose(object: Object3D): void {
  object.traverse((each) => {
    const { geometry } = each as unknown as { geometry?: { dispose(): void } };
    geometry?.dispose();
  });
}
