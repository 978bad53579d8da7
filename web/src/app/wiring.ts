// Which control does what.

import { setKey } from '../api';
import { $, save } from '../dom';
import { type Cable, cablesOf } from '../model/cables';
import { isWhole, print, type Request, type Vec3 } from '../model/request';
import { changeMode } from '../panels/cable';
import { fileName, typed } from '../text';
import { arrive, faultOfKey } from './arrival';
import { changed, isLive, load, redo, showRequest, startBlank, undo } from './document';
import { foundCable, hint, showDock, showPoint, widen } from './drawing';
import { whileBusy } from './busy';
import { keep, keepNow } from './keeping';
import { fitAll, printPattern, setMode } from './modes';
import { label, say, showPanel, toast } from './notes';
import { openLink } from './opening';
import { showQuantity } from './result';
import { doc, history, isStale, later, type Mode, session, stage, tools } from './session';
import { giveUp, solve } from './solving';
import { switchTheme } from './theme';

const KEY = 'api-key';
/** Names of the files that can be opened. */
const ACCEPT = '.csv,.txt,.obj,.dxf,.geojson,.json,.gltf,.glb';
const on = (id: string, event: string, act: (event: Event) => unknown): void => $(id).addEventListener(event, (each) => { void act(each); });
const all = (selector: string): NodeListOf<HTMLElement> => document.querySelectorAll<HTMLElement>(selector);

/** Does something with the parts of the page that come after the first film. The page is busy from the press on. */
const withLater = (act: (parts: typeof import('../later')) => unknown): unknown => (later.parts ? act(later.parts) : whileBusy(async () => { await act(await import('../later')); }));

export function wire(): void {
  wireSetup();
  wireDrawing();
  wireStage();
  wireFiles();
  wireDialogs();
  document.addEventListener('keydown', shortcut);
  window.addEventListener('pagehide', keepNow);
  window.addEventListener('hashchange', () => { if (/^#[js]=/.test(location.hash) && session.ready) void openLink(); });
}

function wireSetup(): void {
  on('solve', 'click', () => {
    if (session.viewing) {
      session.viewing = false;
      load({ refit: false });
    }
    return isWhole(doc().kind, doc().request) ? solve() : say(hint());
  });
  on('cancel', 'click', giveUp);
  on('live', 'change', () => isLive() && isStale() && solve({ live: true }));
  // A click or a key on the summary fills the box before it opens, since the toggle event comes only later.
  // Find-in-page opens the box without a click.
  $('request-box').querySelector('summary')!.addEventListener('click', showRequest);
  on('request-box', 'toggle', showRequest);
  on('request-form', 'input', () => { $('discard-request').hidden = false; });
  on('request-form', 'reset', () => { for (const id of ['discard-request', 'request-fault']) $(id).hidden = true; });
  on('apply-request', 'click', () => withLater(({ applyRequest }) => applyRequest()));
  on('save-request', 'click', () => save(new Blob([print({ kind: doc().kind, ...doc().request })], { type: 'application/json' }), `${fileName(doc().title) ?? doc().kind.replaceAll('_', '-')}.json`));
  for (const button of all('[data-panel]:is(button)')) button.addEventListener('click', () => showPanel(button.dataset.panel!));
  for (const form of ['point', 'options', 'key-form', 'drawing', 'cable']) on(form, 'submit', (event) => event.preventDefault());
}

function wireDrawing(): void {
  on('cabling', 'click', () => (tools.cabling ? tools.stopCabling() : tools.startCabling()));
  on('draw', 'click', () => (tools.drawing ? tools.stopDrawing() : tools.startDrawing()));
  on('undo', 'click', undo);
  on('redo', 'click', redo);
  on('finish', 'click', () => tools.finishDrawing());
  on('give-up', 'click', () => tools.stopDrawing());
  on('shape', 'change', () => {
    tools.shape = $<HTMLSelectElement>('shape').value as typeof tools.shape;
    showDock();
    stage.canvas.focus({ preventScroll: true });
  });
  on('snap', 'change', () => { tools.snapping = $<HTMLInputElement>('snap').checked; });
  on('level', 'change', () => { tools.level = $<HTMLInputElement>('level').valueAsNumber || 0; });
  on('previous-point', 'click', () => tools.step(-1));
  on('next-point', 'click', () => tools.step(1));
  on('insert-point', 'click', () => tools.insert());
  on('delete-point', 'click', () => tools.remove());
  on('remove-line', 'click', () => tools.removeLine());
  on('cable-from-point', 'click', () => tools.cableFromPoint());
  on('drop-cable', 'click', () => tools.dropCable());
  wireCable();
  on('intro-draw', 'click', () => startBlank('minimal_surface'));
  for (const input of document.querySelectorAll<HTMLInputElement>('#point input')) {
    input.addEventListener('input', () => {
      input.dataset.dirty = '1';
      widen(input);
    });
    input.addEventListener('blur', () => { delete input.dataset.dirty; });
    input.addEventListener('keydown', ({ key }) => {
      if (key !== 'Escape') return;
      delete input.dataset.dirty;
      showPoint();
      stage.canvas.focus({ preventScroll: true });
    });
    input.addEventListener('change', () => {
      delete input.dataset.dirty;
      const value = typed(input.value);
      if (!Number.isFinite(value)) {
        if (input.value.trim() !== '') toast(`${JSON.stringify(input.value)} is not a number.`);
        showPoint();
      } else if (input.id === 'edge' && value <= 0) {
        toast(`An edge must be longer than 0, and ${JSON.stringify(input.value)} is not.`);
        showPoint();
      } else if (input.id === 'edge') tools.setEdgeBefore(value);
      else tools.setAxis(Number(input.dataset.axis), value);
    });
  }
  const entry = $<HTMLInputElement>('entry');
  entry.addEventListener('keydown', (event) => {
    if (event.key !== 'Enter') return;
    event.preventDefault();
    event.stopPropagation();
    if (entry.value.trim() === '') {
      tools.finishDrawing();
      return;
    }
    const fault = tools.enter(entry.value);
    if (fault) toast(fault);
    else entry.value = '';
  });
}

/** The fields of the chosen cable. */
function wireCable(): void {
  const edit = (change: (cable: Cable, request: Request) => void): void => {
    const done = history.edit(({ request }) => {
      const cable = cablesOf(request)[tools.cable];
      if (cable) change(cable, request);
    });
    if (done) changed({ edited: true });
  };
  on('cable-mode', 'change', () => {
    const { value } = $<HTMLSelectElement>('cable-mode');
    const found = foundCable();
    edit((cable, request) => changeMode(request, cable, value, found));
  });
  for (const [id, set] of [
    ['cable-value', (cable: Cable, value: number) => { cable.value = value; }],
    ['cable-stiffness', (cable: Cable, value: number) => { cable.axial_stiffness = value; }],
  ] as const) {
    const input = $<HTMLInputElement>(id);
    input.addEventListener('input', () => { input.dataset.dirty = '1'; });
    input.addEventListener('blur', () => { delete input.dataset.dirty; });
    input.addEventListener('change', () => {
      delete input.dataset.dirty;
      const value = typed(input.value);
      if (value > 0) edit((cable) => set(cable, value));
      else if (id === 'cable-stiffness' && input.value.trim() === '') edit((cable) => { delete cable.axial_stiffness; });
      else toast(`${JSON.stringify(input.value)} is not a number above 0.`);
      showDock();
    });
  }
}

function wireStage(): void {
  const views: Record<string, Vec3> = { top: [0, 1, 1e-3], front: [0, 0, 1], side: [1, 0, 0] };
  for (const button of all('[data-view]')) {
    button.addEventListener('click', () => {
      const view = views[button.dataset.view!];
      if (view) stage.lookAlong(view);
      else fitAll();
    });
  }
  for (const button of all('[data-mode]')) button.addEventListener('click', () => setMode(button.dataset.mode as Mode));
  on('quantity', 'change', () => {
    session.colour = $<HTMLSelectElement>('quantity').value;
    label(null);
    showQuantity();
    stage.invalidate();
    keep();
  });
  on('measure', 'click', () => (tools.measuring ? tools.stopMeasuring() : tools.startMeasuring()));
  on('theme', 'click', switchTheme);
}

function wireFiles(): void {
  const input = $<HTMLInputElement>('file');
  input.accept = ACCEPT;
  on('open-file', 'click', () => input.click());
  on('file', 'change', async () => {
    const [chosen] = input.files ?? [];
    if (chosen) await withLater(({ take }) => take(chosen));
    input.value = '';
  });
  document.addEventListener('dragover', (event) => {
    event.preventDefault();
    document.body.classList.add('dropping');
  });
  document.addEventListener('dragleave', (event) => { if (!event.relatedTarget) document.body.classList.remove('dropping'); });
  document.addEventListener('drop', (event) => {
    event.preventDefault();
    document.body.classList.remove('dropping');
    takeFrom(event.dataTransfer);
  });
  document.addEventListener('paste', (event) => {
    if (!(event.target as HTMLElement).matches('input, textarea') && takeFrom(event.clipboardData)) event.preventDefault();
  });
}

/** Opens what was dropped or pasted; whether there was anything. */
function takeFrom(data: DataTransfer | null): boolean {
  const [file] = data?.files ?? [];
  const text = data?.getData('text/plain') ?? '';
  if (file) void withLater(({ take }) => take(file));
  else if (text.trim() !== '') void withLater(({ take }) => take(text));
  else return false;
  return true;
}

function wireDialogs(): void {
  const openGallery = (): void => $<HTMLDialogElement>('gallery').showModal();
  on('open-gallery', 'click', openGallery);
  on('intro-gallery', 'click', openGallery);
  on('open-recent', 'click', () => withLater(({ showRecent }) => showRecent()));
  on('open-share', 'click', () => withLater(({ openShare }) => openShare()));
  on('open-settings', 'click', () => $<HTMLDialogElement>('settings').showModal());
  on('copy', 'click', () => withLater(({ copy }) => copy()));
  on('picture', 'click', () => withLater(({ savePicture }) => savePicture()));
  for (const dialog of document.querySelectorAll('dialog')) {
    dialog.querySelector('[data-close]')!.addEventListener('click', () => dialog.close());
    dialog.addEventListener('click', (event) => { if (event.target === dialog) dialog.close(); });
  }
  const field = $<HTMLInputElement>('api-key');
  const stored = sessionStorage.getItem(KEY);
  if (stored) {
    field.value = stored;
    setKey(stored);
  }
  field.addEventListener('change', () => {
    setKey(field.value);
    void tryKey(field.value);
  });
  field.addEventListener('input', () => { $('key-fault').hidden = true; });
}

/** Keeps a key that the server takes, and says in the dialog what is wrong with another one. */
async function tryKey(key: string): Promise<void> {
  const fault = await faultOfKey();
  $('key-fault').textContent = fault ?? '';
  $('key-fault').hidden = fault === null;
  if (fault !== null) return;
  if (key) sessionStorage.setItem(KEY, key);
  else sessionStorage.removeItem(KEY);
  $<HTMLDialogElement>('settings').close();
  if (!session.ready) void arrive();
}

function shortcut(event: KeyboardEvent): void {
  const target = event.target as HTMLElement;
  const typing = target.matches('input:not([type="radio"], [type="checkbox"]), textarea, select') || document.querySelector('dialog[open]') !== null;
  const control = event.ctrlKey || event.metaKey;
  const key = event.key.toLowerCase();
  if (control && !typing && key === 'z') (event.shiftKey ? redo : undo)();
  else if (control && !typing && key === 'y') redo();
  else if (control && key === 'p' && printPattern()) { /* The service's PDF takes the place of the page. */ }
  else if (tools.drawing && event.key === 'Enter' && !target.matches('button, summary, a')) tools.finishDrawing();
  else if (tools.drawing && event.key === 'Escape') tools.stopDrawing();
  else if (tools.cabling && event.key === 'Escape') tools.stopCabling();
  else if (tools.drawing && !typing && !control && /^[\d.,@-]$/.test(event.key)) {
    // A number typed while drawing is the next point.
    const entry = $<HTMLInputElement>('entry');
    entry.focus();
    entry.value += event.key;
  } else return;
  event.preventDefault();
}
