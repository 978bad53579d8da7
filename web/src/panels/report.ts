// A finished job's cables, reactions, statistics and warnings.

import type { JobInfo } from 'plateau-client';
import { el, save } from '../dom';
import type { Request } from '../model/request';
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
export const details = (job: JobInfo, request: Request, unit: string, name: string): HTMLElement[] =>
  [...cableForces(job.statistics as Values, unit), ...reactions(job.statistics as Values, request, name)];

interface Reaction { boundary?: number | null; point?: number | null; vertex?: number; force: [number, number, number] }

/** Largest difference between a reaction and the force of a member, relative to it, at which the member ends there. */
const SAME_FORCE = 0.1;

/** The mast or the cable in the air whose force a support in the air takes; null if no single member ends there. */
function memberAt({ force }: Reaction, values: Values, request: Request): string | null {
  const size = Math.hypot(...force);
  const likeness = (list: string, word: string): { name: string; off: number }[] => listOf<{ points?: unknown }>(request[list]).flatMap(({ points }, i) => {
    const found = listOf<{ name: string; force: number }>(values[list])[i];
    const [a, b] = listOf<number[]>(points);
    if (!found || !a || !b) return [];
    const along = a.map((value, axis) => b[axis]! - value);
    const angle = Math.abs(along.reduce((sum, value, axis) => sum + value * force[axis]!, 0)) / (Math.hypot(...along) * size || 1);
    return [{ name: `${capital(list === 'masts' ? mastName(found.name, i) : cableName(found.name, i))}, ${word}`, off: 1 - angle + Math.abs(Math.abs(found.force) - size) / (size || 1) }];
  });
  const [best] = [...likeness('masts', 'foot'), ...likeness('cables', 'anchor')].sort((one, other) => one.off - other.off);
  return best && best.off < SAME_FORCE ? best.name : null;
}
const mastName = (name: string, i: number): string => (name === `mast ${i}` ? `mast ${i + 1}` : name);

/** The name of what a reaction holds, counted from 1. */
const anchorOf = (reaction: Reaction, values: Values, request: Request): string => {
  const { boundary, point, vertex } = reaction;
  if (typeof boundary !== 'number') return memberAt(reaction, values, request) ?? `Vertex ${(vertex ?? 0) + 1}`;
  return `Boundary ${boundary + 1}${typeof point === 'number' ? `, point ${point + 1}` : ''}`;
};

/** The reactions of all anchors, with a file of them for spreadsheets. */
function reactions(values: Values, request: Request, name: string): HTMLElement[] {
  const rows = [...listOf<Reaction>(values.reactions), ...listOf<Reaction>(values.edge_reactions)];
  if (rows.length === 0) return [];
  const anchor = (row: Reaction): string => anchorOf(row, values, request);
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
  const isNumeric = (name: string): boolean => NUMERICS.includes(name) || (job.kind !== 'uniform_mesh' && OF_MESH.includes(name));
  const part = (numeric: boolean): Values => Object.fromEntries(Object.entries(values).filter(([name]) => isNumeric(name) === numeric));
  const unitOf = (path: string): string => unitOfFigure(path, values.objective, unit, String(values.force_unit ?? ''));
  return { result: figures(part(false), unitOf), numerics: figures(part(true), unitOf) };
}

/** Plain figures as one table; lists, and objects of many figures, as a table each, folded up. */
function figures(values: Values, unitOf: (path: string) => string): HTMLElement[] {
  const rows: HTMLElement[] = [];
  const lists: HTMLElement[] = [];
  const visit = (name: string, value: unknown): void => {
    if (Array.isArray(value)) {
      if (value.length === 0) return;
      if (value.every(isObject)) lists.push(table(name, value, unitOf));
      else if (value.length > MOST_IN_A_ROW) lists.push(folded(name.replaceAll('.', ' '), String(value.length), el('p', { className: 'numbers' }, value.map(text).join(' · '))));
      else rows.push(row(name, value.map(text).join(', '), typeof value[0] === 'number' ? unitOf(name) : ''));
    } else if (isObject(value)) {
      // The figures of an object stand below its name.
      if (!name.includes('.')) rows.push(el('tr', { className: 'group-name' }, el('th', { scope: 'colgroup', colSpan: 2 }, humanise(name.replace(/_deg$/, '')))));
      Object.entries(value).forEach(([inner, each]) => visit(`${name}.${inner}`, each));
    } else if (value !== undefined) rows.push(row(name, text(value), typeof value === 'number' ? unitOf(name) : ''));
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
