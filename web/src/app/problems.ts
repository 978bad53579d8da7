// Problems are told once, counted from 1, and marked in the drawing. The late answer to an earlier
// request neither hides nor replaces a newer problem.

import { ConnectionFailed, type FieldError, Unauthorized } from 'plateau-client';
import { hasKey } from '../api';
import { $, el } from '../dom';
import { findings } from '../model/checks';
import { type Remedy, remedyFor } from '../model/remedies';
import { place } from '../model/request';
import { capital } from '../text';
import { FAILURES, fromOne } from '../failures';
import { ask } from './busy';
import { redraw } from './drawing';
import { say, showPanel } from './notes';
import { doc, host, later, session, tools } from './session';

interface Fault { type?: string; title?: string; detail?: string; message?: string; errors?: readonly FieldError[] | null; errorsOmitted?: boolean }

/**
 * Changes the request as a remedy says, and solves it. main.ts names the function, because it stands above this module.
 */
export const repair = { by: (_: Remedy): void => {} };

/** The newest of what was asked for that was answered. */
let answered = 0;

/** Whether an answer is not a late one. */
function counts(turn: number): boolean {
  if (turn < answered) return false;
  answered = turn;
  return true;
}

/** Hides the problem of something earlier. `turn` is the number of what is answered without one. */
export function hideProblem(turn = ask()): void {
  if (!counts(turn)) return;
  $('problem').hidden = true;
  if (session.serverFaulty.size === 0) return;
  session.serverFaulty = new Set();
  redraw();
}

export const KEY_REFUSED = 'This server does not take this key. Copy it again, or ask whoever runs the server for another one.';

/** Asks for a key where it is typed. */
function askForKey(): void {
  $('key-fault').textContent = hasKey() ? KEY_REFUSED : 'This server asks for a key. Type the one that you were given.';
  $('key-fault').hidden = false;
  const dialog = $<HTMLDialogElement>('settings');
  if (!dialog.open) dialog.showModal();
  $('api-key').focus();
}

/** A problem document, a failed job's error, or a defect of this page: what is wrong, and where. */
export function showProblem(fault: unknown, turn = ask()): void {
  if (!counts(turn)) return;
  if (fault instanceof Unauthorized) {
    askForKey();
    return;
  }
  const { type, title, detail, message, errors, errorsOmitted } = fault instanceof ConnectionFailed ? unreached(fault) : fault as Fault;
  const list = errors ?? [];
  const faulty = new Set<string>();
  const own = findings(host.lines);
  const items = list.flatMap((error) => {
    const found = place(host.lines, error.pointer);
    // The page says the faults that it sees itself in its own words, which count from 1.
    const seen = found.line !== undefined && own.some(({ line, points }) => line === found.line && (found.point === undefined || points.includes(found.point)));
    if (seen) return [];
    if (found.line !== undefined && found.point !== undefined && found.point >= 0) faulty.add(`${found.line}/${found.point}`);
    const control = found.line === undefined ? $<HTMLFormElement>('options').querySelector<HTMLElement>(`[name="${CSS.escape(found.field ?? '')}"], [name^="${CSS.escape(found.field ?? '')}."]`) : null;
    return [item(capital(found.text), fromOne(error.detail), found, control)];
  });
  // The service may name a line, or no place at all: the page sees which points it is.
  if (list.length === 0 || items.length < list.length || !list.some((error) => place(host.lines, error.pointer).point !== undefined)) {
    for (const { line, points, text } of own) {
      points.forEach((point) => faulty.add(`${line}/${point}`));
      items.push(item('', capital(text), { line, point: points[0]! }, null));
    }
  }
  if (errorsOmitted) items.push(el('li', {}, 'and more'));
  const sentence = FAILURES[(type ?? '').replace('/problems/', '')];
  const summary = detail ?? message ?? '';
  // The detail of a refused request repeats its errors.
  const repeats = list.length > 0 && (/^see errors/.test(summary) || list.some((error) => summary.includes(error.detail)));
  const verbatim = sentence !== undefined && summary !== '' && !repeats;
  $('problem').replaceChildren(
    el('strong', {}, title ?? 'Something went wrong'), sentence ?? (repeats || summary === title ? '' : capital(fromOne(summary))), items.length > 0 && el('ul', {}, ...items) || '',
    remedied(type) ?? '',
    verbatim ? el('details', {}, el('summary', {}, 'In the words of the service, which counts from 0'), summary) : '',
  );
  $('problem').hidden = false;
  showPanel('setup');
  $('problem').scrollIntoView({ block: 'nearest' });
  session.serverFaulty = faulty;
  redraw();
  if (!(fault instanceof ConnectionFailed) || fault.job) return;
  const { life } = session.requests;
  later.parts?.whenBack(() => {
    if (answered !== turn) return;
    hideProblem();
    // The status keeps the news of a request that went on since the failure.
    if (session.requests.life === life) say('The server is back.');
  });
}

/** The button of a failure's remedy. */
function remedied(type: string | undefined): HTMLElement | null {
  const remedy = type === undefined ? null : remedyFor(type, doc().request);
  return remedy && el('button', { type: 'button', className: 'remedy', onclick: () => repair.by(remedy) }, remedy.label);
}

const unreached = ({ job }: ConnectionFailed): Fault => (job
  ? { title: 'The connection was lost', detail: 'The job goes on at the server. Reload the page to come back to it.' }
  : { title: 'The server cannot be reached', detail: 'Is it still running? Nothing was lost; try again.' });

/** One fault; a press leads to its point or its control. */
function item(where: string, what: string, found: { line?: number; point?: number }, control: HTMLElement | null): HTMLElement {
  const words = [where && el('b', {}, where), where ? ` ${what}` : what] as const;
  if (found.line === undefined && !control) return el('li', {}, ...words);
  const button = el('button', { type: 'button' }, ...words);
  button.addEventListener('click', () => {
    if (control) {
      control.closest('details')?.setAttribute('open', '');
      control.focus();
    } else tools.select([{ line: found.line!, point: Math.max(found.point ?? 0, 0) }]);
  });
  if (control) control.setAttribute('aria-invalid', 'true');
  return el('li', {}, button);
}
