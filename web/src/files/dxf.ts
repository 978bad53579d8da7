// DXF: lines, polylines with their bulges, arcs, circles, ellipses and splines of the model space, with blocks in
// their places, by dxf-parser. `$INSUNITS` of the header is the unit.

import DxfParser from 'dxf-parser';
import { Vector4 } from 'three';
import { calcBSplinePoint } from 'three/examples/jsm/curves/NURBSUtils.js';
import type { Vec3 } from '../model/request';
import { curve } from '../model/shapes';
import { type Drawing, FileFault, joined, type Polyline, polyline, quote } from './lines';
import type { Length } from './units';

interface Vertex { x: number; y: number; z?: number; bulge?: number }
interface Entity {
  type: string; handle?: string | number; layer?: string; inPaperSpace?: boolean; visible?: boolean;
  vertices?: Vertex[]; shape?: boolean; elevation?: number; isPolyfaceMesh?: boolean; is3dPolygonMesh?: boolean;
  center?: Vertex; radius?: number; startAngle?: number; endAngle?: number; majorAxisEndPoint?: Vertex; axisRatio?: number;
  fitPoints?: Vertex[]; controlPoints?: Vertex[]; knotValues?: number[]; degreeOfSplineCurve?: number; closed?: boolean;
  extrusionDirection?: Vertex; extrusionDirectionX?: number; extrusionDirectionY?: number; extrusionDirectionZ?: number;
  name?: string; position?: Vertex; xScale?: number; yScale?: number; zScale?: number; rotation?: number;
  columnCount?: number; rowCount?: number; columnSpacing?: number; rowSpacing?: number;
}
interface Parsed { header?: Record<string, unknown>; entities?: Entity[]; blocks?: Record<string, { position?: Vertex; entities?: Entity[] }> }

/** Segments of a full circle. */
const ROUND = 48;
/** Segments of a spline between two of its knots. */
const PER_SPAN = 8;
/** Deepest nesting of blocks. A block that contains itself ends here. */
const DEEPEST = 16;
/** `$INSUNITS` of the header. 0 stands for no unit. */
const UNITS: Record<number, Length> = { 1: 'in', 2: 'ft', 3: 'mi', 4: 'mm', 5: 'cm', 6: 'm', 7: 'km', 10: 'yd', 14: 'dm', 21: 'US survey ft' };
/** Entities that are no lines and are left out without a word. */
const SILENT = ['VIEWPORT', 'ATTDEF', 'ATTRIB', 'SEQEND'];

/** Collects what the entities of a file give. The lines and arcs of each layer are joined at the end. */
interface Found { loose: Map<string, Vec3[][]>; lines: Polyline[]; left: Map<string, number>; weights: Map<string, number[]> }
type Place = (point: Vec3) => Vec3;

export function readDxf(source: string): Drawing {
  if (source.startsWith('AutoCAD Binary DXF')) throw new FileFault('This is binary DXF. Save the drawing as ASCII DXF.');
  const { text, weights } = prepare(source);
  let parsed: Parsed;
  try {
    parsed = (new DxfParser().parseSync(text) ?? {}) as unknown as Parsed;
  } catch (error) {
    throw new FileFault(`This is not DXF that can be read: ${error instanceof Error ? error.message : String(error)}.`);
  }
  const found: Found = { loose: new Map(), lines: [], left: new Map(), weights };
  collect(parsed, parsed.entities ?? [], (point) => point, undefined, 0, found);
  const layers = new Set([...found.lines.map(({ layer }) => layer!), ...found.loose.keys()]);
  const all = [...layers].flatMap((layer) => joined(found.loose.get(layer) ?? [], found.lines.filter((line) => line.layer === layer), layer));
  if (all.length === 0) throw new FileFault('This DXF file has no lines, polylines, arcs or splines.');
  const left = [...found.left].map(([type, n]) => `${n} ${type.toLowerCase()}`).join(', ');
  return { format: 'DXF', lines: all, unit: UNITS[Number(parsed.header?.$INSUNITS)] ?? null, up: 'z', notes: left === '' ? [] : [`Left out, because they are no lines: ${left}.`] };
}

function collect(parsed: Parsed, entities: Entity[], outer: Place, layerOfBlock: string | undefined, depth: number, found: Found): void {
  for (const entity of entities) {
    if (entity.inPaperSpace || entity.visible === false) continue;
    // Entities of layer 0 in a block belong to the layer of its insert.
    const layer = (entity.layer === '0' ? layerOfBlock : undefined) ?? entity.layer ?? '0';
    if (entity.type === 'INSERT') {
      const block = parsed.blocks?.[entity.name ?? ''];
      if (block && depth < DEEPEST) for (const place of placesOf(entity, block.position)) collect(parsed, block.entities ?? [], (point) => outer(place(point)), layer, depth + 1, found);
      continue;
    }
    const upright = ocs(entity);
    const add = (points: Vec3[], closed = false, place: Place = upright): void => {
      if (points.length >= 2) found.lines.push(polyline(points.map((point) => outer(place(point))), closed, layer));
    };
    /** Adds an open piece of a chain. */
    const piece = (points: Vec3[], place: Place = upright): void => {
      const own = found.loose.get(layer) ?? [];
      own.push(points.map((point) => outer(place(point))));
      found.loose.set(layer, own);
    };
    const own = (entity.vertices ?? []).map(({ x, y, z }): Vec3 => [x, y, z ?? entity.elevation ?? 0]);
    if (entity.type === 'LINE' && own.length >= 2) piece(own.slice(0, 2), (point) => point);
    else if ((entity.type === 'LWPOLYLINE' || entity.type === 'POLYLINE') && !entity.isPolyfaceMesh && !entity.is3dPolygonMesh) add(bulged(entity.vertices ?? [], own, entity.shape === true), entity.shape === true);
    else if (entity.type === 'CIRCLE' && entity.center && entity.radius) add(arc(entity), true);
    else if (entity.type === 'ARC' && entity.center && entity.radius) piece(arc(entity));
    else if (entity.type === 'ELLIPSE' && entity.center && entity.majorAxisEndPoint) {
      const { points, closed } = ellipse(entity);
      if (closed) add(points, true, (point) => point);
      else piece(points, (point) => point);
    } else if (entity.type === 'SPLINE') add(spline(entity, found.weights), entity.closed === true, (point) => point);
    else if (!SILENT.includes(entity.type)) found.left.set(entity.type, (found.left.get(entity.type) ?? 0) + 1);
  }
}

/** The places of a block's copies. */
function placesOf({ position, xScale = 1, yScale = 1, zScale = 1, rotation = 0, columnCount = 1, rowCount = 1, columnSpacing = 0, rowSpacing = 0, ...entity }: Entity, base: Vertex | undefined): Place[] {
  const angle = (rotation * Math.PI) / 180;
  const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
  const upright = ocs(entity as Entity);
  const at = position ?? { x: 0, y: 0, z: 0 };
  return Array.from({ length: Math.max(rowCount, 1) * Math.max(columnCount, 1) }, (_, i): Place => {
    const [column, row] = [(i % Math.max(columnCount, 1)) * columnSpacing, Math.floor(i / Math.max(columnCount, 1)) * rowSpacing];
    return ([x, y, z]) => {
      const [u, v, w] = [(x - (base?.x ?? 0)) * xScale + column, (y - (base?.y ?? 0)) * yScale + row, (z - (base?.z ?? 0)) * zScale];
      return upright([at.x + cos * u - sin * v, at.y + sin * u + cos * v, (at.z ?? 0) + w]);
    };
  });
}

/** From an entity's own coordinates to the world's, by the arbitrary axis algorithm of the DXF reference. */
function ocs({ extrusionDirection: given, extrusionDirectionX, extrusionDirectionY, extrusionDirectionZ }: Entity): Place {
  const n: Vec3 = given ? [given.x, given.y, given.z ?? 1] : [extrusionDirectionX ?? 0, extrusionDirectionY ?? 0, extrusionDirectionZ ?? 1];
  if (n[0] === 0 && n[1] === 0 && n[2] > 0) return (point) => point;
  const cross = (a: Vec3, b: Vec3): Vec3 => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  const unit = (a: Vec3): Vec3 => a.map((value) => value / Math.hypot(...a)) as Vec3;
  const z = unit(n);
  const x = unit(cross(Math.abs(z[0]) < 1 / 64 && Math.abs(z[1]) < 1 / 64 ? [0, 1, 0] : [0, 0, 1], z));
  const y = cross(z, x);
  return (point) => [0, 1, 2].map((axis) => point[0] * x[axis]! + point[1] * y[axis]! + point[2] * z[axis]!) as Vec3;
}

/** A polyline with an arc in place of each edge that has a bulge, the tangent of a quarter of the arc's angle. */
function bulged(vertices: Vertex[], points: Vec3[], closed: boolean): Vec3[] {
  return points.flatMap((from, i) => {
    const to = points[i + 1] ?? (closed ? points[0]! : null);
    const bulge = vertices[i]!.bulge ?? 0;
    if (!to || bulge === 0) return [from];
    const angle = 4 * Math.atan(bulge);
    const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
    // The centre lies on the perpendicular through the chord's middle.
    const offset = (1 - bulge * bulge) / (4 * bulge);
    const [cx, cy] = [from[0] + dx / 2 - dy * offset, from[1] + dy / 2 + dx * offset];
    const steps = stepsOf(angle);
    const [u, v] = [from[0] - cx, from[1] - cy];
    return Array.from({ length: steps }, (_, k): Vec3 => {
      if (k === 0) return from;
      const [cos, sin] = [Math.cos((angle * k) / steps), Math.sin((angle * k) / steps)];
      return [cx + u * cos - v * sin, cy + u * sin + v * cos, from[2] + ((to[2] - from[2]) * k) / steps];
    });
  });
}

const stepsOf = (angle: number): number => Math.max(2, Math.ceil((ROUND * Math.abs(angle)) / (2 * Math.PI) - 1e-9));

function arc({ type, center, radius = 0, startAngle = 0, endAngle = 0 }: Entity): Vec3[] {
  const whole = type === 'CIRCLE';
  const span = whole ? 2 * Math.PI : ((endAngle - startAngle + 4 * Math.PI) % (2 * Math.PI)) || 2 * Math.PI;
  const steps = stepsOf(span);
  return Array.from({ length: whole ? steps : steps + 1 }, (_, i): Vec3 => {
    const angle = (whole ? 0 : startAngle) + (span * i) / steps;
    return [center!.x + radius * Math.cos(angle), center!.y + radius * Math.sin(angle), center!.z ?? 0];
  });
}

/** Its points are those of the world. The minor axis is turned by 90° about the normal, which is z or -z. */
function ellipse({ center, majorAxisEndPoint: major, axisRatio = 1, startAngle = 0, endAngle = 2 * Math.PI, extrusionDirection, extrusionDirectionZ }: Entity): { points: Vec3[]; closed: boolean } {
  const turn = (extrusionDirection?.z ?? extrusionDirectionZ ?? 1) < 0 ? -1 : 1;
  const span = ((endAngle - startAngle + 4 * Math.PI) % (2 * Math.PI)) || 2 * Math.PI;
  const closed = span > 2 * Math.PI - 1e-9;
  const steps = stepsOf(span);
  const points = Array.from({ length: closed ? steps : steps + 1 }, (_, i): Vec3 => {
    const angle = startAngle + (span * i) / steps;
    const [cos, sin] = [Math.cos(angle), Math.sin(angle) * axisRatio * turn];
    return [center!.x + cos * major!.x - sin * major!.y, center!.y + cos * major!.y + sin * major!.x, (center!.z ?? 0) + cos * (major!.z ?? 0)];
  });
  return { points, closed };
}

/**
 * Points of a spline. Where the file has no control points, they lie on a curve through the points that it was fitted
 * to.
 */
function spline({ handle, fitPoints = [], controlPoints = [], knotValues: knots = [], degreeOfSplineCurve: degree = 3, closed }: Entity, weights: Found['weights']): Vec3[] {
  const own = ({ x, y, z }: Vertex): Vec3 => [x, y, z ?? 0];
  if (controlPoints.length <= degree || knots.length !== controlPoints.length + degree + 1) {
    const through = (fitPoints.length > 0 ? fitPoints : controlPoints).map(own);
    if (through.length < 3) return through;
    const returns = through[0]!.every((value, axis) => value === through.at(-1)![axis]);
    const points = curve(returns ? through.slice(0, -1) : through, closed === true || returns, PER_SPAN);
    return returns ? [...points, points[0]!] : points;
  }
  const weight = weights.get(String(handle)) ?? [];
  const controls = controlPoints.map(({ x, y, z }, i) => new Vector4(x, y, z ?? 0, weight[i] ?? 1));
  const last = knots.length - 1 - degree;
  const inner = [...new Set(knots.slice(degree, last + 1))];
  const places = [...inner.slice(1).flatMap((to, i) => Array.from({ length: PER_SPAN }, (_, k) => inner[i]! + ((to - inner[i]!) * k) / PER_SPAN)), knots[last]!];
  const points = places.map((u): Vec3 => {
    const { x, y, z, w } = calcBSplinePoint(degree, knots, controls, u);
    return [x / w, y / w, z / w];
  });
  return closed && Math.hypot(...points[0]!.map((value, axis) => value - points.at(-1)![axis]!)) < 1e-9 * Math.hypot(...points[0]!) + 1e-12 ? points.slice(0, -1) : points;
}

/**
 * Checks that every second line is a group code, of which the parser says nothing. Collects the weights of splines,
 * which the parser drops, and takes out the identifiers of vertices (91), at which it stops to read a polyline.
 */
function prepare(source: string): { text: string; weights: Map<string, number[]> } {
  const lines = source.replace(/\s+$/, '').split(/\r\n|\r|\n/);
  const kept: string[] = [];
  const weights = new Map<string, number[]>();
  let entity = '', handle = '', hasVertices = false;
  for (let i = 0; i + 1 < lines.length; i += 2) {
    const code = lines[i]!.trim(), text = lines[i + 1]!;
    if (!/^-?\d+$/.test(code)) throw new FileFault(`${quote(lines[i]!)} is not a DXF group code.`, i + 1);
    const value = Number(code);
    if (value >= 10 && value < 60 && !Number.isFinite(Number(text))) throw new FileFault(`${quote(text)} is not a number.`, i + 2);
    if (value === 0) [entity, handle, hasVertices] = [text.trim(), '', false];
    else if (value === 5) handle = text.trim();
    else if (value === 10) hasVertices = true;
    if (entity === 'SPLINE' && value === 41) weights.set(handle, [...weights.get(handle) ?? [], Number(text)]);
    if (!(entity === 'LWPOLYLINE' && hasVertices && value === 91)) kept.push(lines[i]!, text);
  }
  if (lines.length % 2 === 1) kept.push(lines.at(-1)!);
  return { text: kept.join('\n'), weights };
}
