// The figures that people look for first: the size of the model, then forces or counts of its kind.

import type { JobInfo } from 'plateau-client';
import { el } from '../dom';
import { number } from '../text';

export type Values = Record<string, unknown>;

export function text(value: unknown): string {
  if (value === null || value === undefined) return '—';
  if (typeof value === 'number') return number(value);
  if (typeof value === 'boolean') return value ? 'yes' : 'no';
  return String(value).replaceAll('_', ' ');
}

/** The figures that people look for first, by kind: `[path, label, unit]` with `u` for the request's unit. */
const KEY: Record<string, [string, string, string][]> = {
  minimal_surface: [['area', 'Area', 'u²'], ['certificate.gap', 'Proven: above the least area by at most', '%']],
  ruled_surface: [['area', 'Area', 'u²'], ['convex_bridge_ratio', 'Convex bridges', '%'], ['largest_fold_deg', 'Largest fold', '°']],
  uniform_mesh: [['edges', 'Members', ''], ['nodes', 'Nodes', ''], ['equal_edges', 'Equal members', ''], ['distinct_lengths', 'Distinct lengths', '']],
};

interface Figure { value: string; unit: string; name: string }
export type Forced = { name: string; force: number; force_max: number; force_min: number; length: number; sag?: number };

export const listOf = <T>(value: unknown): T[] => (Array.isArray(value) ? value as T[] : []);
const largest = (forces: { force: number[] }[]): number => Math.max(0, ...forces.map(({ force }) => Math.hypot(...force)));
const range = (values: number[]): string => {
  const [low, high] = [number(Math.min(...values), 3), number(Math.max(...values), 3)];
  return low === high ? low : `${low}–${high}`;
};
/** The service names a cable without a name by its number from 0. */
export const cableName = (name: string, index: number): string => (name === String(index) ? `cable ${index + 1}` : name);

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

const at = (values: Values, path: string): unknown => path.split('.').reduce<unknown>((value, step) => (value as Values | null | undefined)?.[step], values);

const isShown = (values: Values, path: string): boolean => at(values, path) !== undefined && at(values, path) !== null;

/** The span and the rise of a model of this extent. */
function sizeOf([x, rise, z]: [number, number, number], unit: string): Figure[] {
  const across = [x, z].sort((a, b) => b - a).map((value) => number(Number(value.toPrecision(3)), 3));
  const flat = !(rise > 1e-6 * Math.max(x, z));
  return [{ name: 'Span', value: across.join(' × '), unit }, { name: 'Rise', value: flat ? '0' : number(Number(rise.toPrecision(3)), 3), unit }];
}

/** `size`: the model's extent along x, up and z. */
export function keyFigures(job: JobInfo, unit: string, size: [number, number, number]): HTMLElement[] {
  const values = job.statistics as Values;
  const figures = KEY[job.kind]?.filter(([path]) => isShown(values, path)).map(([path, name, of]): Figure => {
    const value = at(values, path);
    return { name, value: of === '%' && typeof value === 'number' ? number(100 * value, 3) : typeof value === 'number' ? number(value, 4) : text(value), unit: of.replace('u', unit) };
  }) ?? forces(values, unit);
  const suffix = (of: string): string => (of === '' || of === '%' || of === '°' ? of : ` ${of}`);
  return [...sizeOf(size, unit), ...figures].map(({ name, value, unit: of }) => el('div', { className: 'figure' }, el('span', { className: 'value' }, value, el('small', {}, suffix(of))), el('span', { className: 'name' }, name)));
}

