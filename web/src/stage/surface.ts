// The result on the stage: the surface, its lines, and the colours of the quantity that is looked at.

import {
  BufferAttribute, BufferGeometry, Color, DoubleSide, Group, LineBasicMaterial, LineSegments, type Material, Mesh, MeshLambertMaterial, MeshStandardMaterial, Raycaster, Vector2, Vector3,
} from 'three';
import { LineMaterial } from 'three/examples/jsm/lines/LineMaterial.js';
import { LineSegments2 } from 'three/examples/jsm/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/examples/jsm/lines/LineSegmentsGeometry.js';
import type { MeshBVH } from 'three-mesh-bvh';
import type { Frame } from '../model/frame';
import type { Vec3 } from '../model/request';
import { colour } from './colours';
import { edgesOf, hasSurface, type ResultMesh } from './mesh';
import { fraction, type Quantity, reading } from './quantities';
import { number } from '../text';
import type { Stage } from './stage';

/** Pixels within which a click reads a line's value. */
const LINE_GRIP = 8;
/** The head of a reaction's arrow, as fractions of the longest arrow. */
const HEAD = { length: 0.16, width: 0.06 };
/** Most reactions whose arrows are labelled. */
const MOST_TAGS = 16;
/** More segments than this are drawn one pixel wide. */
const MOST_WIDE = 20_000;

export interface Look { membrane: string; ink: string; accent: string; reaction: string; rim: string }

/** The search trees, which come after the first film. Until then every triangle is looked at. */
let trees: typeof import('./trees') | null = null;
export const useTrees = (library: NonNullable<typeof trees>): void => { trees = library; };

type WithTree = BufferGeometry & { boundsTree?: MeshBVH };

export type Lines = LineSegments2 | LineSegments<BufferGeometry, LineBasicMaterial>;

/**
 * Lights the side of a smooth surface that is seen. At a silhouette there are slivers of triangles that are seen from
 * behind, and they would be dark dots on a bright surface. The last two pixels before a silhouette of the back are left
 * out for that reason.
 */
const towardsEye = (shader: { fragmentShader: string }): void => {
  shader.fragmentShader = shader.fragmentShader.replace('#include <normal_fragment_begin>', `
    vec3 normal = normalize(vNormal);
    float facing = dot(normal, isOrthographic ? vec3(0.0, 0.0, 1.0) : normalize(vViewPosition));
    float rim = -2.0 * fwidth(facing);
    if (!gl_FrontFacing && facing < 0.0) {
      if (facing > rim) discard;
      normal = -normal;
    }
    vec3 nonPerturbedNormal = normal;`);
};

/**
 * Moves a line towards the eye, so that the film that it bounds covers neither half of it. At 0 the film covers one
 * half, and at 1500 the line covers the drawing's points.
 */
const BEFORE = { polygonOffset: true, polygonOffsetFactor: 0, polygonOffsetUnits: -400 };

/** Thin dashes of a length on the screen that does not depend on the zoom by much: `dash` is in metres. */
export function dashedLines(segments: Float32Array, width: number, color: string, dash: number): LineSegments2 {
  const geometry = new LineSegmentsGeometry().setPositions(segments);
  const material = new LineMaterial({ color: new Color(color).getHex(), linewidth: width, dashed: true, dashSize: dash, gapSize: dash, toneMapped: false, ...BEFORE });
  const lines = new LineSegments2(geometry, material);
  lines.computeLineDistances();
  return lines;
}

/** Wide lines in one colour, or in a colour for each end. */
export function wideLines(segments: Float32Array, width: number, color: string, colours?: Float32Array, opacity = 1): Lines {
  if (segments.length / 6 > MOST_WIDE) {
    const geometry = new BufferGeometry().setAttribute('position', new BufferAttribute(segments, 3));
    if (colours) geometry.setAttribute('color', new BufferAttribute(colours, 3));
    const material = new LineBasicMaterial({ color: colours ? '#ffffff' : color, vertexColors: Boolean(colours), transparent: opacity < 1, opacity, toneMapped: false });
    return new LineSegments(geometry, material);
  }
  const geometry = new LineSegmentsGeometry().setPositions(segments);
  if (colours) geometry.setColors(colours);
  const material = new LineMaterial({ color: colours ? 0xffffff : new Color(color).getHex(), linewidth: width, vertexColors: Boolean(colours), transparent: opacity < 1, opacity, toneMapped: false, ...BEFORE });
  return new LineSegments2(geometry, material);
}

/** By then the successor of what was retired has been drawn. */
const RETIREMENT_MS = 2000;

/**
 * Gives back what an object holds. Its material lives a little longer: the shader program of a kind of material is
 * thrown away with the last material that uses it, and to compile it anew for each film of a live drag takes longer
 * than the solver.
 */
export function retire({ geometry, material }: { geometry: BufferGeometry; material: Material }): void {
  geometry.dispose();
  setTimeout(() => material.dispose(), RETIREMENT_MS);
}

export class Surface {
  readonly group = new Group();
  private mesh: Mesh<BufferGeometry, MeshStandardMaterial | MeshLambertMaterial> | null = null;
  private result: ResultMesh | null = null;
  private kind = '';
  private quantity: Quantity | null = null;
  private lines: Lines[] = [];
  layers = { surface: true, edges: false, lines: true, reactions: false };
  /** Whether the drawing shows the boundaries already. */
  drawn = true;
  private ghost = false;

  constructor(private readonly look: Look) {}

  get shown(): boolean { return this.mesh !== null; }
  get current(): ResultMesh | null { return this.result; }

  /** `frame` is where the request's own coordinates lie on the stage; the mesh is put into it in f64. */
  show(result: ResultMesh | null, kind: string, frame: Frame, quantity: Quantity | null = null): void {
    this.result = result;
    this.kind = kind;
    this.quantity = quantity;
    this.ghost = false;
    if (result) this.putInto(frame);
    this.make();
  }

  putInto(frame: Frame): void {
    if (!this.result) return;
    const origin = frame.up === 2 ? [frame.origin[0], frame.origin[2], -frame.origin[1]] : frame.origin;
    const [x, y, z] = this.result.translation.map((value, axis) => value - origin[axis]! * frame.metres) as Vec3;
    this.group.position.set(x, y, z);
  }

  colourBy(quantity: Quantity | null): void {
    this.quantity = quantity;
    this.make();
  }

  setLayers(layers: Partial<typeof this.layers>): void {
    Object.assign(this.layers, layers);
    this.make();
  }

  /** A ghost is a result that no longer belongs to the drawing, or that is not to hide it. */
  setGhost(ghost: boolean): void {
    if (ghost === this.ghost) return;
    this.ghost = ghost;
    if (!this.mesh) return;
    this.mesh.material.transparent = ghost;
    this.mesh.material.opacity = ghost ? 0.32 : 1;
    this.mesh.material.depthWrite = !ghost;
    this.mesh.material.needsUpdate = true;
    for (const line of this.lines) {
      line.material.transparent = true;
      line.material.opacity = ghost ? 0.2 : ((line.userData.opacity as number | undefined) ?? 1);
    }
  }

  restyle(): void {
    this.make();
  }

  private clear(): void {
    if (this.mesh) retire(this.mesh);
    this.mesh = null;
    this.lines.forEach(retire);
    this.lines = [];
    this.group.clear();
  }

  private make(): void {
    const { result, quantity, ghost } = this;
    this.clear();
    if (!result) return;
    // Films and fabrics are smooth; strips and lattices have flat pieces.
    const facets = this.kind === 'ruled_surface' || this.kind === 'uniform_mesh';
    const geometry = new BufferGeometry();
    geometry.setIndex(result.geometry.index);
    geometry.setAttribute('position', result.geometry.attributes.position!);
    geometry.setAttribute('normal', result.geometry.attributes.normal!);
    const coloured = quantity?.at === 'vertex';
    if (quantity && coloured) geometry.setAttribute('color', new BufferAttribute(vertexColours(quantity), 3));
    const common = { side: DoubleSide, flatShading: facets, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 };
    // Values are read from colours: a highlight would change them.
    const material = coloured
      ? new MeshLambertMaterial({ ...common, vertexColors: true })
      : new MeshStandardMaterial({ ...common, color: this.look.membrane, roughness: 0.62, metalness: 0 });
    if (!facets) material.onBeforeCompile = towardsEye;
    this.mesh = new Mesh(geometry, material);
    this.mesh.userData.castsShadow = true;
    this.mesh.visible = this.layers.surface;
    this.group.add(this.mesh);

    const add = (segments: Float32Array, width: number, color: string, opacity = 1, colours?: Float32Array): void => {
      if (segments.length === 0) return;
      const line = wideLines(segments, width, color, colours, opacity);
      line.userData.opacity = opacity;
      line.userData.isLine = true;
      line.renderOrder = 0.01 * this.lines.length;
      this.lines.push(line);
      this.group.add(line);
    };
    const along = quantity?.at === 'segment' ? quantity : null;
    // The ends of the scale are nearly as dark or as bright as the ground: a rim sets the cables off from it.
    if (along?.id.startsWith('line:')) {
      add(along.segments!, 5, this.look.rim);
      const rim = this.lines.at(-1);
      // Only its colour is left behind: what is drawn at the same place afterwards lies on it.
      if (rim) Object.assign(rim.material, { depthWrite: false });
    }
    if (along) add(along.segments!, 3, this.look.ink, 1, segmentColours(along));
    if (this.layers.edges && along?.id !== 'edge_length') add(edgeSegments(result), 1, this.look.ink, 0.3);
    if (this.layers.lines) {
      for (const { name, segments, values } of result.lines) {
        if (name === 'reactions' || (along && (name.startsWith('members') || name === 'bridges'))) continue;
        // These are drawn in their colours already.
        if (values.some((each) => along?.id === `line:${each.name}`)) continue;
        if (['boundaries', 'directrices', 'held edges'].includes(name)) { if (!this.drawn) add(segments, 2, this.look.ink, 0.85); }
        else if (name.startsWith('members')) add(segments, name.includes('rim') ? 1.4 : 2, this.look.ink, name.includes('rim') ? 0.5 : 0.8);
        else if (name === 'bridges') add(segments, 1, this.look.ink, 0.35);
        else add(segments, 2.4, this.look.accent);
      }
    }
    if (this.layers.reactions) add(arrows(result), 2.2, this.look.reaction);
    if (ghost) {
      this.ghost = false;
      this.setGhost(true);
    }
  }

  /** The tips of the arrows of the largest reactions, largest first, with what each says. */
  reactions(): { tip: Vec3; text: string }[] {
    const line = this.layers.reactions ? this.result?.lines.find(({ name }) => name === 'reactions') : undefined;
    const force = line?.values.find(({ name }) => name === 'force');
    if (!line || !force) return [];
    const { x, y, z } = this.group.position;
    const sizes = Array.from({ length: line.segments.length / 6 }, (_, i) => ({ i, size: force.values[2 * i]! })).sort((a, b) => b.size - a.size).slice(0, MOST_TAGS);
    return sizes.map(({ i, size }) => ({ tip: [line.segments[6 * i + 3]! + x, line.segments[6 * i + 4]! + y, line.segments[6 * i + 5]! + z], text: `${number(size, 3)} ${force.unit}` }));
  }

  /** The nearest point of the surface under a pixel. */
  pick(stage: Stage, x: number, y: number): { point: Vector3; distance: number; face: number } | null {
    if (!this.mesh || !this.layers.surface || !this.result || !hasSurface(this.result)) return null;
    const raycaster = new Raycaster();
    raycaster.setFromCamera(new Vector2((x / stage.width) * 2 - 1, 1 - (y / stage.height) * 2), stage.camera);
    this.group.updateMatrixWorld();
    const { geometry, matrixWorld } = this.mesh as Mesh<WithTree>;
    if (!trees) {
      const [hit] = raycaster.intersectObject(this.mesh, false);
      return hit ? { point: hit.point, distance: hit.distance, face: hit.faceIndex ?? 0 } : null;
    }
    geometry.boundsTree ??= new trees.MeshBVH(geometry, { indirect: true });
    const hit = geometry.boundsTree.raycastFirst(raycaster.ray.clone().applyMatrix4(matrixWorld.clone().invert()), DoubleSide);
    const point = hit?.point.applyMatrix4(matrixWorld);
    return point ? { point, distance: point.distanceTo(raycaster.ray.origin), face: hit!.faceIndex ?? 0 } : null;
  }

  /** The point of a coloured line or of a reaction's arrow that is nearest to a pixel, within a few pixels of it. */
  pickLine(stage: Stage, x: number, y: number): { point: Vector3; value: string } | null {
    const { quantity, result } = this;
    const found: { distance: number; point: Vector3; value: string }[] = [];
    const search = (segments: Float32Array, reading: (index: number) => string): void => {
      for (let i = 0; i < segments.length / 6; i += 1) {
        const [a, b] = [0, 3].map((end) => this.group.localToWorld(new Vector3().fromArray(segments, 6 * i + end))) as [Vector3, Vector3];
        const p = stage.project(a.toArray()), q = stage.project(b.toArray());
        if (!p.visible || !q.visible) continue;
        const length = (q.x - p.x) ** 2 + (q.y - p.y) ** 2;
        const t = length > 0 ? Math.min(1, Math.max(0, ((x - p.x) * (q.x - p.x) + (y - p.y) * (q.y - p.y)) / length)) : 0;
        const distance = Math.hypot(p.x + t * (q.x - p.x) - x, p.y + t * (q.y - p.y) - y);
        if (distance <= LINE_GRIP) found.push({ distance, point: a.lerp(b, t), value: reading(i) });
      }
    };
    this.group.updateMatrixWorld();
    if (quantity?.at === 'segment') search(quantity.segments!, (i) => reading(quantity, quantity.values[i]!));
    const reactions = this.layers.reactions ? result?.lines.find(({ name }) => name === 'reactions') : undefined;
    const force = reactions?.values.find(({ name }) => name === 'force');
    if (reactions && force) search(reactions.segments, (i) => `Reaction ${number(force.values[2 * i]!, 4)} ${force.unit}`);
    return found.sort((a, b) => a.distance - b.distance)[0] ?? null;
  }

  /** The value of the quantity that is shown, at a point that `pick` found. */
  valueAt(point: Vector3, face: number): number | null {
    const { quantity, mesh } = this;
    if (!quantity || !mesh) return null;
    const local = mesh.worldToLocal(point.clone());
    if (quantity.at === 'segment') return nearestSegment(quantity, local);
    const index = mesh.geometry.index!.array;
    const { position } = mesh.geometry.attributes;
    const corner = [0, 1, 2].map((k) => index[3 * face + k]!);
    const [a, b, c] = corner.map((i) => new Vector3().fromBufferAttribute(position!, i)) as [Vector3, Vector3, Vector3];
    const area = (p: Vector3, q: Vector3, r: Vector3): number => q.clone().sub(p).cross(r.clone().sub(p)).length();
    const weights = [area(local, b, c), area(a, local, c), area(a, b, local)];
    const sum = weights.reduce((x, y) => x + y, 0);
    return sum > 0 ? corner.reduce((value, i, k) => value + (weights[k]! / sum) * quantity.values[i]!, 0) : quantity.values[corner[0]!]!;
  }

  /** Points that show how far the surface reaches, in the scene's coordinates: enough for a camera, not all of them. */
  outline(): Vec3[] {
    const position = this.result?.geometry.attributes.position;
    if (!position) return [];
    const step = Math.max(1, Math.floor(position.count / 3000));
    const { x, y, z } = this.group.position;
    const points: Vec3[] = [];
    for (let i = 0; i < position.count; i += step) points.push([position.getX(i) + x, position.getY(i) + y, position.getZ(i) + z]);
    const box = this.result!.geometry.boundingBox ?? (this.result!.geometry.computeBoundingBox(), this.result!.geometry.boundingBox!);
    // The box's extremes, one vertex each, may fall between the steps.
    for (let i = 0; i < position.count; i += 1) {
      const at: Vec3 = [position.getX(i), position.getY(i), position.getZ(i)];
      if (at.some((value, axis) => value === box.min.getComponent(axis) || value === box.max.getComponent(axis))) points.push([at[0] + x, at[1] + y, at[2] + z]);
      if (points.length > 4000) break;
    }
    return points;
  }
}

/**
 * The reactions as arrows: each line with two barbs in each of two planes, so that the head is seen from everywhere.
 */
function arrows(result: ResultMesh): Float32Array {
  const { segments } = result.lines.find(({ name }) => name === 'reactions') ?? { segments: new Float32Array() };
  const a = new Vector3(), b = new Vector3();
  let longest = 0;
  for (let i = 0; i < segments.length; i += 6) longest = Math.max(longest, a.fromArray(segments, i).distanceTo(b.fromArray(segments, i + 3)));
  const out: number[] = [];
  for (let i = 0; i < segments.length; i += 6) {
    a.fromArray(segments, i);
    b.fromArray(segments, i + 3);
    const along = b.clone().sub(a);
    const length = along.length();
    if (!(length > 1e-6 * longest)) continue;
    along.divideScalar(length);
    const across = new Vector3(Math.abs(along.x) < 0.8 ? 1 : 0, Math.abs(along.x) < 0.8 ? 0 : 1, 0).cross(along).normalize();
    const size = Math.min(longest * HEAD.length, length);
    const base = b.clone().addScaledVector(along, -size);
    out.push(...a.toArray(), ...b.toArray());
    for (const side of [across, across.clone().cross(along)]) {
      for (const sign of [-1, 1]) out.push(...base.clone().addScaledVector(side, (sign * size * HEAD.width) / HEAD.length).toArray(), ...b.toArray());
    }
  }
  return new Float32Array(out);
}

function vertexColours(q: Quantity): Float32Array {
  const out = new Float32Array(3 * q.values.length);
  q.values.forEach((value, i) => out.set(colour(q.scale, fraction(q, value)), 3 * i));
  return out;
}

function segmentColours(q: Quantity): Float32Array {
  const out = new Float32Array(6 * q.values.length);
  q.values.forEach((value, i) => {
    const rgb = colour(q.scale, fraction(q, value));
    out.set(rgb, 6 * i);
    out.set(rgb, 6 * i + 3);
  });
  return out;
}

const edgeCache = new WeakMap<ResultMesh, Float32Array>();

export function edgeSegments(result: ResultMesh): Float32Array {
  const known = edgeCache.get(result);
  if (known) return known;
  const position = result.geometry.attributes.position!.array as Float32Array;
  const { ends } = edgesOf(result.geometry);
  const segments = new Float32Array(3 * ends.length);
  ends.forEach((vertex, i) => segments.set(position.subarray(3 * vertex, 3 * vertex + 3), 3 * i));
  edgeCache.set(result, segments);
  return segments;
}

function nearestSegment({ segments, values }: Quantity, point: Vector3): number | null {
  let best = Infinity, found: number | null = null;
  const a = new Vector3(), along = new Vector3(), to = new Vector3();
  for (let i = 0; i < values.length; i += 1) {
    a.fromArray(segments!, 6 * i);
    along.fromArray(segments!, 6 * i + 3).sub(a);
    to.copy(point).sub(a);
    const t = Math.min(1, Math.max(0, to.dot(along) / along.lengthSq()));
    const distance = to.addScaledVector(along, -t).lengthSq();
    if (distance < best) [best, found] = [distance, values[i]!];
  }
  return found;
}
