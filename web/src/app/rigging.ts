// Placing parts of a tensile structure by presses: cables along edges and across the film, masts, stays and supports.

import { $, el } from '../dom';
import type { Request } from '../model/request';
import { addMast, addRidge, addStay, type Corner, hold, isFree } from '../model/rigging';
import type { Host, Tools } from '../stage/tools';
import { changed } from './document';
import { showDock } from './drawing';
import { announce, toast } from './notes';
import { doc, history, host, stage, tools } from './session';

const RIGS: { rig: Tools['rig']; label: string; hint: string; then?: string }[] = [
  { rig: 'edge', label: 'Edge cable', hint: 'an edge of the boundary to hang it on a cable, or a point and then another for a cable along several edges.' },
  { rig: 'ridge', label: 'Ridge', hint: 'the point where the ridge cable begins.', then: 'the point where it ends, across the film.' },
  { rig: 'mast', label: 'Mast', hint: 'a raised corner: a mast stands below it, with two stays.' },
  { rig: 'stay', label: 'Stay', hint: 'the corner that the stay holds.', then: 'the ground where the stay ends, or the corner again.' },
  { rig: 'hold', label: 'Support', hint: 'a corner to free it of its support, or a free one to hold it.' },
];

/** The buttons that choose what is placed. */
const buttons = RIGS.map(({ rig, label }) => el('button', { type: 'button', 'data-rig': rig, onclick: () => choose(rig) }, label));
const group = el('div', { id: 'rigs', className: 'group', role: 'group', 'aria-label': 'What to place', hidden: true }, ...buttons);

function choose(rig: Tools['rig']): void {
  tools.startCabling(rig);
  stage.canvas.focus({ preventScroll: true });
}

/** Shows what is placed, while something is. */
export function showRigs(): void {
  if (!group.isConnected) $('cabling').parentElement!.after(group);
  group.hidden = !tools.cabling;
  for (const button of buttons) button.setAttribute('aria-pressed', String(button.dataset.rig === tools.rig));
}

const byTouch = matchMedia('(pointer: coarse)').matches;

/** What to press next. */
export function hintOfRig(): string {
  const { hint, then } = RIGS.find(({ rig }) => rig === tools.rig)!;
  return `${byTouch ? 'Tap' : 'Click'} ${tools.hasBegun && then ? then : hint}`;
}

/** Places what was chosen at a corner, or between it and another place. */
export const placeRig: Host['rig'] = (from, to, place) => {
  if (!from) {
    toast('Press a point of the boundary.');
    return;
  }
  const name = (corner: Corner): string => `${host.lines[corner.line]!.name}, point ${corner.point + 1}`;
  let fault: string | null = null;
  const put = (change: (request: Request) => string | null): boolean => history.edit(({ request }) => { fault = change(request); });
  const told: Record<string, () => string> = {
    mast: () => (put((request) => addMast(request, from)) ? `A mast with two stays at ${name(from)}` : ''),
    stay: () => (put((request) => addStay(request, from, place)) ? `A stay at ${name(from)}` : ''),
    ridge: () => (to && put((request) => addRidge(request, from, to)) ? `A ridge cable from ${name(from)} to ${name(to)}` : ''),
    hold: () => (put((request) => { hold(request, from); return null; }) ? `${name(from)} is ${isFree(doc().request, from) ? 'free' : 'a support'}` : ''),
  };
  const text = told[tools.rig]?.() ?? '';
  if (fault) toast(fault);
  if (text === '') {
    showDock();
    return;
  }
  changed({ edited: true });
  announce(text);
};
