// A finished job's statistics, warnings and history.

import type { HistoryRow, JobInfo } from 'plateau-client';
import { el } from '../dom';
import { humanise, number } from '../text';
import { FIGURES, sayWarning } from '../words';
import type { Sample } from './chart';

type Values = Record<string, unknown>;
const isObject = (value: unknown): value is Values => value !== null && typeof value === 'object' && !Array.isArray(value);

function text(value: unknown): string {
  if (value === null || value === undefined) return '—';
  if (typeof value === 'number') return number(value);
  if (typeof value === 'boolean') return value ? 'yes' : 'no';
  return String(value).replaceAll('_', ' ');
}

/** The figures that people look for first, by kind: `[path, label, unit]` with `u` for the request's unit. */
const KEY: Record<string, [string, string, string][]> = {
  minimal_surface: [['area', 'Area', 'u²'], ['triangles', 'Triangles', ''], ['residual', 'Residual', ''], ['stability.stable', 'Stable', ''], ['certificate.gap', 'Proven: above the least area by at most', '%']],
  ruled_surface: [['area', 'Area', 'u²'], ['convex_bridge_ratio', 'Convex bridges', '%'], ['bending_energy', 'Bending energy', ''], ['largest_fold_deg', 'Largest fold', '°']],
  uniform_mesh: [['nodes', 'Nodes', ''], ['edges', 'Members', ''], ['equal_edges', 'Equal members', ''], ['distinct_lengths', 'Distinct lengths', '']],
};

interface Figure { value: string; unit: string; name: string }
type Forced = { name: string; force: number; force_max: number; force_min: number; length: number; sag?: number };

const listOf = <T>(value: unknown): T[] => (Array.isArray(value) ? value as T[] : []);
const largest = (forces: { force: number[] }[]): number => Math.max(0, ...forces.map(({ force }) => Math.hypot(...force)));
const range = (values: number[]): string => {
  const [low, high] = [number(Math.min(...values), 3), number(Math.max(...values), 3)];
  return low === high ? low : `${low}–${high}`;
};
/** The service names a cable without a name by its number from 0. */
const cableName = (name: string, index: number): string => (name === String(index) ? `cable ${index + 1}` : name);

/** Forces and lengths of the members of a structure or a net, and forces of its supports. */
function forces(values: Values, unit: string): Figure[] {
  const force = String(values.force_unit ?? '');
  const found: Figure[] = [];
  const add = (name: string, value: number | null | undefined, of: string): void => {
    if (typeof value === 'number') found.push({ name, value: number(value, 4), unit: of });
  };
  const cables = listOf<Forced>(values.cables);
  if (cables.length > 0) {
    const sizes = cables.map(({ force_max: most }) => Math.abs(most));
    const index = sizes.indexOf(Math.max(...sizes));
    add(cables.length > 1 ? `Largest cable force: ${cableName(cables[index]!.name, index)}` : 'Cable force', cables[index]!.force_max, force);
  }
  const reactions = listOf<{ force: number[] }>(values.reactions);
  if (reactions.length > 0) add('Largest reaction', largest(reactions), force);
  if (cables.length > 0) found.push({ name: cables.length > 1 ? 'Cable lengths' : 'Cable length', value: range(cables.map(({ length }) => length)), unit });
  const masts = listOf<{ force: number }>(values.masts);
  if (masts.length > 0) add('Largest mast force', Math.max(...masts.map(({ force: own }) => Math.abs(own))), force);
  if (listOf(values.chambers).length > 0) {
    add('Pressure', values.pressure as number, `${force}/${unit}²`);
    add('Volume', values.volume as number | null, `${unit}³`);
  }
  const edges = listOf<{ force: number[] }>(values.edge_reactions);
  if (reactions.length === 0 && edges.length > 0) add('Largest reaction of a boundary', largest(edges), force);
  if (values.area) add('Area', values.area as number, `${unit}²`);
  if (values.load_path !== undefined) add('Load path', values.load_path as number, `${force} ${unit}`);
  return found;
}

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

const at = (values: Values, path: string): unknown => path.split('.').reduce<unknown>((value, step) => (value as Values | null | undefined)?.[step], values);

const isShown = (values: Values, path: string): boolean => at(values, path) !== undefined && at(values, path) !== null;

export function keyFigures(job: JobInfo, unit: string): HTMLElement[] {
  const values = job.statistics as Values;
  const figures = KEY[job.kind]?.filter(([path]) => isShown(values, path)).map(([path, name, of]): Figure => {
    const value = at(values, path);
    return { name, value: of === '%' && typeof value === 'number' ? number(100 * value, 3) : text(value), unit: of.replace('u', unit) };
  }) ?? forces(values, unit);
  const suffix = (of: string): string => (of === '' || of === '%' || of === '°' ? of : ` ${of}`);
  return figures.map(({ name, value, unit: of }) => el('div', { className: 'figure' }, el('span', { className: 'value' }, value, el('small', {}, suffix(of))), el('span', { className: 'name' }, name)));
}

/** The part between the headlines and the statistics. */
export const details = (job: JobInfo, unit: string): HTMLElement[] => (KEY[job.kind] ? [] : cableForces(job.statistics as Values, unit));

const FIRST = [
  'objective', 'objective_value', 'secondary_value', 'converged', 'stop_reason', 'residual', 'area', 'certificate', 'initial_area', 'nodes', 'vertices', 'triangles',
  'edges', 'bridges', 'stability', 'iterations', 'self_intersections', 'mean_curvature', 'edge_lengths', 'angles_deg',
];
const rank = ([name]: [string, unknown]): number => FIRST.indexOf(name) + 1 || FIRST.length + 1;
/** More numbers than this in one row are a histogram, which reads better folded up. */
const MOST_IN_A_ROW = 6;
const MOST_ROWS = 500;

/** Plain figures as one table; lists, and objects of many figures, as a table each, folded up. */
export function statistics(values: Values): HTMLElement[] {
  const rows: HTMLElement[] = [];
  const lists: HTMLElement[] = [];
  const visit = (name: string, value: unknown): void => {
    if (Array.isArray(value)) {
      if (value.length === 0) return;
      if (value.every(isObject)) lists.push(table(name.replaceAll('.', ' '), value));
      else if (value.length > MOST_IN_A_ROW) lists.push(folded(name.replaceAll('.', ' '), String(value.length), el('p', { className: 'numbers' }, value.map(text).join(' · '))));
      else rows.push(row(name, value.map(text).join(', ')));
    } else if (isObject(value)) {
      // The figures of an object stand below its name.
      if (!name.includes('.')) rows.push(el('tr', { className: 'group-name' }, el('th', { scope: 'colgroup', colSpan: 2 }, humanise(name.replace(/_deg$/, '')))));
      Object.entries(value).forEach(([inner, each]) => visit(`${name}.${inner}`, each));
    } else if (value !== undefined) rows.push(row(name, text(value)));
  };
  Object.entries(values).filter(([name]) => name !== 'comparison' && name !== 'history').sort((a, b) => rank(a) - rank(b)).forEach(([name, value]) => visit(name, value));
  return [el('table', { className: 'plain' }, el('tbody', {}, ...rows)), ...lists];
}

/** A text longer than this stands below its name, because the column of values is narrow. */
const LONG_TEXT = 60;
function row(path: string, value: string): HTMLElement {
  const [, ...inner] = path.split('.');
  const title = FIGURES[path] ?? humanise(inner.length > 0 ? inner.join(' ') : path);
  const className = inner.length > 0 ? 'inner' : '';
  if (value.length > LONG_TEXT) return el('tr', { className }, el('td', { className: 'long', colSpan: 2 }, el('span', {}, title), value));
  return el('tr', { className }, el('th', { scope: 'row' }, title), el('td', {}, value));
}

const folded = (name: string, of: string, inner: HTMLElement): HTMLElement =>
  el('details', {}, el('summary', {}, `${humanise(name)} (${of})`), el('div', { className: 'wide', tabIndex: 0, role: 'region', 'aria-label': humanise(name) }, inner));

function table(name: string, items: Values[]): HTMLElement {
  const flat = items.map((item) => flatten(item));
  const columns = [...new Set(flat.flatMap((item) => Object.keys(item)))];
  const head = el('tr', {}, ...columns.map((column) => el('th', { scope: 'col' }, humanise(column))));
  const body = flat.slice(0, MOST_ROWS).map((item) => el('tr', {}, ...columns.map((column) => el('td', {}, column in item ? text(item[column]) : ''))));
  const count = items.length > MOST_ROWS ? `first ${MOST_ROWS} of ${items.length}` : String(items.length);
  return folded(name, count, el('table', {}, el('thead', {}, head), el('tbody', {}, ...body)));
}

function flatten(item: Values, prefix = ''): Values {
  return Object.entries(item).reduce<Values>((out, [name, value]) => {
    if (isObject(value)) return { ...out, ...flatten(value, `${prefix}${name} `) };
    return { ...out, [prefix + name]: Array.isArray(value) ? value.map(text).join(', ') : value };
  }, {});
}

/** Each warning once, in the page's own words, which count from 1. */
export const warnings = (list: JobInfo['warnings'], unit: string): HTMLElement[] => (list ?? []).map(({ code, values, detail }) => {
  const said = sayWarning(code, values, detail, unit);
  return el('div', { className: 'warning', 'data-code': code }, el('strong', {}, humanise(code)), said.sentence,
    said.detail !== null && el('details', {}, el('summary', {}, 'In the words of the service, which counts from 0'), said.detail));
});

export const samplesOf = (rows: HistoryRow[] | undefined | null): Sample[] =>
  (rows ?? []).map((each) => ({ iteration: each.iteration, phase: each.phase, value: each.area ?? null, residual: each.residual ?? null }));
