// The drawing on the stage: its lines and points, what is being drawn, and the marks of snapping and lifting. Points are one
// draw call, whatever their number; the graphics card hides those behind the surface.

import { BufferAttribute, BufferGeometry, Color, Group, Points, ShaderMaterial } from 'three';
import type { Frame } from '../model/frame';
import { coordinates, isLoose, isShown, type Line, type Vec3 } from '../model/request';
import { dashedLines, type Lines, retire, wideLines } from './surface';

export interface PointRef { line: number; point: number }
export const same = (a: PointRef | null, b: PointRef | null): boolean => a?.line === b?.line && a?.point === b?.point;

const VERTEX = `
attribute float state;
uniform float scale, size, near;
varying float kind;
void main() {
  kind = state;
  vec4 at = modelViewMatrix * vec4(position, 1.0);
  float pixel = near * -at.z;
  // A point on the surface is not to be cut in half by it: it is moved towards the eye by its own size.
  at.xyz -= normalize(at.xyz) * min(pixel * 10.0, 0.05 * -at.z);
  gl_Position = projectionMatrix * at;
  float grow = state > 0.5 ? 1.35 : 1.0;
  gl_PointSize = size * scale * grow + 2.0 * scale;
}`;

// States: 0 plain, 1 under the pointer, 2 selected, 3 faulty, 4 being drawn, 5 a place to insert.
const FRAGMENT = `
varying float kind; uniform vec3 paper, accent, ink, fault; uniform float scale, size;
void main() {
  float grow = kind > 0.5 ? 1.35 : 1.0;
  float whole = size * scale * grow + 2.0 * scale;
  float r = length(gl_PointCoord - 0.5) * whole;
  float rim = whole / 2.0 - scale;
  float alpha = 1.0 - smoothstep(rim - 0.5, rim + 0.5, r);
  if (alpha < 0.02) discard;
  vec3 fill = kind < 0.5 ? paper : kind < 1.5 ? accent : kind < 2.5 ? accent : kind < 3.5 ? fault : kind < 4.5 ? accent : paper;
  vec3 edge = kind < 1.5 ? accent : kind < 2.5 ? paper : kind < 3.5 ? paper : accent;
  float border = smoothstep(rim - 1.9 * scale, rim - 1.1 * scale, r);
  gl_FragColor = vec4(mix(fill, edge, border), alpha * (kind > 4.5 ? 0.75 : 1.0));
  #include <colorspace_fragment>
}`;

export interface SketchLook { paper: string; accent: string; ink: string; fault: string; soft: string; cable: string }

/** Shows what is not behind the surface dimly through it. */
export class Sketch {
  readonly group = new Group();
  /** Where the points lie on the stage, and which they are. */
  places: Vec3[] = [];
  refs: PointRef[] = [];
  private points: Points<BufferGeometry, ShaderMaterial> | null = null;
  private lines: Lines | null = null;
  private cables: Lines[] = [];
  private extra = new Group();
  private material: ShaderMaterial;

  constructor(private look: SketchLook) {
    const value = (hex: string): { value: Color } => ({ value: new Color(hex) });
    this.material = new ShaderMaterial({
      vertexShader: VERTEX, fragmentShader: FRAGMENT, transparent: true,
      uniforms: { scale: { value: 1 }, size: { value: 11 }, near: { value: 0.001 }, paper: value(look.paper), accent: value(look.accent), ink: value(look.ink), fault: value(look.fault) },
    });
    this.group.add(this.extra);
  }

  restyle(look: SketchLook): void {
    this.look = look;
    for (const name of ['paper', 'accent', 'ink', 'fault'] as const) (this.material.uniforms[name]!.value as Color).set(look[name]);
  }

  /** The projection's size of a pixel at distance 1, and the screen's pixels per pixel. */
  setPixel(near: number, scale: number): void {
    this.material.uniforms.near!.value = near;
    this.material.uniforms.scale!.value = scale;
  }

  /**
   * `cables`: the courses of cables along the lines, the segments that they run along as `line/point`, and the number
   * of the chosen one.
   */
  show(lines: Line[], draft: Vec3[] | null, frame: Frame, cables: { courses: Vec3[][]; segments: Set<string>; chosen: number } = { courses: [], segments: new Set(), chosen: -1 }): void {
    const places: Vec3[] = [], refs: PointRef[] = [];
    const segments: number[] = [];
    lines.forEach((line, l) => {
      const own = line.points.map(coordinates);
      const seen = own.map((point) => (point ? frame.toScene(point) : null));
      seen.forEach((at, p) => {
        if (!isShown(line, p)) return;
        // What is no point at all stands between its neighbours, so that it can be seen and mended.
        const stand = at ?? middle(seen[(p + seen.length - 1) % seen.length] ?? null, seen[(p + 1) % seen.length] ?? null);
        if (!stand) return;
        places.push(stand);
        refs.push({ line: l, point: p });
      });
      if (isLoose(line)) return;
      const chain = seen.flatMap((at, p) => (at ? [{ at, p }] : []));
      const last = line.closed && chain.length > 2 ? chain.length : chain.length - 1;
      for (let i = 0; i < last; i += 1) if (!cables.segments.has(`${l}/${chain[i]!.p}`)) segments.push(...chain[i]!.at, ...chain[(i + 1) % chain.length]!.at);
    });
    draft?.forEach((point, p) => {
      places.push(frame.toScene(point));
      refs.push({ line: -1, point: p });
      if (p > 0) segments.push(...frame.toScene(draft[p - 1]!), ...frame.toScene(point));
    });
    this.places = places;
    this.refs = refs;
    this.setLines(new Float32Array(segments));
    this.setCables(cables.courses.map((course) => course.map((point) => frame.toScene(point))), cables.chosen);
    this.setPoints();
  }

  private setLines(segments: Float32Array): void {
    if (this.lines) {
      retire(this.lines);
      this.group.remove(this.lines);
    }
    this.lines = segments.length > 0 ? wideLines(segments, 2.4, this.look.accent) : null;
    if (this.lines) {
      this.lines.renderOrder = 1;
      this.group.add(this.lines);
    }
  }

  private setCables(courses: Vec3[][], chosen: number): void {
    for (const line of this.cables) {
      retire(line);
      this.group.remove(line);
    }
    const chain = (course: Vec3[]): number[] => course.slice(1).flatMap((point, i) => [...course[i]!, ...point]);
    const add = (segments: number[], width: number, color: string): Lines[] => (segments.length > 0 ? [wideLines(new Float32Array(segments), width, color)] : []);
    // Dashes where cables are given: the result draws each as the curve that it is.
    const straight = courses.flatMap((course, k) => (k === chosen ? [] : chain(course)));
    const size = Math.max(1e-9, ...courses.filter((course) => course.length > 1).map((course) => Math.hypot(...course[0]!.map((value, axis) => value - course.at(-1)![axis]!))));
    this.cables = [
      ...(straight.length > 0 ? [dashedLines(new Float32Array(straight), 1.6, this.look.cable, size / 40)] : []),
      ...add(chain(courses[chosen] ?? []), 6, this.look.cable),
    ];
    for (const line of this.cables) {
      // The line of the boundary runs along their middle.
      line.renderOrder = 0.9;
      line.material.depthWrite = false;
      this.group.add(line);
    }
  }

  private setPoints(): void {
    const count = this.places.length;
    if (!this.points || this.points.geometry.attributes.position!.count !== count) {
      if (this.points) {
        this.points.geometry.dispose();
        this.group.remove(this.points);
      }
      const geometry = new BufferGeometry();
      geometry.setAttribute('position', new BufferAttribute(new Float32Array(3 * count), 3));
      geometry.setAttribute('state', new BufferAttribute(new Float32Array(count), 1));
      this.points = new Points(geometry, this.material);
      this.points.frustumCulled = false;
      this.points.renderOrder = 2;
      this.group.add(this.points);
    }
    const { position } = this.points.geometry.attributes;
    this.places.forEach((place, i) => position!.setXYZ(i, ...place));
    position!.needsUpdate = true;
    this.material.uniforms.size!.value = count > 300 ? 5 : count > 120 ? 7 : 11;
  }

  /** How each point looks. */
  mark(stateOf: (ref: PointRef) => number): void {
    const state = this.points?.geometry.attributes.state;
    if (!state) return;
    this.refs.forEach((ref, i) => state.setX(i, stateOf(ref)));
    state.needsUpdate = true;
  }

  /** Lines and points of the moment: the rubber band, the place to insert, the arrow and the drop line of a lift. */
  hint(parts: { segments?: Vec3[]; faint?: Vec3[]; lift?: Vec3[]; ghost?: Vec3 | null }): void {
    for (const child of this.extra.children as (Lines | Points<BufferGeometry, ShaderMaterial>)[]) {
      if (child.material === this.material) child.geometry.dispose();
      else retire(child);
    }
    this.extra.clear();
    const add = (points: Vec3[] | undefined, color: string, opacity: number, width = 1.6): void => {
      if (!points || points.length < 2) return;
      const lines = wideLines(new Float32Array(points.flat()), width, color, undefined, opacity);
      lines.renderOrder = 1 + 0.01 * this.extra.children.length;
      if (width > 2) Object.assign(lines.material, { depthTest: false, depthWrite: false, transparent: true });
      this.extra.add(lines);
    };
    add(parts.segments, this.look.accent, 0.95);
    add(parts.faint, this.look.soft, 0.8);
    // The arrow is seen on the film, the ground and the boundary alike.
    add(parts.lift, this.look.paper, 1, 8);
    add(parts.lift, this.look.cable, 1, 4.5);
    if (parts.ghost) {
      const geometry = new BufferGeometry();
      geometry.setAttribute('position', new BufferAttribute(new Float32Array(parts.ghost), 3));
      geometry.setAttribute('state', new BufferAttribute(new Float32Array([5]), 1));
      const ghost = new Points(geometry, this.material);
      ghost.renderOrder = 3;
      this.extra.add(ghost);
    }
  }
}

function middle(a: Vec3 | null, b: Vec3 | null): Vec3 | null {
  if (!a || !b) return a ?? b;
  return [0, 1, 2].map((axis) => (a[axis]! + b[axis]!) / 2) as Vec3;
}
