// The cable that was clicked: what it holds constant, and how much.

import { $, el } from '../dom';
import { type Cable, likelyValue } from '../model/cables';
import { type Request, unitOf } from '../model/request';
import { humanise } from '../text';

/** The unit of each mode's value, of the units of force and of length. */
const UNITS: Record<string, (force: string, length: string) => string> = {
  force: (force) => force, end_tension: (force) => force, horizontal_component: (force) => force,
  force_density: (force, length) => `${force}/${length}`,
  length: (_, length) => length, unstressed_length: (_, length) => length, sag: (_, length) => length,
};

/** Figures of a cable in the result, by which a value keeps the shape when the mode changes. */
export interface Found { force: number; force_max: number; length: number; unstressed_length: number | null; sag: number }

export const forceUnit = (request: Request): string => (request.units as { force?: string } | undefined)?.force ?? 'kN';

/** The modes that the service offers, with what each holds constant. */
export type Modes = { name: string; help: string | undefined }[];

export const unitOfMode = (request: Request, mode: string): string => UNITS[mode]?.(forceUnit(request), unitOf(request)) ?? '';

export function showCable(request: Request, cable: Cable | undefined, number: number, modes: Modes): void {
  if (!cable) return;
  const mode = cable.mode ?? 'force';
  $('cable-name').textContent = cable.name ?? `Cable ${number + 1}`;
  const select = $<HTMLSelectElement>('cable-mode');
  select.replaceChildren(...modes.map(({ name, help }) => el('option', { value: name, title: help ?? '' }, humanise(name))));
  select.value = mode;
  $('cable-unit').textContent = unitOfMode(request, mode);
  $('stiffness-unit').textContent = forceUnit(request);
  for (const [id, value] of [['cable-value', cable.value], ['cable-stiffness', cable.axial_stiffness ?? '']] as const) {
    const input = $<HTMLInputElement>(id);
    if (document.activeElement !== input || !input.dataset.dirty) input.value = String(value);
  }
}

/** Changes what a cable holds constant, to the value that it has in the result, if that is known. */
export function changeMode(request: Request, cable: Cable, mode: string, found: Found | undefined): void {
  const digits = (value: number): number => Number(value.toPrecision(6));
  const values: Record<string, number | null | undefined> = found
    ? {
      force: found.force, end_tension: found.force, horizontal_component: found.force, force_density: found.force / found.length,
      length: found.length, unstressed_length: found.unstressed_length, sag: found.sag,
    } : {};
  cable.mode = mode;
  const value = values[mode];
  if (value) cable.value = digits(value);
  else if (cable.along) cable.value = likelyValue(request, cable.along, mode);
  if (mode === 'unstressed_length' && !cable.axial_stiffness) {
    // A stiff cable: it stretches by a hundredth.
    cable.axial_stiffness = digits(100 * (found?.force ?? (cable.along ? likelyValue(request, cable.along, 'force') : 1)));
    if (found) cable.value = digits(found.length / (1 + found.force / cable.axial_stiffness));
  }
}
