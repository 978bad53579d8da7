// Points as comma, semicolon, tab or space separated values: one a line; an empty line, or a change in a column called
// `line`, begins another polyline. A first line of names is allowed, which may hold the unit. Decimal commas are read.

import Papa from 'papaparse';
import type { Vec3 } from '../model/request';
import { type Drawing, FileFault, finite, numeric, polyline, quote } from './lines';
import { type FileUnit, METRES } from './units';

const NAMES = {
  x: ['x', 'easting', 'east', 'e', 'rechtswert', 'rw', 'xcoord', 'coordx', 'pointx'], y: ['y', 'northing', 'north', 'n', 'hochwert', 'hw', 'ycoord', 'coordy', 'pointy'],
  z: ['z', 'height', 'elevation', 'elev', 'altitude', 'alt', 'h', 'zcoord', 'coordz', 'pointz'],
  lon: ['lon', 'lng', 'long', 'longitude'], lat: ['lat', 'latitude'], line: ['line', 'polyline', 'boundary', 'curve', 'layer', 'id'],
};
const UNITS: Record<string, FileUnit> = { ...Object.fromEntries(Object.keys(METRES).map((unit) => [unit, unit as FileUnit])), meter: 'm', metre: 'm', metres: 'm', meters: 'm', feet: 'ft', foot: 'ft', inch: 'in', inches: 'in', ftus: 'US survey ft', usft: 'US survey ft', deg: 'degrees', '°': 'degrees' };

/** The sign between the cells of a line. Where commas are decimal signs, it is another one. */
function separator(text: string): string {
  const line = text.split(/\r?\n/).find((each) => /\d/.test(each)) ?? '';
  if (line.includes(';')) return ';';
  if (line.includes('\t')) return '\t';
  if (line.includes('|')) return '|';
  const spaced = /^\s*-?\d+(,\d+)?(\s+-?\d+(,\d+)?){1,3}\s*$/.test(line);
  return line.includes(',') && !spaced ? ',' : ' ';
}

/** A name of a column, and the unit that stands behind it. */
function columnOf(cell: string): { name: string; unit: FileUnit | null } {
  const [, stem = '', bracketed, tail] = /^(.*?)(?:[\s_]*[[(]\s*([^\])]+?)\s*[\])]|[\s_](mm|cm|dm|m|km|ft|in|yd))?$/.exec(cell.trim().toLowerCase()) ?? [];
  return { name: stem.replace(/[\s_.-]/g, ''), unit: UNITS[(bracketed ?? tail ?? '').replace(/[\s._-]/g, '')] ?? null };
}

export function readCsv(text: string): Drawing {
  const sign = separator(text);
  const { data } = Papa.parse<string[]>(sign === ' ' ? text.replace(/[ ]+/g, ' ').replace(/^ | $/gm, '') : text, { delimiter: sign });
  let columns = [0, 1, 2], by = -1;
  let unit: FileUnit | null = null;
  const lists: { points: Vec3[]; name?: string }[] = [{ points: [] }];
  let group: string | undefined;
  let begun = false;
  for (const [i, row] of data.entries()) {
    const cells = row.map((cell) => cell.trim());
    if (cells.every((cell) => cell === '')) {
      if (lists.at(-1)!.points.length > 0) lists.push({ points: [] });
      continue;
    }
    if (cells[0]!.startsWith('#')) continue;
    if (!begun && cells.every((cell) => !Number.isFinite(numeric(cell)) || cell === '')) {
      const names = cells.map(columnOf);
      const place = (wanted: string[]): number => names.findIndex(({ name }) => wanted.includes(name));
      const degrees = place(NAMES.lon) >= 0 && place(NAMES.lat) >= 0;
      const [x, y, z] = [place(degrees ? NAMES.lon : NAMES.x), place(degrees ? NAMES.lat : NAMES.y), place(NAMES.z)];
      if (x! < 0 || y! < 0) throw new FileFault(`${quote(row.join(','))} names no columns x and y, and is no point.`, i + 1);
      columns = [x!, y!, z!];
      unit = degrees ? 'degrees' : names[x!]!.unit;
      by = place(NAMES.line);
      begun = true;
      continue;
    }
    // A survey's list begins with the number of each point.
    if (!begun && cells.length > 3 && !Number.isFinite(numeric(cells[0]!)) && Number.isFinite(numeric(cells[1]!))) columns = [1, 2, 3];
    begun = true;
    if (cells.length < 2) throw new FileFault(`${quote(row.join(','))} is no point: x, y and z are expected.`, i + 1);
    if (by >= 0 && group !== undefined && cells[by] !== group && lists.at(-1)!.points.length > 0) lists.push({ points: [] });
    group = by >= 0 ? cells[by] : undefined;
    const last = lists.at(-1)!;
    if (group !== undefined) last.name = group;
    last.points.push(columns.map((column) => (column < 0 || (cells[column] ?? '') === '' && column === columns[2] ? 0 : finite(cells[column] ?? '', i + 1))) as Vec3);
  }
  // An identifier that differs in each line numbers the points.
  const filled = lists.filter(({ points }) => points.length > 0);
  const numbered = by >= 0 && filled.length > 2 && filled.every(({ points }) => points.length === 1);
  const lines = numbered ? [polyline(filled.flatMap(({ points }) => points))] : filled.map(({ points, name }) => polyline(points, false, name));
  return { format: 'CSV', lines, unit, up: null, notes: [] };
}
