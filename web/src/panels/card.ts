// The card above the options: what was found in a file, with what can be chosen of it, or a question about the drawing.

import { $, el } from '../dom';

interface Choice { unit: string; layers: Set<string>; up: 'y' | 'z'; local: boolean }
export interface Import {
  title: string; found: string; size: string;
  /** Whether the file does not say its unit. */
  asks: boolean;
  units: { value: string; text: string }[]; unit: string;
  layers: { layer: string; lines: number; taken: boolean }[];
  up: 'y' | 'z';
  /** Whether the drawing is moved near zero; null if it lies there. */
  local: boolean | null;
  notes: string[];
}
interface Acts<C> { change(change: (choice: C) => void): void; undo(): void; close(): void }

/** The card's element, which stands above the options. */
function card(label: string): HTMLElement {
  const found = document.getElementById('card') ?? el('section', { id: 'card' });
  if (!found.isConnected) $('sheet').prepend(found);
  found.setAttribute('aria-label', label);
  found.hidden = false;
  return found;
}

export function hideCard(): void {
  const found = document.getElementById('card');
  if (found) found.hidden = true;
}

export function showImport<C extends Choice>(found: Import, { change, undo, close }: Acts<C>): void {
  const box = card('Import');
  const focused = (document.activeElement as HTMLElement | null)?.dataset.field;
  const units = el('select', { 'data-field': 'unit' }, ...found.units.map(({ value, text }) => el('option', { value, selected: value === found.unit }, text)));
  units.addEventListener('change', () => change((choice) => { choice.unit = units.value as C['unit']; }));
  const up = el('select', { 'data-field': 'up' }, ...(['z', 'y'] as const).map((axis) => el('option', { value: axis, selected: axis === found.up }, axis)));
  up.addEventListener('change', () => change((choice) => { choice.up = up.value as 'y' | 'z'; }));
  const check = (field: string, text: string, checked: boolean, set: (choice: C, on: boolean) => void): HTMLElement => {
    const box = el('input', { type: 'checkbox', checked, 'data-field': field });
    box.addEventListener('change', () => change((choice) => set(choice, box.checked)));
    return el('label', { className: 'check' }, box, text);
  };
  box.replaceChildren(
    el('h2', {}, found.title),
    el('p', { className: 'size' }, found.size),
    el('p', { className: 'quiet small' }, found.found),
    ...found.notes.map((note) => el('p', { className: 'quiet small' }, note)),
    found.asks ? el('p', { className: 'asks', role: 'alert' }, 'The file does not say its unit. Which size is right?') : '',
    el('label', { className: 'stacked' }, found.asks ? 'Unit' : 'Unit, as the file says', units),
    found.layers.length > 1 ? el('fieldset', { className: 'layers' }, el('legend', {}, 'Layers'), ...found.layers.map(({ layer, lines, taken }) =>
      check(`layer ${layer}`, `${layer === '' ? 'without a name' : layer} (${lines})`, taken, ({ layers }, on) => { if (on) layers.add(layer); else layers.delete(layer); }))) : '',
    el('label', { className: 'field' }, el('span', {}, 'Up axis'), up),
    found.local === null ? '' : check('local', 'Move to a local origin', found.local, (choice, on) => { choice.local = on; }),
    el('div', { className: 'row' }, el('button', { type: 'button', className: 'primary', onclick: close }, 'Done'), el('button', { type: 'button', onclick: undo }, 'Undo')),
  );
  if (focused !== undefined) box.querySelector<HTMLElement>(`[data-field="${CSS.escape(focused)}"]`)?.focus();
}

export function showQuestion(text: string, answers: { text: string; primary: boolean; act(): void }[]): void {
  card('Question').replaceChildren(el('p', { className: 'asks', role: 'alert' }, text), ...answers.map(({ text: name, primary, act }) => el('button', { type: 'button', className: primary ? 'primary' : '', onclick: act }, name)));
}
