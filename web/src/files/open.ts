// Opens a file, dropped or pasted: a request of this service, or polylines in one of the formats that drawings come in.

import { kindOf, type Request } from '../model/request';
import { readCsv } from './csv';
import { readDxf } from './dxf';
import { isGeoJson, readGeoJson } from './geojson';
import { readGltf } from './gltf';
import { parseJson } from './json';
import { FileFault, type Polyline } from './lines';
import { readObj } from './obj';

export type Opened = { request: Request } | { lines: Polyline[]; format: string; metres: boolean };

export async function openFile(file: File): Promise<Opened> {
  const head = new Uint8Array(await file.slice(0, 4).arrayBuffer());
  if (String.fromCharCode(...head) === 'glTF') return { lines: readGltf(await file.arrayBuffer()), format: 'glTF', metres: true };
  return openText(await file.text(), /\.(\w+)$/.exec(file.name)?.[1]?.toLowerCase() ?? '');
}

/** `extension` decides where there is one, the text itself where there is none. */
export async function openText(text: string, extension = ''): Promise<Opened> {
  if (text.trim() === '') throw new FileFault('There is nothing in it.');
  const start = text.trimStart();
  if (['json', 'geojson', 'gltf'].includes(extension) || (extension === '' && /^[{[]/.test(start))) return openJson(text);
  if (extension === 'obj' || (extension === '' && /^\s*(v|l|o|g)\s/m.test(text))) return { lines: readObj(text), format: 'OBJ', metres: false };
  if (extension === 'dxf' || (extension === '' && /^\s*(0|999)\s*\r?\n/.test(text))) return { lines: readDxf(text), format: 'DXF', metres: false };
  const lines = readCsv(text);
  if (lines.length === 0) throw new FileFault('There are no points in it.');
  return { lines, format: 'CSV', metres: false };
}

async function openJson(text: string): Promise<Opened> {
  const value = parseJson(text);
  if (isGeoJson(value)) return { lines: readGeoJson(value, text), format: 'GeoJSON', metres: false };
  if (value !== null && typeof value === 'object' && 'asset' in value) return { lines: readGltf(text), format: 'glTF', metres: true };
  if (value === null || typeof value !== 'object' || Array.isArray(value)) throw new FileFault('This JSON is neither a request nor GeoJSON nor glTF.');
  const request = value as Request;
  if (!kindOf(request)) throw new FileFault('This JSON is neither a request (with boundaries, directrices or a domain) nor GeoJSON nor glTF.');
  return { request };
}
