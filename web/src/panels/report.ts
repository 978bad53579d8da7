// A finished job's statistics, warnings and history.

import type { HistoryRow, JobInfo } from 'plateau-client';
import { el } from '../dom';
import { humanise, number, sentence } from '../text';
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
  cable_net: [['edges', 'Edges', ''], ['load_path', 'Load path', ''], ['balance.imbalance', 'Force imbalance', ''], ['objective_value', 'Loss', '']],
  tensile_structure: [['area', 'Area', 'u²'], ['pressure', 'Pressure', ''], ['balance.imbalance', 'Force imbalance', ''], ['stress.deviation', 'Stress deviation', '']],
};

const at = (values: Values, path: string): unknown => path.split('.').reduce<unknown>((value, step) => (value as Values | null | undefined)?.[step], values);

const isShown = (values: Values, path: string): boolean => at(values, path) !== undefined && at(values, path) !== null;

export function keyFigures(job: JobInfo, unit: string): HTMLElement[] {
  const values = job.statistics as Values;
  return (KEY[job.kind] ?? []).filter(([path]) => isShown(values, path)).map(([path, label, of]) => {
    const value = at(values, path);
    const shown = of === '%' && typeof value === 'number' ? number(100 * value, 3) : text(value);
    const suffix = of === '' ? '' : of === '%' || of === '°' ? of : ` ${of.replace('u', unit)}`;
    return el('div', { className: 'figure' }, el('span', { className: 'value' }, shown, el('small', {}, suffix)), el('span', { className: 'name' }, label));
  });
}

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
      if (value.every(isObject)) lists.push(table(name, value));
      else if (value.length > MOST_IN_A_ROW) lists.push(folded(name, String(value.length), el('p', { className: 'numbers' }, value.map(text).join(' · '))));
      else rows.push(row(name, value.map(text).join(', ')));
    } else if (isObject(value)) {
      Object.entries(value).forEach(([inner, each]) => visit(`${name} ${inner}`, each));
    } else if (value !== undefined) rows.push(row(name, text(value)));
  };
  Object.entries(values).filter(([name]) => name !== 'comparison' && name !== 'history').sort((a, b) => rank(a) - rank(b)).forEach(([name, value]) => visit(name, value));
  return [el('table', { className: 'plain' }, el('tbody', {}, ...rows)), ...lists];
}

/** A text longer than this stands below its name, because the column of values is narrow. */
const LONG_TEXT = 60;
function row(name: string, value: string): HTMLElement {
  const title = humanise(name.replace(/_deg (.*)$/, ' $1_deg'));
  if (value.length > LONG_TEXT) return el('tr', {}, el('td', { className: 'long', colSpan: 2 }, el('span', {}, title), value));
  return el('tr', {}, el('th', { scope: 'row' }, title), el('td', {}, value));
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

/** Each warning once, in words that count from 1. */
export const warnings = (list: JobInfo['warnings']): HTMLElement[] =>
  (list ?? []).map(({ code, detail }) => el('p', { className: 'warning' }, el('strong', {}, humanise(code)), ` ${sentence(detail)}`));

export const samplesOf = (rows: HistoryRow[] | undefined | null): Sample[] =>
  (rows ?? []).map((each) => ({ iteration: each.iteration, phase: each.phase, value: each.area ?? null, residual: each.residual ?? null }));
