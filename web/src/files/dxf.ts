// DXF: lines, polylines, arcs, circles and splines of the model space, by dxf-parser.

import DxfParser from 'dxf-parser';
import type { Vec3 } from '../model/request';
import { chains, FileFault, type Polyline, polyline, quote } from './lines';

interface Vertex { x: number; y: number; z?: number }
interface Entity {
  type: string; vertices?: Vertex[]; shape?: boolean; elevation?: number; center?: Vertex; radius?: number; startAngle?: number; endAngle?: number;
  fitPoints?: Vertex[]; controlPoints?: Vertex[]; closed?: boolean;
}

/** Segments of a full circle. */
const ROUND = 48;

export function readDxf(text: string): Polyline[] {
  checkCodes(text);
  let entities: Entity[];
  try {
    entities = (new DxfParser().parseSync(text)?.entities ?? []) as unknown as Entity[];
  } catch (error) {
    throw new FileFault(`This is not DXF that can be read: ${error instanceof Error ? error.message : String(error)}.`);
  }
  const segments: [Vec3, Vec3][] = [], found: Polyline[] = [];
  for (const entity of entities) {
    const points = (entity.vertices ?? []).map(({ x, y, z }): Vec3 => [x, y, z ?? entity.elevation ?? 0]);
    if (entity.type === 'LINE' && points.length >= 2) segments.push([points[0]!, points[1]!]);
    else if ((entity.type === 'LWPOLYLINE' || entity.type === 'POLYLINE') && points.length >= 2) found.push(polyline(points, entity.shape === true));
    else if ((entity.type === 'CIRCLE' || entity.type === 'ARC') && entity.center && entity.radius) found.push(arc(entity));
    else if (entity.type === 'SPLINE') {
      const through = entity.fitPoints?.length ? entity.fitPoints : entity.controlPoints ?? [];
      if (through.length >= 2) found.push(polyline(through.map(({ x, y, z }): Vec3 => [x, y, z ?? 0]), entity.closed === true));
    }
  }
  const all = [...found, ...(segments.length > 0 ? chains(segments) : [])];
  if (all.length === 0) throw new FileFault('This DXF file has no lines, polylines, arcs or splines.');
  return all;
}

function arc({ type, center, radius = 0, startAngle = 0, endAngle = 0 }: Entity): Polyline {
  const whole = type === 'CIRCLE';
  const span = whole ? 2 * Math.PI : ((endAngle - startAngle + 4 * Math.PI) % (2 * Math.PI)) || 2 * Math.PI;
  const steps = Math.max(2, Math.ceil((ROUND * span) / (2 * Math.PI)));
  const points = Array.from({ length: whole ? steps : steps + 1 }, (_, i): Vec3 => {
    const angle = (whole ? 0 : startAngle) + (span * i) / steps;
    return [center!.x + radius * Math.cos(angle), center!.y + radius * Math.sin(angle), center!.z ?? 0];
  });
  return { points, closed: whole };
}

/** Every second line of a DXF file is a group code; the parser says nothing of where one is not, and nothing of odd numbers. */
function checkCodes(text: string): void {
  const lines = text.replace(/\s+$/, '').split(/\r?\n/);
  for (let i = 0; i + 1 < lines.length; i += 2) {
    const code = lines[i]!.trim();
    if (!/^-?\d+$/.test(code)) throw new FileFault(`${quote(lines[i]!)} is not a DXF group code.`, i + 1);
    const value = Number(code);
    if (value >= 10 && value < 60 && !Number.isFinite(Number(lines[i + 1]))) throw new FileFault(`${quote(lines[i + 1]!)} is not a number.`, i + 2);
  }
}
