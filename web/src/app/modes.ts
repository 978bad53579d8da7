// Changing what fills the stage: the model, the objectives of a strip side by side, or its flat pattern.

import { $ } from '../dom';
import type { Compare } from '../panels/compare';
import type { Flat } from '../panels/flat';
import { fileName } from '../text';
import { ask } from './busy';
import { showDock } from './drawing';
import { showProblem } from './problems';
import { doc, host, later, look, type Mode, server, session, stage } from './session';

let flat: Flat | null = null;
let compare: Compare | null = null;

/**
 * Called with the objective that was chosen in the comparison. main.ts names the function, because it stands above this
 * module.
 */
export const comparison = { use: (_: string): void => {} };
export const restyleComparison = (): void => compare?.restyle();

/** The two other modes, which need parts of the page that come after the first film. */
function parts(): { flat: Flat; compare: Compare } | null {
  if (!later.parts) return null;
  flat ??= new later.parts.Flat();
  compare ??= new later.parts.Compare(stage, look, (name) => comparison.use(name));
  return { flat, compare };
}

/** Shows what goes wrong with something that is asked for now. */
function failing(): (error: unknown) => void {
  const turn = ask();
  return (error) => showProblem(error, turn);
}

export function setMode(next: Mode): void {
  if ((next === session.mode && next !== 'compare') || (next !== 'model' && !parts())) return;
  session.mode = next;
  $('stage').dataset.shows = next;
  for (const button of document.querySelectorAll<HTMLElement>('[data-mode]')) button.setAttribute('aria-pressed', String(button.dataset.mode === next));
  $('corner').hidden = next !== 'model';
  if (next !== 'compare') compare?.close();
  if (next !== 'flat') flat?.hide();
  if (next === 'compare') {
    const names = server.objectives.filter((each) => each.kind === 'ruled_surface').map((each) => each.name);
    void compare!.open(doc().request, host.frame, names, failing());
  }
  if (next === 'flat') showPattern();
  showDock();
  stage.invalidate();
}

/** Shows all of what fills the stage. */
export function fitAll(): void {
  if (session.mode === 'flat') flat!.fit();
  else stage.fit(true);
}

/** After a new result: which modes it offers, and the flat pattern anew if that is looked at. */
export function offerModes(strip: boolean, pattern: boolean): void {
  $('modes').hidden = !strip;
  document.querySelector<HTMLButtonElement>('[data-mode="flat"]')!.hidden = !pattern;
  if (session.mode !== 'flat') return;
  if (pattern) showPattern();
  else setMode('model');
}

/** Shows the pattern of the result, if the pattern is looked at. */
export function showPattern(): void {
  const { shown, mode } = session;
  if (shown && mode === 'flat') void flat!.show({ job: shown.job, request: shown.request, name: fileName(doc().title) ?? 'strip' }, failing());
}

/** Prints the flat pattern; whether it is what fills the stage. */
export function printPattern(): boolean {
  if (session.mode !== 'flat') return false;
  void flat!.print();
  return true;
}
