// GeoJSON: the lines and rings of every geometry in it. Numbers are taken as they are, in the request's unit.

import type { Vec3 } from '../model/request';
import { FileFault, type Polyline, polyline } from './lines';

const TYPES = ['FeatureCollection', 'Feature', 'GeometryCollection', 'LineString', 'MultiLineString', 'Polygon', 'MultiPolygon', 'Point', 'MultiPoint'];
export const isGeoJson = (value: unknown): boolean => TYPES.includes(String((value as { type?: unknown } | null)?.type));

interface Node { type?: string; features?: Node[]; geometry?: Node | null; geometries?: Node[]; coordinates?: unknown }

/** `text` is what `value` was read from, to say in which line a bad coordinate stands. */
export function readGeoJson(value: unknown, text: string): Polyline[] {
  const found: Polyline[] = [];
  const points: Vec3[] = [];
  const point = (at: unknown): Vec3 => {
    const numbers = Array.isArray(at) ? at : null;
    if (!numbers || numbers.length < 2 || !numbers.slice(0, 3).every((each) => typeof each === 'number' && Number.isFinite(each))) {
      const shown = JSON.stringify(at) ?? 'nothing';
      throw new FileFault(`${shown.slice(0, 40)} is not a position.`, lineOf(text, at));
    }
    return [numbers[0], numbers[1], numbers[2] ?? 0] as Vec3;
  };
  const list = (at: unknown): unknown[] => {
    if (!Array.isArray(at)) throw new FileFault(`${(JSON.stringify(at) ?? 'nothing').slice(0, 40)} is not a list of positions.`, lineOf(text, at));
    return at;
  };
  const visit = (node: Node | null | undefined): void => {
    if (!node) return;
    const { type, coordinates } = node;
    if (type === 'FeatureCollection') list(node.features).forEach((each) => visit(each as Node));
    else if (type === 'Feature') visit(node.geometry);
    else if (type === 'GeometryCollection') list(node.geometries).forEach((each) => visit(each as Node));
    else if (type === 'LineString') found.push(polyline(list(coordinates).map(point)));
    else if (type === 'MultiLineString') list(coordinates).forEach((line) => found.push(polyline(list(line).map(point))));
    else if (type === 'Polygon') list(coordinates).forEach((ring) => found.push(polyline(list(ring).map(point), true)));
    else if (type === 'MultiPolygon') list(coordinates).forEach((polygon) => list(polygon).forEach((ring) => found.push(polyline(list(ring).map(point), true))));
    else if (type === 'Point') points.push(point(coordinates));
    else if (type === 'MultiPoint') points.push(...list(coordinates).map(point));
    else throw new FileFault(`GeoJSON has no type ${JSON.stringify(type)}.`, lineOf(text, type));
  };
  visit(value as Node);
  if (found.length === 0 && points.length > 1) found.push(polyline(points));
  if (found.length === 0) throw new FileFault('This GeoJSON has no lines or polygons.');
  return found;
}

/** The line in which a value of a JSON text stands, spaces aside; unknown if it is not found. */
function lineOf(text: string, value: unknown): number | undefined {
  const wanted = JSON.stringify(value);
  if (!wanted) return undefined;
  const pattern = [...wanted].map((c) => c.replace(/[.*+?^${}()|[\]\\]/g, '\\$&')).join('\\s*').slice(0, 4000);
  const at = text.search(new RegExp(pattern));
  return at < 0 ? undefined : text.slice(0, at).split('\n').length;
}
