// The tables of a structure's cables and masts.

import { el } from '../dom';
import { type Cable, cablesOf } from '../model/cables';
import { type Request, unitOf } from '../model/request';
import { type Mast, mastsOf } from '../model/rigging';
import { humanise, typed } from '../text';
import { changeMode, forceUnit, type Found, type Modes, unitOfMode } from './cable';

/** Maximum number of cables in the table, because each has controls that are made anew with the form. */
const MOST_ROWS = 40;

export interface TableHost {
  modes: Modes;
  found(cable: number): Found | undefined;
  /** A mast in the result. */
  foundMast(mast: number): { length: number; force: number } | undefined;
  /** Changes the request, as one step of undo. */
  edit(change: (request: Request) => void): void;
  choose(cable: number): void;
  chooseMast(mast: number): void;
  /** Hangs every edge without a cable on one; null where no cables can be drawn. */
  hangAll: (() => void) | null;
}

/** A value as its field shows it; the request keeps its digits. */
const short = (value: number): string => String(Number(value.toPrecision(5)));

const heads = (first: string): HTMLElement => el('tr', {}, ...[first, 'holds', 'at'].map((each) => el('th', { scope: 'col', colSpan: each === 'at' ? 2 : 1 }, each)));

/** Cables above masts, in one table, so that their columns are in line. */
const table = (cables: HTMLElement[], masts: HTMLElement[]): HTMLElement =>
  el('table', {}, el('thead', {}, heads(cables.length > 0 ? 'Cable' : 'Mast')), el('tbody', {}, ...cables), el('tbody', {}, cables.length > 0 && masts.length > 0 && heads('Mast'), ...masts));

/** A mast: whether it holds its length or the force with which it pushes, and how much. */
function mastRow(request: Request, { name: own, mode = 'length', value }: Mast, i: number, host: TableHost): HTMLElement {
  const name = own ?? `Mast ${i + 1}`;
  const select = el('select', { 'aria-label': `${name} holds` }, ...['length', 'force'].map((each) => el('option', { value: each, selected: each === mode }, humanise(each))));
  const input = el('input', { type: 'text', inputMode: 'decimal', 'aria-label': `${name}, value`, value: short(value) });
  const unit = el('small', {}, mode === 'force' ? forceUnit(request) : unitOf(request));
  select.addEventListener('change', () => {
    unit.textContent = select.value === 'force' ? forceUnit(request) : unitOf(request);
    const held = host.foundMast(i)?.[select.value as 'length' | 'force'];
    const now = held && held > 0 ? Number(held.toPrecision(6)) : typed(input.value);
    input.value = short(now);
    host.edit((of) => Object.assign(mastsOf(of)[i]!, { mode: select.value, value: now }));
  });
  input.addEventListener('change', () => {
    if (typed(input.value) > 0) host.edit((of) => { mastsOf(of)[i]!.value = typed(input.value); });
    else input.value = short(value);
  });
  return el('tr', {}, el('th', { scope: 'row' }, el('button', { type: 'button', title: name, onclick: () => host.chooseMast(i) }, name)), el('td', {}, select), el('td', {}, input), el('td', {}, unit));
}

/**
 * The cables of a structure: what each holds constant, and how much. A press on a name shows the cable on the stage.
 */
export function cableTable(request: Request, cables: Cable[], host: TableHost): HTMLElement {
  const row = (cable: Cable, i: number): HTMLElement => {
    const name = cable.name ?? `Cable ${i + 1}`;
    const select = el('select', { 'aria-label': `${name} holds` }, ...host.modes.map(({ name: mode, help }) => el('option', { value: mode, title: help ?? '' }, humanise(mode))));
    const input = el('input', { type: 'text', inputMode: 'decimal', 'aria-label': `${name}, value` });
    const unit = el('small', {});
    const show = (now: Cable): void => {
      select.value = now.mode ?? 'force';
      input.value = short(now.value);
      unit.textContent = unitOfMode(request, select.value);
    };
    let own = cable;
    const edit = (change: (changed: Cable, of: Request) => void): void => host.edit((of) => {
      own = cablesOf(of)[i]!;
      change(own, of);
    });
    select.addEventListener('change', () => {
      edit((changed, of) => changeMode(of, changed, select.value, host.found(i)));
      show(own);
    });
    input.addEventListener('change', () => {
      const value = typed(input.value);
      if (value > 0) edit((changed) => { changed.value = value; });
      show(own);
    });
    show(cable);
    return el('tr', {}, el('th', { scope: 'row' }, el('button', { type: 'button', title: name, onclick: () => host.choose(i) }, cable.name ?? String(i + 1))), el('td', {}, select), el('td', {}, input), el('td', {}, unit));
  };
  const rows = cables.slice(0, MOST_ROWS).map(row);
  const more = cables.length - rows.length;
  const masts = mastsOf(request).slice(0, MOST_ROWS).map((mast, i) => mastRow(request, mast, i, host));
  return el('div', { id: 'cables' },
    el('h2', {}, cables.length === 0 ? 'No cables' : 'Cables'),
    rows.length + masts.length > 0 && table(rows, masts),
    more > 0 && el('p', { className: 'help' }, `and ${more} more cables: press one on the stage to change it.`),
    host.hangAll && el('button', { type: 'button', id: 'hang-all', onclick: host.hangAll }, 'Hang every edge on a cable'));
}
