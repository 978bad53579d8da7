// The table of a structure's cables.

import { el } from '../dom';
import type { Cable } from '../model/cables';
import type { Request } from '../model/request';
import { humanise, typed } from '../text';
import { changeMode, type Found, type Modes, unitOfMode } from './cable';

/** Maximum number of cables in the table, because each has controls that are made anew with the form. */
const MOST_ROWS = 40;

export interface TableHost {
  modes: Modes;
  found(cable: number): Found | undefined;
  /** Changes a cable, as one step of undo. */
  edit(cable: number, change: (cable: Cable, request: Request) => void): void;
  choose(cable: number): void;
  /** Hangs every edge without a cable on one; null where no cables can be drawn. */
  hangAll: (() => void) | null;
}

/** The cables of a structure: what each holds constant, and how much. A press on a name shows the cable on the stage. */
export function cableTable(request: Request, cables: Cable[], host: TableHost): HTMLElement {
  const row = (cable: Cable, i: number): HTMLElement => {
    const name = cable.name ?? `Cable ${i + 1}`;
    const select = el('select', { 'aria-label': `${name} holds` }, ...host.modes.map(({ name: mode, help }) => el('option', { value: mode, title: help ?? '' }, humanise(mode))));
    const input = el('input', { type: 'text', inputMode: 'decimal', 'aria-label': `${name}, value` });
    const unit = el('small', {});
    const show = (now: Cable): void => {
      select.value = now.mode ?? 'force';
      input.value = String(now.value);
      unit.textContent = unitOfMode(request, select.value);
    };
    let own = cable;
    const edit = (change: (changed: Cable, of: Request) => void): void => host.edit(i, (changed, of) => {
      change(changed, of);
      own = changed;
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
  return el('div', { id: 'cables' },
    el('h2', {}, cables.length === 0 ? 'No cables' : 'Cables'),
    rows.length > 0 && el('table', {}, el('thead', {}, el('tr', {}, ...['Cable', 'holds', 'at'].map((head) => el('th', { scope: 'col', colSpan: head === 'at' ? 2 : 1 }, head)))), el('tbody', {}, ...rows)),
    more > 0 && el('p', { className: 'help' }, `and ${more} more: press one on the stage to change it.`),
    host.hangAll && el('button', { type: 'button', id: 'hang-all', onclick: host.hangAll }, 'Hang every edge on a cable'));
}
