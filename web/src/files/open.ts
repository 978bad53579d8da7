// Opens a file, dropped or pasted: a request of this service, or polylines in one of the formats that drawings come in.

import { kindOf, type Request } from '../model/request';
import { readCsv } from './csv';
import { readDxf } from './dxf';
import { isGeoJson, readGeoJson } from './geojson';
import { readGltf } from './gltf';
import { parseJson } from './json';
import { type Drawing, FileFault } from './lines';
import { readObj } from './obj';

export type Opened = { request: Request } | Drawing;

/** Beginnings of files that hold no drawing that is read here, what they are, and what to do. */
const OTHERS: [RegExp, string][] = [
  [/^(\xff\xd8\xff|\x89PNG|GIF8|BM|II\*\0|MM\0\*|RIFF....WEBP|....ftyp(heic|mif1|avif))/s, 'This is a picture, which has no lines that could be read.'],
  [/^%PDF/, 'This is a PDF. Save the drawing as DXF.'],
  [/^AC10/, 'This is DWG. Save the drawing as DXF.'],
  [/^PK\x03\x04/, 'This is a spreadsheet or an archive. Save the points as CSV.'],
  [/^\xd0\xcf\x11\xe0/, 'This is a spreadsheet or a document of an older office program. Save the points as CSV.'],
  [/^3D Geometry File Format/, 'This is a file of Rhino. Export its curves as OBJ or DXF.'],
  [/^ISO-10303-21/, 'This is STEP or IFC. Export its curves as DXF or OBJ.'],
  [/^(\xff\xfe\xff\x0e|SketchUp)/, 'This is a file of SketchUp. Export it as DXF or OBJ.'],
  [/^\0\0\x27\x0a/, 'This is a shape file. Save it as GeoJSON.'],
];
const READABLE = 'CSV, OBJ, DXF, GeoJSON, glTF and requests of this service can be opened.';

export async function openFile(file: File): Promise<Opened> {
  const bytes = new Uint8Array(await file.slice(0, 4096).arrayBuffer());
  const head = String.fromCharCode(...bytes);
  if (head.startsWith('glTF')) return readGltf(await file.arrayBuffer());
  const [, what] = OTHERS.find(([beginning]) => beginning.test(head)) ?? [];
  if (what !== undefined) throw new FileFault(`${what} ${READABLE}`);
  // Spreadsheets save text in 16 bits on demand.
  const wide = head.startsWith('\xff\xfe') ? 'utf-16le' : head.startsWith('\xfe\xff') ? 'utf-16be' : null;
  if (wide === null && head.includes('\0')) throw new FileFault(`This is no text. ${READABLE}`);
  const text = wide === null ? await file.text() : new TextDecoder(wide).decode(await file.arrayBuffer());
  return openText(text, /\.(\w+)$/.exec(file.name)?.[1]?.toLowerCase() ?? '');
}

/** `extension` decides where there is one, the text itself where there is none. */
export async function openText(text: string, extension = ''): Promise<Opened> {
  if (text.trim() === '') throw new FileFault('There is nothing in it.');
  const start = text.trimStart();
  if (['json', 'geojson', 'gltf'].includes(extension) || (extension === '' && /^[{[]/.test(start))) return openJson(text);
  if (extension === 'obj' || (extension === '' && /^\s*(v|l|o|g)\s/m.test(text))) return readObj(text);
  if (extension === 'dxf' || (extension === '' && /^\s*(0|999)\s*\r?\n/.test(text))) return readDxf(text);
  const drawing = readCsv(text);
  if (drawing.lines.length === 0) throw new FileFault('There are no points in it.');
  return drawing;
}

async function openJson(text: string): Promise<Opened> {
  const value = parseJson(text);
  if (isGeoJson(value)) return readGeoJson(value, text);
  if (value !== null && typeof value === 'object' && 'asset' in value) return readGltf(text);
  if (value === null || typeof value !== 'object' || Array.isArray(value)) throw new FileFault('This JSON is neither a request nor GeoJSON nor glTF.');
  const request = value as Request;
  if (!kindOf(request)) throw new FileFault('This JSON is neither a request (with boundaries, directrices or a domain) nor GeoJSON nor glTF.');
  return { request };
}
