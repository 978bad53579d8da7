// A finished job's cables, reactions, statistics and warnings.

import type { JobInfo } from 'plateau-client';
import { el, save } from '../dom';
import type { Request, Vec3 } from '../model/request';
import type { ResultMesh } from '../stage/mesh';
import { capital, humanise, number } from '../text';
import { FIGURES, NUMERICS, OF_MESH, sayWarning, unitOfFigure } from '../words';
import { cableName, type Forced, listOf, text, type Values } from './headlines';

const isObject = (value: unknown): value is Values => value !== null && typeof value === 'object' && !Array.isArray(value);

/** The cables of a result with their forces and lengths. */
function cableForces(values: Values, unit: string): HTMLElement[] {
  const cables = listOf<Forced>(values.cables);
  if (cables.length === 0) return [];
  const heads = ['Cable', `Force ${String(values.force_unit)}`, `Length ${unit}`];
  const rows = cables.slice(0, MOST_CABLES).map(({ name, force_max: force, length }, i) => el('tr', {}, el('th', { scope: 'row' }, cableName(name, i)), el('td', {}, number(force, 4)), el('td', {}, number(length, 4))));
  const more = cables.length - rows.length;
  return [el('table', { className: 'cables' }, el('thead', {}, el('tr', {}, ...heads.map((head) => el('th', { scope: 'col' }, head)))), el('tbody', {}, ...rows)),
    ...(more > 0 ? [el('p', { className: 'quiet small' }, `and ${more} more, in the statistics below`)] : [])];
}
/** Maximum number of rows below the headlines; the statistics list all cables. */
const MOST_CABLES = 12;

/** The part between the headlines and the statistics: cables and reactions with their forces. */
export const details = (job: JobInfo, placed: Placed, unit: string, name: string): HTMLElement[] =>
  [...cableForces(job.statistics as Values, unit), ...reactions(job.statistics as Values, placed, name)];

interface Reaction { boundary?: number | null; point?: number | null; vertex?: number; force: [number, number, number] }

/** A place of the scene in the request's coordinates. */
export type ToRequest = (place: Vec3) => Vec3;
/** The mesh of a result, which has the arrows of the reactions, and its request. */
export interface Placed { mesh: ResultMesh; request: Request; toRequest: ToRequest }

/** The supports of a result with the forces that they take, in the request's coordinates. */
function supportsOf({ mesh, toRequest }: Placed): { place: Vec3; force: Vec3 }[] {
  const arrows = mesh.lines.find(({ name }) => name === 'reactions');
  const sizes = arrows?.values.find(({ name }) => name === 'force')?.values;
  if (!arrows || !sizes) return [];
  return Array.from({ length: arrows.segments.length / 6 }, (_, i) => {
    const [place, tip] = [0, 3].map((end) => toRequest([...arrows.segments.subarray(6 * i + end, 6 * i + end + 3)] as Vec3)) as [Vec3, Vec3];
    const along = tip.map((value, axis) => value - place[axis]!) as Vec3;
    const length = Math.hypot(...along) || 1;
    return { place, force: along.map((value) => (value / length) * sizes[2 * i]!) as Vec3 };
  });
}

/** Relative tolerance of places and forces in a mesh, whose numbers have 32 bits. */
const NEAR = 1e-4;
const apart = (a: number[], b: number[]): number => Math.hypot(...a.map((value, axis) => value - b[axis]!));

/** Names of the supports in the air, by their reactions: each is the foot of a mast or the anchor of a cable. */
function namesInAir(reactions: Reaction[], values: Values, placed: Placed): Map<Reaction, string> {
  const supports = supportsOf(placed);
  const ends = (['masts', 'cables'] as const).flatMap((list) => listOf<{ points?: unknown }>(placed.request[list]).flatMap(({ points }, i) => {
    const name = listOf<{ name: string }>(values[list])[i]?.name ?? '';
    const own = list === 'cables' ? cableName(name, i) : name === `mast ${i}` ? `mast ${i + 1}` : name;
    return listOf<number[]>(points).map((place) => ({ place, name: `${capital(own)}, ${list === 'masts' ? 'foot' : 'anchor'}` }));
  }));
  const names = new Map<Reaction, string>();
  for (const reaction of reactions.filter(({ boundary }) => typeof boundary !== 'number')) {
    // Equal forces come in the same order as their arrows.
    const index = supports.findIndex(({ force }) => apart(force, reaction.force) <= NEAR * Math.hypot(...force));
    const [support] = index < 0 ? [] : supports.splice(index, 1);
    const found = support && ends.find(({ place }) => apart(place, support.place) <= NEAR * Math.max(1, Math.hypot(...place)));
    if (found) names.set(reaction, found.name);
  }
  return names;
}

/** The name of what a reaction holds, counted from 1. */
const anchorOf = ({ boundary, point, vertex }: Reaction): string => (typeof boundary === 'number'
  ? `Boundary ${boundary + 1}${typeof point === 'number' ? `, point ${point + 1}` : ''}` : `Vertex ${(vertex ?? 0) + 1}`);

/** The reactions of all anchors, with a file of them for spreadsheets. */
function reactions(values: Values, placed: Placed, name: string): HTMLElement[] {
  const rows = [...listOf<Reaction>(values.reactions), ...listOf<Reaction>(values.edge_reactions)];
  if (rows.length === 0) return [];
  const inAir = namesInAir(rows, values, placed);
  const anchor = (row: Reaction): string => inAir.get(row) ?? anchorOf(row);
  const unit = String(values.force_unit ?? '');
  const heads = ['Anchor', 'x', 'y', 'z', 'Resultant'];
  const size = ({ force }: Reaction): number => Math.hypot(...force);
  const noise = 1e-9 * Math.max(...rows.map(size));
  const cell = (value: number): HTMLElement => el('td', {}, Math.abs(value) <= noise ? '0' : number(value, 3));
  const csv = (): void => {
    const lines = [heads.map((head) => (head === 'Anchor' ? head : `${head} [${unit}]`)), ...rows.map((row) => [`"${anchor(row)}"`, ...row.force, size(row)]), []];
    save(new Blob([lines.map((line) => line.join(',')).join('\n')], { type: 'text/csv' }), `${name}-reactions.csv`);
  };
  return [
    el('h2', {}, `Reactions in ${unit}`),
    el('div', { className: 'wide', tabIndex: 0, role: 'region', 'aria-label': 'Reactions' }, el('table', { id: 'reactions' }, el('thead', {}, el('tr', {}, ...heads.map((head) => el('th', { scope: 'col' }, head)))),
      el('tbody', {}, ...rows.slice(0, MOST_ROWS).map((row) => el('tr', {}, el('th', { scope: 'row' }, anchor(row)), ...row.force.map(cell), cell(size(row))))))),
    el('p', { className: 'quiet small' }, 'The forces of the supports on the structure.'),
    el('div', { className: 'row' }, el('button', { type: 'button', id: 'reactions-csv', onclick: csv }, 'CSV')),
  ];
}

const FIRST = [
  'objective', 'objective_value', 'secondary_value', 'converged', 'stop_reason', 'residual', 'area', 'certificate', 'initial_area', 'nodes', 'vertices', 'triangles',
  'edges', 'bridges', 'stability', 'iterations', 'self_intersections', 'mean_curvature', 'edge_lengths', 'angles_deg',
];
const rank = ([name]: [string, unknown]): number => FIRST.indexOf(name) + 1 || FIRST.length + 1;
/** More numbers than this in one row are a histogram, which reads better folded up. */
const MOST_IN_A_ROW = 6;
const MOST_ROWS = 500;

/** Lists of places, whose numbers count from 1 on the page. */
const PLACES = ['boundary', 'point', 'vertex', 'vertices', 'cable', 'layer', 'strip', 'directrix', 'mast', 'ring', 'support'];
const fromOne = (column: string, value: unknown): unknown => {
  if (!PLACES.includes(column.split(/[ .]/).at(-1)!)) return value;
  return Array.isArray(value) ? value.map((each) => fromOne(column, each)) : typeof value === 'number' ? value + 1 : value;
};

/** The figures of the result, and those of the solver. */
export function statistics(job: JobInfo, unit: string): { result: HTMLElement[]; numerics: HTMLElement[] } {
  const values = job.statistics as Values;
  const isNumeric = (path: string): boolean => NUMERICS.includes(path) || (job.kind !== 'uniform_mesh' && OF_MESH.includes(path));
  const part = (numeric: boolean, from: Values, prefix = ''): Values => Object.fromEntries(Object.entries(from).flatMap(([name, value]) => {
    const path = prefix + name;
    if (isNumeric(path)) return numeric ? [[name, value]] : [];
    // The figures of an object are told apart one by one.
    const own = prefix === '' && isObject(value) ? part(numeric, value, `${name}.`) : null;
    return own ? (Object.keys(own).length > 0 ? [[name, own]] : []) : numeric ? [] : [[name, value]];
  }));
  const unitOf = (path: string): string => unitOfFigure(path, values.objective, unit, String(values.force_unit ?? ''));
  return { result: figures(part(false, values), unitOf), numerics: figures(part(true, values), unitOf) };
}

/** Sums of a few hundred numbers are wrong by less than this part of the largest of them. */
const ROUNDING = 1e-13;

/** Plain figures as one table; lists, and objects of many figures, as a table each, folded up. */
function figures(values: Values, unitOf: (path: string) => string): HTMLElement[] {
  const rows: HTMLElement[] = [];
  const lists: HTMLElement[] = [];
  const visit = (name: string, value: unknown, noise = 0): void => {
    if (Array.isArray(value)) {
      if (value.length === 0) return;
      if (value.every(isObject)) lists.push(table(name, value, unitOf));
      else if (value.length > MOST_IN_A_ROW) lists.push(folded(name.replaceAll('.', ' '), String(value.length), el('p', { className: 'numbers' }, value.map(text).join(' · '))));
      else rows.push(row(name, value.map(text).join(', '), typeof value[0] === 'number' ? unitOf(name) : ''));
    } else if (isObject(value)) {
      // The figures of an object stand below its name.
      if (!name.includes('.')) rows.push(el('tr', { className: 'group-name' }, el('th', { scope: 'colgroup', colSpan: 2 }, humanise(name.replace(/_deg$/, '')))));
      // Beside the largest figure of its object with the same unit, a figure this small is that figure's rounding.
      const units = Object.keys(value).map((inner) => unitOf(`${name}.${inner}`));
      const sizes = Object.values(value).map((each) => (typeof each === 'number' ? Math.abs(each) : 0));
      Object.entries(value).forEach(([inner, each], i) => {
        const same = units[i] === '' ? [0] : sizes.filter((_, k) => units[k] === units[i]);
        visit(`${name}.${inner}`, each, ROUNDING * Math.max(...same));
      });
    } else if (typeof value === 'number') rows.push(row(name, Math.abs(value) <= noise ? '0' : text(value), unitOf(name)));
    else if (value !== undefined && value !== null) rows.push(row(name, text(value), ''));
  };
  Object.entries(values).filter(([name]) => name !== 'comparison' && name !== 'history').sort((a, b) => rank(a) - rank(b)).forEach(([name, value]) => visit(name, value));
  return [...(rows.length > 0 ? [el('table', { className: 'plain' }, el('tbody', {}, ...rows))] : []), ...lists];
}

/** A text longer than this stands below its name, because the column of values is narrow. */
const LONG_TEXT = 60;
function row(path: string, plain: string, unit: string): HTMLElement {
  const value = unit === '' ? plain : `${plain} ${unit}`;
  const [, ...inner] = path.split('.');
  const title = FIGURES[path] ?? humanise(inner.length > 0 ? inner.join(' ') : path);
  const className = inner.length > 0 ? 'inner' : '';
  if (value.length > LONG_TEXT) return el('tr', { className }, el('td', { className: 'long', colSpan: 2 }, el('span', {}, title), value));
  return el('tr', { className }, el('th', { scope: 'row' }, title), el('td', {}, value));
}

const folded = (name: string, of: string, inner: HTMLElement): HTMLElement =>
  el('details', {}, el('summary', {}, `${humanise(name)} (${of})`), el('div', { className: 'wide', tabIndex: 0, role: 'region', 'aria-label': humanise(name) }, inner));

function table(path: string, items: Values[], unitOf: (path: string) => string): HTMLElement {
  const name = path.replaceAll('.', ' ');
  const flat = items.map((item) => flatten(item));
  const columns = [...new Set(flat.flatMap((item) => Object.keys(item)))];
  const head = el('tr', {}, ...columns.map((column) => el('th', { scope: 'col' }, titled(humanise(column), items.length > 0 && flat.some((item) => /^[\d−]/.test(text(item[column]))) ? unitOf(`${path}.${column.replaceAll(' ', '.')}`) : ''))));
  const body = flat.slice(0, MOST_ROWS).map((item) => el('tr', {}, ...columns.map((column) => el('td', {}, column in item ? text(item[column]) : ''))));
  const count = items.length > MOST_ROWS ? `first ${MOST_ROWS} of ${items.length}` : String(items.length);
  return folded(name, count, el('table', {}, el('thead', {}, head), el('tbody', {}, ...body)));
}

const titled = (title: string, unit: string): string => (unit === '' ? title : `${title} (${unit})`);

function flatten(item: Values, prefix = ''): Values {
  return Object.entries(item).reduce<Values>((out, [name, value]) => {
    if (isObject(value)) return { ...out, ...flatten(value, `${prefix}${name} `) };
    const shown = fromOne(name, value);
    return { ...out, [prefix + name]: Array.isArray(shown) ? shown.map(text).join(', ') : shown };
  }, {});
}

/** Each warning once, in the page's own words, which count from 1. */
export const warnings = (list: JobInfo['warnings'], unit: string): HTMLElement[] => (list ?? []).map(({ code, values, detail }) => {
  const said = sayWarning(code, values, detail, unit);
  return el('div', { className: 'warning', 'data-code': code }, el('strong', {}, humanise(code)), said.sentence,
    said.detail !== null && el('details', {}, el('summary', {}, 'In the words of the service, which counts from 0'), said.detail));
});
