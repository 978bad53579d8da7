// Short texts: the line of state, a note that passes, and a text beside a pixel of the stage.

import { $, el } from '../dom';
import { unitOf, type Vec3 } from '../model/request';
import { reading } from '../stage/quantities';
import { number } from '../text';
import { doc, host, session, stage, surface } from './session';

const TOAST_MS = 7000;

export const say = (text: string): void => { $('status').textContent = text; };
export const announce = (text: string): void => { $('announcement').textContent = text; };

/** Brings one of the two panels to the front where there is room for one only. */
export function showPanel(name: string): void {
  document.querySelector('main')!.dataset.panel = name;
  for (const button of document.querySelectorAll<HTMLElement>('[data-panel]:is(button)')) button.setAttribute('aria-pressed', String(button.dataset.panel === name));
}

let toastTimer = 0;
export function toast(text: string): void {
  $('toast').textContent = text;
  $('toast').hidden = false;
  clearTimeout(toastTimer);
  toastTimer = window.setTimeout(() => { $('toast').hidden = true; }, TOAST_MS);
}

let labelled: { text: string; x: number; y: number; anchor: Vec3 | null; reading: boolean } | null = null;

/** A text beside a pixel, or beside a point of the scene wherever that is seen; null for none. */
export function label(text: string | null, x = 0, y = 0, anchor: Vec3 | null = null, reading = false): void {
  labelled = text === null ? null : { text, x, y, anchor, reading };
  placeLabel();
}

/** Takes the value of an earlier result away. What a tool says of a point stays while its film changes. */
export function dropReading(): void {
  if (labelled?.reading) label(null);
}

export function placeLabel(): void {
  const box = $('label');
  box.hidden = labelled === null;
  if (!labelled) return;
  const { text, anchor } = labelled;
  const { x, y } = anchor ? stage.project(anchor) : labelled;
  box.textContent = text;
  const left = Math.min(Math.max(x + 14, 6), stage.width - box.offsetWidth - 6);
  const top = Math.min(Math.max(y - 30, 6), stage.height - 30);
  box.style.transform = `translate(${Math.round(left)}px, ${Math.round(top)}px)`;
}

/** Widest scale bar, in pixels. */
const WIDEST = 130;
const bar = el('p', { id: 'scale-line', 'aria-hidden': 'true' });

/** A bar of a round length, as it is seen in the middle of the model. */
export function placeScale(): void {
  if (!bar.isConnected) $('stage').append(bar);
  const pixel = host.frame.length(stage.pixelAt(stage.centre));
  const step = 10 ** Math.floor(Math.log10(WIDEST * pixel));
  const length = [5, 2, 1].map((digit) => digit * step).find((each) => each <= WIDEST * pixel) ?? step;
  bar.hidden = session.mode !== 'model' || !Number.isFinite(length);
  const text = `${number(length)} ${unitOf(doc().request)}`;
  if (bar.textContent !== text) bar.textContent = text;
  bar.style.width = `${(length / pixel).toFixed(1)}px`;
  // It stands above the legend where there is no room beside it.
  const look = $('look');
  bar.style.bottom = `${look.offsetWidth + WIDEST + 40 > stage.width ? look.offsetHeight + 20 : 14}px`;
}

/**
 * Sizes that are shown on the model, at their places, and places without a text that are seen with them. `app/box`
 * names the function, which comes after the first film.
 */
export const measures = { of: (): { tip: Vec3; text: string }[] => [] };
/** Texts beside the tips of the reactions' arrows, and sizes. */
let tags: { anchor: Vec3; box: HTMLElement }[] = [];
let places: Vec3[] = [];

/** Labels the arrows that are shown. */
export function tagReactions(): void {
  tags.forEach(({ box }) => box.remove());
  const all = [...surface.reactions(), ...measures.of()];
  places = all.map(({ tip }) => tip);
  tags = all.filter(({ text }) => text !== '').map(({ tip, text }) => ({ anchor: tip, box: el('p', { className: 'tag' }, text) }));
  $('stage').append(...tags.map(({ box }) => box));
  placeTags();
}

/** Places that are to be seen with the model. */
export const tips = (): Vec3[] => places;

/** A label that would lie on that of a larger force is left out. */
export function placeTags(): void {
  const taken: { x: number; y: number }[] = [];
  for (const { anchor, box } of tags) {
    const { x, y, visible } = stage.project(anchor);
    box.hidden = session.mode !== 'model' || !visible || taken.some((other) => Math.abs(other.x - x) < 62 && Math.abs(other.y - y) < 20);
    if (box.hidden) continue;
    taken.push({ x, y });
    const left = Math.max(4, Math.min(x + 6, stage.width - box.offsetWidth - 4));
    box.style.transform = `translate(${Math.round(left)}px, ${Math.round(y - 10)}px)`;
  }
}

/** Says beside a point of the surface what it is there: the value of the quantity shown, else the coordinates. */
export const readSurface: typeof host.read = (point, face, x, y) => {
  const value = surface.valueAt(point, face);
  const where = host.frame.fromScene(point.toArray()).map((each) => number(each, 5)).join(', ');
  label(session.quantity && value !== null ? reading(session.quantity, value) : where, x, y, point.toArray(), true);
};

/** Says beside a point of a line what its value is. */
export const readLine: typeof host.readLine = (point, value, x, y) => label(value, x, y, point.toArray(), true);
