// GeoJSON: the lines and rings of every geometry in it. By its standard (RFC 7946) coordinates are degrees. Files of
// older programs name another system of coordinates, and drawings are larger than a site can be in degrees.

import type { Vec3 } from '../model/request';
import { type Drawing, FileFault, type Polyline, polyline } from './lines';
import { type FileUnit, fromWebMap, mayBeDegrees } from './units';

const TYPES = ['FeatureCollection', 'Feature', 'GeometryCollection', 'LineString', 'MultiLineString', 'Polygon', 'MultiPolygon', 'Point', 'MultiPoint'];
export const isGeoJson = (value: unknown): boolean => TYPES.includes(String((value as { type?: unknown } | null)?.type));

interface Node {
  type?: string; features?: Node[]; geometry?: Node | null; geometries?: Node[]; coordinates?: unknown; properties?: Record<string, unknown> | null;
  crs?: { properties?: { name?: string } } | null;
}

/** Numbers of the EPSG's register whose coordinates are metres: UTM, and the systems of some countries. */
const IN_METRES = /^(32[67]\d\d|258\d\d|2056|21781|27700|2154|28992|3006|3067|3146[6-9]|3035|5514|2193|28[34]\d\d)$/;
const IN_DEGREES = /^(4326|4258|4269|4979|4171|4151)$/;
/** Web Mercator, the system of web maps. */
const WEB_MAP = /^(3857|900913|3785)$/;

/** Names of the properties that group features. */
const GROUPS = ['layer', 'Layer', 'name', 'Name', 'NAME', 'type', 'kind'];

/** `text` is what `value` was read from, to say in which line a bad coordinate stands. */
export function readGeoJson(value: unknown, text: string): Drawing {
  const found: Polyline[] = [];
  let layer: string | undefined;
  const add = (points: Vec3[], closed = false): void => { found.push(polyline(points, closed, layer)); };
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
    else if (type === 'Feature') {
      const name = GROUPS.map((each) => node.properties?.[each]).find((each) => typeof each === 'string' && each !== '');
      layer = name as string | undefined;
      visit(node.geometry);
      layer = undefined;
    }
    else if (type === 'GeometryCollection') list(node.geometries).forEach((each) => visit(each as Node));
    else if (type === 'LineString') add(list(coordinates).map(point));
    else if (type === 'MultiLineString') list(coordinates).forEach((line) => add(list(line).map(point)));
    else if (type === 'Polygon') list(coordinates).forEach((ring) => add(list(ring).map(point), true));
    else if (type === 'MultiPolygon') list(coordinates).forEach((polygon) => list(polygon).forEach((ring) => add(list(ring).map(point), true)));
    else if (type === 'Point') points.push(point(coordinates));
    else if (type === 'MultiPoint') points.push(...list(coordinates).map(point));
    else throw new FileFault(`GeoJSON has no type ${JSON.stringify(type)}.`, lineOf(text, type));
  };
  visit(value as Node);
  if (found.length === 0 && points.length > 1) found.push(polyline(points));
  if (found.length === 0) throw new FileFault('This GeoJSON has no lines or polygons.');
  return { format: 'GeoJSON', ...located(found, (value as Node).crs?.properties?.name), up: 'z', notes: [] };
}

/**
 * The lines with the unit of their coordinates: that of the named system, else degrees where the drawing is no larger
 * than a site.
 */
function located(lines: Polyline[], system: string | undefined): { lines: Polyline[]; unit: FileUnit | null } {
  const [, code = ''] = /(\w+)$/.exec(system ?? '') ?? [];
  if (WEB_MAP.test(code)) return { lines: lines.map((line) => ({ ...line, points: line.points.map(fromWebMap) })), unit: 'degrees' };
  if (IN_METRES.test(code)) return { lines, unit: 'm' };
  const named = IN_DEGREES.test(code) || code === 'CRS84' || system === undefined;
  return { lines, unit: named && mayBeDegrees(lines) ? 'degrees' : null };
}

/** The line in which a value of a JSON text stands, spaces aside; unknown if it is not found. */
function lineOf(text: string, value: unknown): number | undefined {
  const wanted = JSON.stringify(value);
  if (!wanted) return undefined;
  const pattern = [...wanted].map((c) => c.replace(/[.*+?^${}()|[\]\\]/g, '\\$&')).join('\\s*').slice(0, 4000);
  const at = text.search(new RegExp(pattern));
  return at < 0 ? undefined : text.slice(0, at).split('\n').length;
}
