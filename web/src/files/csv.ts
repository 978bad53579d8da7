// Points as comma, semicolon, tab or space separated values: one a line; an empty line, or a change in a column called
// `line`, begins another polyline. A first line of names is allowed.

import Papa from 'papaparse';
import type { Vec3 } from '../model/request';
import { FileFault, finite, type Polyline, polyline, quote } from './lines';

export function readCsv(text: string): Polyline[] {
  const spaced = !/[,;\t|]/.test(text);
  const { data } = Papa.parse<string[]>(spaced ? text.replace(/[ ]+/g, ' ').replace(/^ | $/gm, '') : text, { delimiter: spaced ? ' ' : '' });
  let columns = [0, 1, 2], by = -1;
  const lists: Vec3[][] = [[]];
  let group: string | undefined;
  let begun = false;
  for (const [i, row] of data.entries()) {
    const cells = row.map((cell) => cell.trim());
    if (cells.every((cell) => cell === '')) {
      if (lists.at(-1)!.length > 0) lists.push([]);
      continue;
    }
    if (cells[0]!.startsWith('#')) continue;
    if (!begun && cells.every((cell) => !Number.isFinite(Number(cell)) || cell === '')) {
      const names = cells.map((cell) => cell.toLowerCase());
      const place = (...wanted: string[]): number => names.findIndex((name) => wanted.includes(name));
      const [x, y, z] = [place('x', 'easting', 'e'), place('y', 'northing', 'n'), place('z', 'height', 'elevation', 'h')];
      if (x < 0 || y < 0) throw new FileFault(`${quote(row.join(','))} names no columns x and y, and is no point.`, i + 1);
      columns = [x, y, z];
      by = place('line', 'polyline', 'boundary', 'curve', 'id');
      begun = true;
      continue;
    }
    begun = true;
    if (cells.length < 2) throw new FileFault(`${quote(row.join(','))} is no point: x, y and z are expected.`, i + 1);
    if (by >= 0 && group !== undefined && cells[by] !== group && lists.at(-1)!.length > 0) lists.push([]);
    group = by >= 0 ? cells[by] : undefined;
    lists.at(-1)!.push(columns.map((column) => (column < 0 || (cells[column] ?? '') === '' && column === columns[2] ? 0 : finite(cells[column] ?? '', i + 1))) as Vec3);
  }
  return lists.filter((list) => list.length > 0).map((list) => polyline(list));
}
