// Changes of the document: a point, an option, undo, or another document in its place; and what follows from each.

import type { Kind } from 'plateau-client';
import { $ } from '../dom';
import { dropRefused, whyNot } from '../model/applies';
import { bareEdges, cablesOf, hangAll } from '../model/cables';
import { Frame, originFor } from '../model/frame';
import type { Document } from '../model/history';
import type { Remedy } from '../model/remedies';
import { at, blank, isWhole, KINDS, linesOf, print, type Request, unitOf } from '../model/request';
import { forceUnit } from '../panels/cable';
import type { FormHost } from '../panels/form';
import { Gizmo } from '../stage/gizmo';
import { supersedeOpenings } from './busy';
import { cableModes, foundCable, redraw, showDock } from './drawing';
import { keep } from './keeping';
import { setMode } from './modes';
import { say } from './notes';
import { hideProblem } from './problems';
import { forget, showStale } from './result';
import { doc, FIRST_VIEW, history, host, later, server, session, stage, surface, tools } from './session';
import { abandon, follows, solve } from './solving';

/** A drawing that takes longer than this to solve is solved when a drag ends, not while it goes on. */
const DRAG_PATIENCE_S = 1.2;

export const gizmo = new Gizmo($('gizmo') as unknown as SVGElement, stage, host.frame);
export const isLive = (): boolean => $<HTMLInputElement>('live').checked;

/** Shows the document as it is now, after it was replaced as a whole. */
export function load({ refit = true, direction = FIRST_VIEW } = {}): void {
  const { kind, request } = doc();
  host.lines = linesOf(kind, request);
  host.frame = new Frame(originFor(host.lines, request), request);
  gizmo.build(host.frame);
  surface.putInto(host.frame);
  tools.prune();
  showForm();
  redraw();
  stage.measure();
  if (refit) stage.view(direction);
  showDocument();
}

/** The kind and its options, as far as the server's documents have come. */
export function showForm(): void {
  const { kind, request } = doc();
  const radio = document.querySelector<HTMLInputElement>(`#kinds input[value="${kind}"]`);
  if (radio) radio.checked = true;
  $('purpose').textContent = KINDS[kind].purpose;
  const schema = later.parts?.schemaOf(server.openapi, KINDS[kind].path);
  if (!later.parts || !schema) return;
  const { build, disable, OBJECTIVES } = later.parts;
  const form = $<HTMLFormElement>('options');
  const formHost: FormHost = {
    openapi: server.openapi,
    whyNot: (field) => whyNot(kind, doc().request, field),
    given: (field) => at(doc().request, field.split('.')),
    unit: (field) => {
      const [force, length] = [forceUnit(doc().request), unitOf(doc().request)];
      return kind === 'tensile_structure' ? { 'film.tension': `${force}/${length}`, pressure: `${force}/${length}²`, 'film.weight': `${force}/${length}²` }[field] : undefined;
    },
    set: (name, value) => {
      let dropped = false;
      const before = structuredClone(doc().request);
      const done = history.edit(({ request: edited }) => {
        if (value === undefined) delete edited[name];
        else edited[name] = value;
        dropped = dropRefused(kind, edited);
      });
      if (!done) return;
      if (name === 'units' || name === 'up') {
        forget();
        load();
      }
      changed({ option: true });
      if (name === 'units') later.parts!.unitChanged(before);
      if (dropped) {
        const { name: focused } = document.activeElement as HTMLInputElement;
        showForm();
        if (focused) form.querySelector<HTMLElement>(`[name="${CSS.escape(focused)}"]`)?.focus();
      } else disable(form, formHost);
    },
    describe: (name, value) => (name === 'objective' ? OBJECTIVES[kind]?.[value] : undefined),
  };
  build(form, schema, request, formHost, kind === 'tensile_structure' ? cables(form, formHost) : null);
}

/** The table of the cables, whose edits leave the rest of the form as it is. */
function cables(form: HTMLFormElement, formHost: FormHost): HTMLElement {
  return later.parts!.cableTable(doc().request, cablesOf(doc().request), {
    modes: cableModes(),
    found: foundCable,
    foundMast: (index) => (session.shown?.job.statistics as { masts?: { length: number; force: number }[] } | undefined)?.masts?.[index],
    edit: (change) => {
      if (!history.edit(({ request }) => change(request))) return;
      changed({ option: true });
      later.parts!.disable(form, formHost);
    },
    choose: (index) => tools.chooseCable(index),
    chooseMast: (index) => {
      const line = host.lines.findIndex(({ path: [list, i] }) => list === 'masts' && i === index);
      tools.stopCabling();
      if (line >= 0) tools.select([{ line, point: [...host.lines[line]!.only!][0]! }]);
    },
    hangAll: mayNotHang(doc().request) ? null : () => { if (history.edit(({ request }) => hangAll(request))) changed({ edited: true }); },
  });
}

/** Whether no edge is left for a cable, or a pressure excludes cables along the edges. */
const mayNotHang = (request: Request): boolean => bareEdges(request).length === 0 || Boolean(request.pressure) || Boolean(request.volume);

/**
 * After every change of the document, also while a point is being dragged. `edited`: by somebody at work on it, who
 * waits for the shape.
 */
export function changed({ dragging = false, option = false, edited = false } = {}): void {
  $('intro').hidden = true;
  // A card is about the request as it was.
  if (session.card && session.card.of !== JSON.stringify(doc().request)) session.card.close();
  session.viewing = false;
  session.serverFaulty = new Set();
  host.lines = linesOf(doc().kind, doc().request);
  tools.prune();
  redraw(dragging);
  if (!dragging) {
    if (!option) showForm();
    stage.measure();
    keep();
  }
  showDocument(dragging);
  if (isLive() && isWhole(doc().kind, doc().request) && doc().draft === null) {
    if (!dragging || session.lastDuration < DRAG_PATIENCE_S || follows()) void solve({ dragging, live: edited || option });
  }
}

export function showDocument(dragging = false): void {
  $<HTMLButtonElement>('undo').disabled = !history.canUndo;
  $<HTMLButtonElement>('redo').disabled = !history.canRedo;
  $('draw').setAttribute('aria-pressed', String(tools.drawing));
  $<HTMLButtonElement>('draw').disabled = KINDS[doc().kind].lines.length === 0;
  $('title').textContent = doc().title ?? '';
  if (!dragging && $<HTMLDetailsElement>('request-box').open) showRequest();
  showDock();
  showStale();
}

/**
 * Makes the drawing's request the default text of its box. Once somebody has typed there, the browser shows the typed
 * text in place of the default until the form is reset, which happens when the text is applied or discarded.
 */
export function showRequest(): void {
  const box = $<HTMLTextAreaElement>('request');
  const text = print(doc().request);
  // Even an equal text would move the cursor and take the selection away.
  if (box.defaultValue !== text) box.defaultValue = text;
}

const restore = (step: () => boolean): void => {
  const { serial } = doc();
  if (!step()) return;
  // The film of another document would stand where its drawing may be far away.
  const another = serial !== doc().serial;
  if (session.requests.underWay && (another || session.requests.underWay.kind !== doc().kind)) abandon();
  if (session.shown && (another || session.shown.job.kind !== doc().kind)) forget();
  load({ refit: another });
  stage.rememberWhetherAllIsSeen();
  changed({ edited: true });
};
export const undo = (): void => restore(() => history.undo());
export const redo = (): void => restore(() => history.redo());

let documents = 0;

/**
 * Replaces the document, as one step that can be undone, or as a part of the last step. The film of the document
 * before goes with it.
 */
export function replace(kind: Kind, request: Request, title: string | null, { amend = false } = {}): void {
  abandon();
  supersedeOpenings();
  session.viewing = false;
  session.cameraGiven = false;
  documents += 1;
  const put = (document: Document): void => { Object.assign(document, { kind, request, title, draft: null, serial: documents }); };
  if (amend) history.amend(put);
  else history.edit(put);
  tools.selection = [];
  say('');
  forget();
  hideProblem();
  load();
}

export function startBlank(kind: Kind): void {
  replace(kind, blank(kind), null);
  say('');
  tools.startDrawing();
}

/** Takes an objective of the comparison. */
export function useObjective(name: string): void {
  setMode('model');
  const done = history.edit(({ request }) => {
    request.objective = name;
    dropRefused(doc().kind, request);
  });
  if (done) changed();
  if (!isLive()) void solve();
}

/** Changes the request as the remedy of a failure says, and solves it. */
export function applyRemedy({ apply }: Remedy): void {
  if (history.edit(({ request }) => apply(request))) changed();
  if (!isLive()) void solve();
}
