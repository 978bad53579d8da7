// A finished job's statistics, warnings and history, as tables.

import { element, humanise, number, svg } from './dom.js';

const isObject = (value) => value !== null && typeof value === 'object' && !Array.isArray(value);

function text(value) {
  if (value === null) return '—';
  if (typeof value === 'number') return number(value);
  if (typeof value === 'boolean') return value ? 'yes' : 'no';
  return String(value).replaceAll('_', ' ');
}

/** What people look for first, in this order; the rest follows as it comes. */
const FIRST = [
  'objective', 'objective_value', 'secondary_value', 'converged', 'stop_reason', 'residual', 'area', 'initial_area', 'nodes', 'vertices',
  'triangles', 'edges', 'bridges', 'stability', 'iterations', 'mean_curvature', 'edge_lengths', 'angles_deg',
];
const rank = ([name]) => FIRST.indexOf(name) + 1 || FIRST.length + 1;

/** Plain figures as one table, lists of objects as a table each, folded up. */
export function statistics(values) {
  const rows = [];
  const lists = [];
  const visit = (name, value) => {
    if (Array.isArray(value)) {
      if (value.length > 0 && value.every(isObject)) lists.push(table(name, value));
      else if (value.length > 0) rows.push(row(name, value.map(text).join(', ')));
    } else if (isObject(value)) {
      Object.entries(value).forEach(([inner, each]) => visit(`${name} ${inner}`, each));
    } else {
      rows.push(row(name, text(value)));
    }
  };
  Object.entries(values).sort((a, b) => rank(a) - rank(b)).forEach(([name, value]) => visit(name, value));
  return [element('table', {}, element('tbody', {}, ...rows)), ...lists];
}

function row(name, value) {
  return element('tr', {}, element('th', { scope: 'row' }, humanise(name.replace(/_deg (.*)$/, ' $1_deg'))), element('td', {}, value));
}

function table(name, items) {
  const flat = items.map((item) => flatten(item));
  const columns = [...new Set(flat.flatMap((item) => Object.keys(item)))];
  const head = element('tr', {}, ...columns.map((column) => element('th', { scope: 'col' }, humanise(column))));
  const body = flat.slice(0, 500).map((item) => element('tr', {}, ...columns.map((column) => element('td', {}, column in item ? text(item[column]) : ''))));
  const count = items.length > 500 ? `first 500 of ${items.length}` : items.length;
  return element(
    'details', {}, element('summary', {}, `${humanise(name)} (${count})`),
    element('div', { className: 'wide' }, element('table', {}, element('thead', {}, head), element('tbody', {}, ...body))),
  );
}

function flatten(item, prefix = '') {
  return Object.entries(item).reduce((out, [name, value]) => {
    if (isObject(value)) return { ...out, ...flatten(value, `${prefix}${name} `) };
    return { ...out, [prefix + name]: Array.isArray(value) ? value.map(text).join(', ') : value };
  }, {});
}

export function warnings(list) {
  return list.map(({ code, detail }) => element('p', { className: 'warning' }, element('strong', {}, humanise(code)), `: ${detail}`));
}

/** The residual from iteration to iteration, on a logarithmic scale, with the tolerance as a dashed line. */
export function history(rows, tolerance) {
  const values = (rows ?? []).map(({ residual }) => residual).filter((value) => value > 0);
  if (values.length < 3) return [];
  const logs = values.map(Math.log10);
  const floor = tolerance > 0 ? Math.log10(tolerance) : null;
  const low = Math.min(...logs, floor ?? Infinity), high = Math.max(...logs);
  const y = (log) => (high > low ? (100 * (high - log)) / (high - low) : 50);
  const path = logs.map((log, i) => `${i ? 'L' : 'M'}${(300 * i) / (logs.length - 1)},${y(log).toFixed(2)}`).join('');
  const label = `Residual over ${values.length} iterations, from ${number(values[0])} to ${number(values.at(-1))}`;
  const chart = svg('svg', { viewBox: '0 -3 300 106', preserveAspectRatio: 'none', role: 'img', 'aria-label': label }, svg('path', { d: path }));
  if (floor !== null) chart.append(svg('path', { class: 'floor', d: `M0,${y(floor).toFixed(2)}H300` }));
  return [element('p', { className: 'hint' }, label), chart];
}
