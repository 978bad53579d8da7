// The studio: the request on the left, the model in the middle, the result on the right.

import './style.css';
import * as api from './api/client';
import type { ExampleSummary, Job, Kind, Objective } from './api/client';
import { $, el, save } from './dom';
import { FileFault, type Polyline } from './files/lines';
import { ACCEPT, openFile, openText, parseJson, type Opened } from './files/open';
import { findings } from './model/checks';
import { Frame, originFor } from './model/frame';
import { type Document, History } from './model/history';
import { blank, coordinates, isWhole, type Line, KINDS, kindOf, linesOf, metresOf, place, print, type Request, unitOf, type Vec3 } from './model/request';
import { charts, phaseName, type Sample } from './panels/chart';
import { Compare } from './panels/compare';
import { Flat } from './panels/flat';
import { build, type OpenApi, schemaOf } from './panels/form';
import { gallery } from './panels/gallery';
import { showLegend } from './panels/legend';
import { keyFigures, samplesOf, statistics, warnings } from './panels/report';
import * as share from './panels/share';
import { Gizmo } from './stage/gizmo';
import { parseMesh, type ResultMesh } from './stage/mesh';
import { offered, quantity, type Quantity, reading } from './stage/quantities';
import { Sketch, type SketchLook } from './stage/sketch';
import { type Pose, Stage } from './stage/stage';
import { type Look, Surface } from './stage/surface';
import { type Host, Tools } from './stage/tools';
import { count, duration, fieldSentence, humanise, number, sentence } from './text';

/** In live mode, a job that takes longer than this is cancelled when its input has changed. */
const PATIENCE_MS = 2000;
/** A drawing that takes longer than this to solve is solved when a drag ends, not while it goes on. */
const DRAG_PATIENCE_S = 1.2;
/** How long a result may lag behind the drawing before it is shown as out of date. */
const STALE_MS = 450;
const FIRST_VIEW: Vec3 = [0.62, 0.5, 0.85];
const WORK = 'plateau.work', RECENT = 'plateau.recent';
const embedded = document.documentElement.hasAttribute('data-embed');

const THEMES: Record<string, { sketch: SketchLook; look: Look; grid: [string, number]; shadow: number }> = {
  light: {
    sketch: { paper: '#ffffff', accent: '#0a6c7e', ink: '#1c2427', fault: '#c62f26', soft: '#6d7b81' },
    look: { membrane: '#f2eee6', ink: '#20292d', accent: '#b4561f' }, grid: ['#5b6b73', 0.42], shadow: 0.5,
  },
  dark: {
    sketch: { paper: '#12181b', accent: '#56c4d4', ink: '#ffffff', fault: '#ff7a70', soft: '#8fa0a8' },
    look: { membrane: '#cbc7be', ink: '#0d1214', accent: '#ffb273' }, grid: ['#90a4ad', 0.3], shadow: 0.85,
  },
};

interface Run { job: Job | null; since: number; cancelled: boolean; dragging: boolean; request: string; kind: Kind; title: string | null; generation: number }

let openapi: OpenApi = {};
let objectives: Objective[] = [];
let examples: ExampleSummary[] = [];
const history = new History({ kind: 'minimal_surface', request: blank('minimal_surface'), draft: null, title: null });
const doc = (): Document => history.document;

/** The result that is shown, and the request that it belongs to. */
let shown: { job: Job; mesh: ResultMesh; solved: string; request: Request; dragging: boolean } | null = null;
/** A job of which only the mesh is known here: the drawing is put aside. */
let viewing = false;
let colour = 'plain';
let current: Quantity | null = null;
let run: Run | null = null;
/** Where the next run gets its job: from the document as it is then, or from a job that is there already. */
let next: ((started: Run) => Promise<Job>) | null = null;
/** Counts replacements of the whole document: what was asked before one is not shown after it. */
let generation = 0;
let lastDuration = 0;
let mode: 'model' | 'compare' | 'flat' = 'model';
let staleTimer = 0;
let pendingJob: string | null = null;
let serverFaulty = new Set<string>();
/** Whether the camera came with the document, so that its first result does not move it. */
let cameraGiven = false;

const look: Look = { ...THEMES.light!.look };
const stage = new Stage($<HTMLCanvasElement>('view'), () => ({
  top: 64, right: 34, left: 34, bottom: Math.max(embedded ? 40 : 70, $('look').offsetHeight + 34),
}));
const sketch = new Sketch(THEMES.light!.sketch);
const surface = new Surface(look);
stage.model.add(surface.group, sketch.group);

const host: Host = {
  history, stage, sketch, surface, lines: [], frame: new Frame([0, 0, 0], doc().request), faulty: new Set(),
  changed: (dragging) => changed({ dragging }), selectionChanged: () => showDock(), label, read: readSurface, announce: (text) => { $('announcement').textContent = text; }, fixed: embedded,
};
const tools = new Tools(host);
const gizmo = new Gizmo($('gizmo') as unknown as SVGElement, stage, host.frame);
const flat = new Flat();
const compare = new Compare(stage, look, useObjective, (error) => showProblem(error));
stage.under = (x, y) => surface.pick(stage, x, y)?.point ?? null;
stage.content = () => [...sketch.places, ...surface.outline()];
stage.onDraw = () => {
  gizmo.place();
  placeLabel();
};
stage.onRest = () => {
  stage.rememberWhetherAllIsSeen();
  keep();
};
$('no-webgl').hidden = stage.renderer !== null;

// ---- The document ----

/** Shows the document as it is now, after it was replaced as a whole. */
function load({ refit = true, direction = undefined as Vec3 | undefined } = {}): void {
  const { kind, request } = doc();
  const radio = document.querySelector<HTMLInputElement>(`#kinds input[value="${kind}"]`);
  if (radio) radio.checked = true;
  $('purpose').textContent = KINDS[kind].purpose;
  host.lines = linesOf(kind, request);
  host.frame = new Frame(originFor(host.lines, request), request);
  gizmo.build(host.frame);
  surface.putInto(host.frame);
  tools.prune();
  buildForm();
  redraw();
  stage.measure();
  if (refit) stage.fit(false, direction ?? FIRST_VIEW);
  showEverything();
}

function buildForm(): void {
  const { kind, request } = doc();
  const schema = schemaOf(openapi, KINDS[kind].path);
  if (!schema) return;
  build($<HTMLFormElement>('options'), schema, request, {
    openapi,
    set: (name, value) => {
      const done = history.edit(({ request: edited }) => {
        if (value === undefined) delete edited[name];
        else edited[name] = value;
      });
      if (!done) return;
      if (name === 'units' || name === 'up') {
        forget();
        load();
      }
      changed({ option: true });
    },
    describe: (name, value) => {
      if (name !== 'objective') return undefined;
      const found = objectives.find((each) => each.kind === kind && each.name === value);
      return found ? `${capital(found.minimises)} [${found.unit.replaceAll('u', unitOf(request))}]. ${found.source}.` : undefined;
    },
  });
}

const capital = (text: string): string => text.charAt(0).toUpperCase() + text.slice(1);

/** The drawing on the stage, with what is wrong with it marked. */
function redraw(dragging = false): void {
  const { draft } = doc();
  sketch.group.visible = !viewing && !embedded;
  surface.drawn = sketch.group.visible;
  sketch.show(viewing ? [] : host.lines, draft, host.frame);
  if (!dragging) {
    host.faulty = new Set([...serverFaulty, ...findings(host.lines).flatMap(({ line, points }) => points.map((point) => `${line}/${point}`))]);
    stage.rememberWhetherAllIsSeen();
  }
  tools.refresh();
}

/** After every change of the document, also while a point is being dragged. */
function changed({ dragging = false, option = false } = {}): void {
  $('intro').hidden = true;
  viewing = false;
  serverFaulty = new Set();
  host.lines = linesOf(doc().kind, doc().request);
  tools.prune();
  redraw(dragging);
  if (!dragging) {
    if (!option) buildForm();
    stage.measure();
    keep();
  }
  showEverything(dragging);
  if ($<HTMLInputElement>('live').checked && isWhole(doc().kind, doc().request) && doc().draft === null) {
    if (!dragging || lastDuration < DRAG_PATIENCE_S) void solve();
  }
}

function showEverything(dragging = false): void {
  $<HTMLButtonElement>('undo').disabled = !history.canUndo;
  $<HTMLButtonElement>('redo').disabled = !history.canRedo;
  $('draw').setAttribute('aria-pressed', String(tools.drawing));
  $('title').textContent = doc().title ?? '';
  if (!dragging && $<HTMLDetailsElement>('request-box').open) showRequest();
  showDock();
  showStale();
}

function showRequest(): void {
  $<HTMLTextAreaElement>('request').value = print(doc().request);
  $('request-fault').hidden = true;
}

function restore(step: () => boolean): void {
  if (!step()) return;
  const { kind } = doc();
  if (shown && shown.job.kind !== kind) forget();
  load({ refit: false });
  stage.rememberWhetherAllIsSeen();
  changed();
}

// ---- The strip below the stage: what to do next, the line being drawn, or the selected points ----

function showDock(): void {
  const drawing = tools.drawing;
  const { selection } = tools;
  const introduced = !$('intro').hidden && !drawing && selection.length === 0;
  $('intro').hidden = !introduced;
  $('drawing').hidden = !drawing;
  $('point').hidden = drawing || selection.length === 0;
  $('hint').hidden = introduced || drawing || selection.length > 0;
  if (drawing) showDrawing();
  else if (selection.length > 0) showPoint();
  else $('hint').textContent = hint();
}

function hint(): string {
  if (viewing) return 'The server keeps no drawing of this job: only its mesh is shown. Undo, or any edit, brings your drawing back.';
  if (host.lines.length === 0) return 'Nothing is drawn yet. Press Draw, open a file, or drop one here.';
  if (!isWhole(doc().kind, doc().request)) return `A strip needs two ${KINDS[doc().kind].line}s: press Draw for the next one.`;
  return 'Drag a point to move it, press on an edge to add one. Drag the ground to orbit, right-drag to pan, wheel to zoom.';
}

function showDrawing(): void {
  const { kind, draft } = doc();
  const { line, least } = KINDS[kind];
  const first = kind === 'uniform_mesh' && host.lines.length === 0;
  const n = draft!.length;
  const what = first ? 'polygon' : line;
  $('drawing-hint').textContent = n === 0
    ? `Click on the ground to begin the ${what}.`
    : n < least ? `${count(n, 'point')} of the ${what}: click to add more.`
      : kind === 'ruled_surface' ? `${count(n, 'point')}: click to add more, Enter ends the rail.` : `${count(n, 'point')}: click the first point, or press Enter, to close the ${what}.`;
  $<HTMLButtonElement>('finish').disabled = n < least;
  $('level-name').textContent = `at ${'xyz'[host.frame.up]}`;
  if (document.activeElement !== $('level')) $<HTMLInputElement>('level').value = String(tools.level);
}

function showPoint(): void {
  const { selection } = tools;
  const { only } = tools;
  const line = only && host.lines[only.line];
  $('point-name').textContent = line ? `${capital(line.name)}, ${only.point + 1} of ${line.points.length}` : count(selection.length, 'point');
  for (const input of document.querySelectorAll<HTMLInputElement>('#point [data-axis]')) {
    const values = new Set(selection.map((ref) => {
      const raw = host.lines[ref.line]?.points[ref.point];
      return Array.isArray(raw) ? raw[Number(input.dataset.axis)] as unknown : undefined;
    }));
    const [value] = values;
    if (document.activeElement === input && input.dataset.dirty) continue;
    input.value = values.size === 1 && value !== undefined && value !== null ? String(value) : '';
    input.placeholder = values.size === 1 ? 'none' : 'various';
  }
  const edge = tools.edgeBefore();
  $('edge-field').hidden = !edge;
  if (edge && document.activeElement !== $('edge')) $<HTMLInputElement>('edge').value = String(Number(edge.length.toPrecision(7)));
  $<HTMLButtonElement>('insert-point').disabled = !only;
}

/** `1.5`, `1,5` or a small sum such as `3+0.25`. */
function typed(text: string): number {
  const parts = text.replace(/,/g, '.').replace(/−/g, '-').match(/[+-]?\s*\d*\.?\d+(?:e[+-]?\d+)?/gi);
  if (!parts || parts.join('').replace(/\s/g, '') !== text.replace(/,/g, '.').replace(/−/g, '-').replace(/\s/g, '')) return NaN;
  return Number(parts.reduce((sum, part) => sum + Number(part.replace(/\s/g, '')), 0).toPrecision(15));
}

// ---- Text beside a pixel ----

let labelled: { text: string; x: number; y: number; anchor: Vec3 | null } | null = null;

function label(text: string | null, x = 0, y = 0, anchor: Vec3 | null = null): void {
  labelled = text === null ? null : { text, x, y, anchor };
  placeLabel();
}

function placeLabel(): void {
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

function readSurface(point: { x: number; y: number; z: number; toArray(): Vec3 }, face: number, x: number, y: number): void {
  const value = surface.valueAt(point as never, face);
  const where = host.frame.fromScene(point.toArray()).map((each) => number(each, 5)).join(', ');
  label(current && value !== null ? reading(current, value) : where, x, y, point.toArray());
}

// ---- What is under way ----

/** Openings and runs that have begun and not ended. */
let underWay = 0;
/** Counts openings, so that of two at a time the later one wins. */
let openings = 0;

/** The page is busy from the press that begins some work until its end, however it ends. */
async function whileBusy<T>(work: () => Promise<T>): Promise<T> {
  underWay += 1;
  document.body.setAttribute('aria-busy', 'true');
  try {
    return await work();
  } finally {
    underWay -= 1;
    document.body.setAttribute('aria-busy', String(underWay > 0));
  }
}

/** Opens what `fetch` brings, unless something else is being opened by then; failures are shown. */
const open = <T>(fetch: () => Promise<T>, use: (found: T) => void, fail: (error: unknown) => void = showProblem): Promise<void> => whileBusy(async () => {
  openings += 1;
  const own = openings;
  try {
    const found = await fetch();
    if (own === openings) use(found);
  } catch (error) {
    if (own === openings) fail(error);
  }
});

// ---- Solving ----

const say = (text: string): void => { $('status').textContent = text; };

/** Solves the document; in live mode what changed meanwhile is solved next. */
const solve = (): Promise<void> => start(({ kind, request }) => api.submit(KINDS[kind].path, JSON.parse(request)));

/** Follows a job that belongs to the document as it is: after a reload, or from the list of recent jobs. */
const adopt = (job: Job): Promise<void> => start(() => Promise.resolve(job));

/** One job at a time: while one runs, the last that was asked for waits. */
async function start(submit: (started: Run) => Promise<Job>): Promise<void> {
  next = submit;
  if (run) {
    if (run.generation !== generation || performance.now() - run.since > PATIENCE_MS) void cancel();
    return;
  }
  await whileBusy(async () => {
    showRunning(true);
    while (next) {
      const from = next;
      next = null;
      const { kind, request, title } = doc();
      run = { job: null, since: performance.now(), cancelled: false, dragging: dragging(), request: JSON.stringify(request), kind, title, generation };
      try {
        await carryOut(run, from);
      } catch (error) {
        if (!next) {
          showProblem(error);
          say('Not solved.');
        }
      } finally {
        run = null;
      }
    }
    showRunning(false);
    showStale();
  });
}

const dragging = (): boolean => document.querySelector('canvas:active') !== null;

/** Takes a job from its submission, or from wherever it is, to its end. */
async function carryOut(started: Run, submit: (started: Run) => Promise<Job>): Promise<void> {
  if (!started.dragging) say('Solving…');
  started.job = await submit(started);
  hideProblem();
  if (started.cancelled) started.job = await api.cancel(started.job);
  if (!api.hasEnded(started.job)) {
    pendingJob = started.job.id;
    keep();
    const samples: Sample[] = [];
    const since = Date.now();
    const ticking = window.setInterval(() => showProgress(null, samples, since), 500);
    showProgress(null, samples, since, started.job.status === 'queued' ? 'Waiting in the queue' : 'Running');
    try {
      started.job = await api.follow(started.job, (progress) => {
        const last = samples.at(-1);
        if (!last || last.iteration !== progress.iteration || last.phase !== progress.phase) {
          samples.push({ iteration: progress.iteration, phase: progress.phase, value: progress.objective_value ?? null, residual: progress.residual ?? null });
        }
        showProgress(progress, samples, since);
      });
    } finally {
      clearInterval(ticking);
      $('running-charts').replaceChildren();
    }
  }
  pendingJob = null;
  const { job } = started;
  if (job.status === 'failed') {
    if (next) return;
    showProblem(job.error ?? {});
    say('Not solved.');
  } else if (job.status === 'cancelled') {
    if (!next) say('Cancelled.');
  } else {
    const mesh = await parseMesh(await api.getBytes(`${job.links.mesh}?format=glb`));
    if (started.generation !== generation || viewing) return;
    const superseded = shown?.dragging && shown.job.id !== job.id ? shown.job : null;
    lastDuration = (performance.now() - started.since) / 1000;
    show(job, mesh, started.request, started.dragging);
    if (superseded) api.remove(superseded).catch(() => {});
    if (!started.dragging) rememberJob(job, started);
  }
  keep();
}

function showRunning(is: boolean): void {
  $('cancel').hidden = !is;
  const bar = $<HTMLProgressElement>('progress');
  // A job of a moment needs no bar: one that blinks disturbs.
  clearTimeout(busyTimer);
  if (is) busyTimer = window.setTimeout(() => { bar.hidden = false; }, 300);
  else bar.hidden = true;
  if (is) bar.removeAttribute('value');
}
let busyTimer = 0;

function showProgress(progress: api.Progress | null, samples: Sample[], since: number, text?: string): void {
  const elapsed = duration((Date.now() - since) / 1000);
  const last = samples.at(-1);
  if (progress) {
    $<HTMLProgressElement>('progress').value = progress.fraction;
    $('running-charts').replaceChildren(...charts(samples, doc().kind === 'minimal_surface' ? 'Area' : 'Objective', toleranceOf(doc().request)));
  }
  const fraction = $<HTMLProgressElement>('progress').position;
  const parts = [
    fraction > 0 && `${Math.round(fraction * 100)} %`, text ?? (last ? phaseName(last.phase) : 'Running'), last && last.iteration > 0 && `iteration ${number(last.iteration)}`, elapsed,
  ];
  say(parts.filter(Boolean).join(' · '));
}

const toleranceOf = (request: Request): number | null => (typeof request.tolerance === 'number' ? request.tolerance : doc().kind === 'minimal_surface' ? 1e-6 : null);

/** Cancels on the server; a job that is still being submitted, as soon as it has an id. */
async function cancel(): Promise<void> {
  if (!run) return;
  run.cancelled = true;
  if (!run.job) return;
  try {
    await api.cancel(run.job);
  } catch (error) {
    showProblem(error);
  }
}

// ---- The result ----

function forget(): void {
  shown = null;
  current = null;
  surface.show(null, '', host.frame);
  $('result').hidden = true;
  $('nothing').hidden = false;
  $('look').hidden = true;
  $('modes').hidden = true;
  showLegend(null);
  setMode('model');
}

function show(job: Job, mesh: ResultMesh, solved: string, whileDragging = false): void {
  const first = shown === null || shown.job.kind !== job.kind;
  const request = JSON.parse(solved) as Request;
  shown = { job, mesh, solved, request, dragging: whileDragging };
  label(null);
  surface.show(mesh, job.kind, host.frame);
  showQuantities(mesh, job.kind, request);
  stage.measure();
  stage.rememberWhetherAllIsSeen();
  if (first && !cameraGiven) stage.fit(false);
  cameraGiven = false;
  showLayers();

  $('nothing').hidden = true;
  $('result').hidden = false;
  $('look').hidden = false;
  $('job-id').textContent = job.id;
  const unit = unitOf(request);
  const values = job.statistics as Record<string, unknown>;
  $('figures').replaceChildren(...keyFigures(job, unit));
  $('warnings').replaceChildren(...warnings(job.warnings));
  $('statistics').replaceChildren(...statistics(values));
  $('charts').replaceChildren(...charts(samplesOf(values.history as api.HistoryRow[] | undefined), 'Area', toleranceOf(request)));
  offer($('downloads'), ['glb', 'gltf', 'obj', 'ply', 'stl'], job, job.links.mesh!);
  const pattern = Boolean(job.links.pattern && values.flat_pattern);
  $('pattern-box').hidden = !pattern;
  if (pattern) offer($('pattern-downloads'), ['svg', 'dxf'], job, job.links.pattern!);
  $('modes').hidden = job.kind !== 'ruled_surface';
  document.querySelector<HTMLButtonElement>('[data-mode="flat"]')!.hidden = !pattern;
  if (mode === 'flat') pattern ? flat.show(job).catch(showProblem) : setMode('model');
  sayHowItWent(job, mesh);
  showStale();
}

function sayHowItWent(job: Job, mesh: ResultMesh): void {
  const time = (Date.parse(job.finished_at ?? '') - Date.parse(job.started_at ?? '')) / 1000;
  // The server keeps results: the same request again takes no time.
  const how = time > 0 ? `Solved in ${duration(time)}` : 'Solved';
  const { converged } = job.statistics as { converged?: boolean };
  say(`${how}: ${count(mesh.geometry.index!.count / 3, 'triangle')}.${converged === false ? ' Not converged.' : ''}`);
}

function offer(box: HTMLElement, formats: string[], job: Job, link: string): void {
  box.replaceChildren(...formats.map((format) => el('button', {
    type: 'button',
    onclick: async () => {
      try {
        save(await api.getBlob(`${link}?format=${format}`), `${job.kind.replaceAll('_', '-')}-${job.id}.${format}`);
      } catch (error) {
        showProblem(error);
      }
    },
  }, format.toUpperCase())));
}

const isStale = (): boolean => shown !== null && !viewing && (shown.solved !== JSON.stringify(doc().request) || shown.job.kind !== doc().kind);

/** What is shown as a result must be one of the drawing; while a new one is on its way, for a moment it need not be. */
function showStale(): void {
  const stale = isStale();
  for (const button of document.querySelectorAll<HTMLButtonElement>('#downloads button, #pattern-downloads button')) button.disabled = stale;
  clearTimeout(staleTimer);
  const apply = (): void => {
    $('result').classList.toggle('stale', stale);
    $('stale').hidden = !stale;
    surface.setStale(stale);
    stage.invalidate();
  };
  if (stale && run && lastDuration * 1000 < STALE_MS) staleTimer = window.setTimeout(apply, STALE_MS);
  else apply();
}

function showQuantities(mesh: ResultMesh, kind: string, request: Request): void {
  const list = offered(mesh, kind);
  const select = $<HTMLSelectElement>('quantity');
  if (!list.some(({ id }) => id === colour)) colour = 'plain';
  select.replaceChildren(...list.map(({ id, label: name }) => el('option', { value: id }, name)));
  select.value = colour;
  current = quantity(mesh, colour, unitOf(request), metresOf(request));
  surface.colourBy(current);
  showLegend(current);
}

function showLayers(): void {
  const names: Record<keyof typeof surface.layers, string> = { surface: 'Surface', edges: 'Mesh', lines: 'Lines' };
  $('layers').replaceChildren(...(Object.keys(names) as (keyof typeof surface.layers)[]).map((name) => {
    const button = el('button', { type: 'button', 'aria-pressed': String(surface.layers[name]) }, names[name]);
    button.addEventListener('click', () => {
      surface.setLayers({ [name]: !surface.layers[name] });
      button.setAttribute('aria-pressed', String(surface.layers[name]));
      stage.measure();
    });
    return button;
  }), pointsLayer());
}

function pointsLayer(): HTMLElement {
  const button = el('button', { type: 'button', 'aria-pressed': String(sketch.group.visible) }, 'Drawing');
  button.addEventListener('click', () => {
    sketch.group.visible = !sketch.group.visible;
    surface.drawn = sketch.group.visible;
    surface.restyle();
    button.setAttribute('aria-pressed', String(sketch.group.visible));
    stage.invalidate();
  });
  return button;
}

function setMode(next: typeof mode): void {
  if (next === mode && next !== 'compare') return;
  mode = next;
  for (const button of document.querySelectorAll<HTMLElement>('[data-mode]')) button.setAttribute('aria-pressed', String(button.dataset.mode === mode));
  $('corner').hidden = mode !== 'model';
  if (mode !== 'compare') compare.close();
  if (mode !== 'flat') flat.hide();
  if (mode === 'compare') {
    const names = objectives.filter((each) => each.kind === 'ruled_surface').map((each) => each.name);
    void compare.open(doc().request, host.frame, names);
  }
  if (mode === 'flat' && shown) flat.show(shown.job).catch(showProblem);
  stage.invalidate();
}

function useObjective(name: string): void {
  setMode('model');
  const done = history.edit(({ request }) => {
    request.objective = name;
    if (name !== 'maximal_convexity') delete request.secondary_objective;
  });
  if (done) changed();
  if (!$<HTMLInputElement>('live').checked) void solve();
}

// ---- What went wrong ----

function hideProblem(): void {
  $('problem').hidden = true;
  if (serverFaulty.size === 0) return;
  serverFaulty = new Set();
  redraw();
}

interface Fault { title?: string; detail?: string; message?: string; errors?: api.FieldError[] | null; omitted?: boolean }

/** A problem document, a failed job's error, or a defect of this page: what is wrong, said once, and where. */
function showProblem(fault: unknown): void {
  const { title, detail, message, errors, omitted } = fault as Fault;
  const list = errors ?? [];
  serverFaulty = new Set();
  const items = list.map((error) => {
    const found = place(host.lines, error.pointer);
    if (found.line !== undefined && found.point !== undefined && found.point >= 0) serverFaulty.add(`${found.line}/${found.point}`);
    const control = found.line === undefined ? $<HTMLFormElement>('options').querySelector<HTMLElement>(`[name="${CSS.escape(found.field ?? '')}"], [name^="${CSS.escape(found.field ?? '')}."]`) : null;
    return item(capital(found.text), fieldSentence(error.detail), found, control);
  });
  // The service may name a line and not the points: the studio sees which.
  if (!list.some((error) => place(host.lines, error.pointer).point !== undefined)) {
    for (const { line, points, text } of findings(host.lines)) {
      points.forEach((point) => serverFaulty.add(`${line}/${point}`));
      items.push(item('', text, { line, point: points[0]! }, null));
    }
  }
  if (omitted) items.push(el('li', {}, 'and more'));
  // The detail of a refused request repeats its errors.
  const summary = detail ?? message ?? '';
  const repeats = list.length > 0 && (/^see errors/.test(summary) || list.some((error) => summary.includes(error.detail)));
  $('problem').replaceChildren(
    el('strong', {}, title ?? 'Something went wrong'), repeats || summary === title ? '' : sentence(capital(summary)), items.length > 0 && el('ul', {}, ...items) || '',
  );
  $('problem').hidden = false;
  redraw();
}

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

let toastTimer = 0;
function toast(text: string): void {
  $('toast').textContent = text;
  $('toast').hidden = false;
  clearTimeout(toastTimer);
  toastTimer = window.setTimeout(() => { $('toast').hidden = true; }, 7000);
}

// ---- Examples, files, links ----

/** Replaces the document, as one step that can be undone. */
function replace(kind: Kind, request: Request, title: string | null, { direction = undefined as Vec3 | undefined } = {}): void {
  viewing = false;
  cameraGiven = false;
  generation += 1;
  const same = shown?.job.kind === kind;
  history.edit((document) => Object.assign(document, { kind, request, title, draft: null }));
  tools.selection = [];
  if (!same || !isWhole(kind, request)) forget();
  hideProblem();
  load(direction ? { direction } : {});
}

interface Example { kind: Kind; title: string; request: Request }

const openExample = (name: string): Promise<void> => open(() => api.getJson<Example>(`/v1/examples/${encodeURIComponent(name)}`), (example) => {
  const { kind: _, ...request } = example.request;
  forget();
  replace(example.kind, request, example.title);
  changed();
  if (!$<HTMLInputElement>('live').checked) say('Ready.');
});

function startBlank(kind: Kind): void {
  forget();
  replace(kind, blank(kind), null);
  say('');
  tools.startDrawing();
}

/** A file's polylines become the drawing; options stay. */
function takeLines(lines: Polyline[], format: string, metres: boolean, name: string): void {
  const { kind, request } = doc();
  const { line, least } = KINDS[kind];
  const factor = metres ? 1 / metresOf(request) : 1;
  const own = lines.map(({ points }) => points.map(([x, y, z]): Vec3 => {
    const turned: Vec3 = metres && request.up !== 'y' ? [x, -z, y] : [x, y, z];
    return metres ? turned.map((value) => Number((value * factor).toPrecision(9))) as Vec3 : turned;
  }));
  const short = own.findIndex((points) => points.length < (kind === 'ruled_surface' ? 1 : least));
  if (short >= 0) throw new FileFault(`Line ${short + 1} of the file has ${count(own[short]!.length, 'point')}; a ${line} needs ${least}.`);
  const next: Request = { ...structuredClone(request) };
  for (const field of ['normals', 'tangents', 'constraints']) delete next[field];
  if (typeof next.initial_mesh === 'object') delete next.initial_mesh;
  if (kind === 'ruled_surface') Object.assign(next, { directrices: own, closed: lines.length > 1 && lines.every(({ closed }) => closed) });
  else if (kind === 'minimal_surface') next.boundaries = own;
  else {
    const bySize = [...own].sort((a, b) => extent(b) - extent(a));
    next.domain = { polygon: bySize[0], ...(bySize.length > 1 && { holes: bySize.slice(1) }) };
  }
  replace(kind, next, name || `${format} drawing`);
  changed();
  toast(`${format}: ${count(own.length, 'line')}, ${count(own.reduce((sum, points) => sum + points.length, 0), 'point')}. Undo brings back what was there.`);
}

const extent = (points: Vec3[]): number => {
  const spans = [0, 1, 2].map((axis) => Math.max(...points.map((point) => point[axis]!)) - Math.min(...points.map((point) => point[axis]!)));
  return Math.hypot(...spans);
};

const take = (read: () => Promise<Opened>, name: string): Promise<void> => open(read, (opened) => {
  if ('lines' in opened) takeLines(opened.lines, opened.format, opened.metres, name);
  else takeRequest(opened.request, name);
}, (error) => showProblem({ title: name ? `${name} cannot be opened` : 'This cannot be opened', detail: error instanceof Error ? error.message : String(error) }));

function takeRequest(request: Request, title: string | null): void {
  const { kind: named, ...rest } = request;
  const kind = kindOf(request) ?? doc().kind;
  if (named !== undefined && !(String(named) in KINDS)) throw new FileFault(`This server has no kind ${JSON.stringify(named)}.`);
  replace(kind, rest, title);
  changed();
}

function applyRequest(): void {
  const fault = (text: string): void => {
    $('request-fault').textContent = text;
    $('request-fault').hidden = false;
  };
  $('request-fault').hidden = true;
  try {
    const request = parseJson($<HTMLTextAreaElement>('request').value) as Request;
    if (request === null || typeof request !== 'object' || Array.isArray(request)) {
      fault('A request is an object, { … }.');
      return;
    }
    takeRequest(request.kind !== undefined || kindOf(request) ? request : { ...request, kind: doc().kind }, doc().title);
  } catch (error) {
    fault(error instanceof Error ? error.message : String(error));
  }
}

// ---- Keeping ----

let keepTimer = 0;
function keep(): void {
  if (embedded || !ready) return;
  clearTimeout(keepTimer);
  keepTimer = window.setTimeout(keepNow, 250);
}

function keepNow(): void {
  if (embedded || !ready) return;
  const { kind, request, draft, title } = doc();
  const text = JSON.stringify({ kind, request, draft, title, camera: worldPose(), colour, job: pendingJob ?? (isStale() ? null : shown?.job.id ?? null) });
  try {
    sessionStorage.setItem(WORK, text);
    localStorage.setItem(WORK, text);
  } catch {
    // A drawing larger than the browser keeps is still in the page; it is only not there after a reload.
    if (!warnedOfSize) toast('This drawing is too large to be kept by the browser: save it as a file.');
    warnedOfSize = true;
  }
}
let warnedOfSize = false;
let ready = false;

/** The camera in metres from the coordinates' zero, so that it does not depend on the stage's own origin. */
function worldPose(): Pose {
  const { eye, target } = stage.pose();
  const shift = new Frame([0, 0, 0], doc().request).toScene(host.frame.origin);
  return { eye: eye.map((value, axis) => value + shift[axis]!) as Vec3, target: target.map((value, axis) => value + shift[axis]!) as Vec3 };
}

/** Puts the camera where a link or the last visit had it; the first result leaves it there. */
function placeWorld({ eye, target }: Pose): void {
  cameraGiven = true;
  const shift = new Frame([0, 0, 0], doc().request).toScene(host.frame.origin);
  stage.place({ eye: eye.map((value, axis) => value - shift[axis]!) as Vec3, target: target.map((value, axis) => value - shift[axis]!) as Vec3 }, false);
  stage.rememberWhetherAllIsSeen();
}

interface RecentJob { id: string; title: string | null; kind: Kind; request: string }

function recentJobs(): RecentJob[] {
  try {
    return JSON.parse(localStorage.getItem(RECENT) ?? '[]') as RecentJob[];
  } catch {
    return [];
  }
}

function rememberJob(job: Job, { request, title }: Run): void {
  if (embedded || request.length > 200_000) return;
  const list = [{ id: job.id, title, kind: job.kind, request }, ...recentJobs().filter((each) => each.id !== job.id)].slice(0, 20);
  try {
    localStorage.setItem(RECENT, JSON.stringify(list));
  } catch {
    localStorage.removeItem(RECENT);
  }
}

async function showRecent(): Promise<void> {
  const box = $('recent-list');
  box.replaceChildren(el('p', { className: 'quiet' }, 'Asking the server…'));
  $<HTMLDialogElement>('recent').showModal();
  try {
    const { jobs } = await api.getJson<{ jobs: Job[] }>('/v1/jobs?limit=30');
    const known = new Map(recentJobs().map((each) => [each.id, each]));
    const rows = jobs.map((job) => {
      const mine = known.get(job.id);
      const open = el('button', { type: 'button', disabled: !['succeeded', 'running', 'queued'].includes(job.status) }, 'Open');
      open.setAttribute('aria-label', `Open ${mine?.title ?? job.kind} of ${job.created_at}`);
      open.addEventListener('click', () => {
        $<HTMLDialogElement>('recent').close();
        void openJob(job, mine);
      });
      return el('tr', {}, el('th', { scope: 'row' }, mine?.title ?? KINDS[job.kind].label), el('td', {}, job.status), el('td', {}, new Date(job.created_at).toLocaleString()), el('td', {}, open));
    });
    box.replaceChildren(rows.length > 0 ? el('table', { className: 'plain' }, el('tbody', {}, ...rows)) : el('p', { className: 'quiet' }, 'No jobs yet.'));
  } catch (error) {
    box.replaceChildren(el('p', { className: 'fault' }, error instanceof Error ? error.message : String(error)));
  }
}

/** With its drawing, where this browser knows it; else the mesh alone. */
const openJob = (listed: Job, mine: RecentJob | undefined): Promise<void> => open(async () => {
  const job = await api.getJson<Job>(listed.links.self);
  const mesh = mine || job.status !== 'succeeded' ? null : await parseMesh(await api.getBytes(`${job.links.mesh}?format=glb`));
  return { job, mesh };
}, ({ job, mesh }) => {
  if (mine) {
    forget();
    replace(mine.kind, JSON.parse(mine.request) as Request, mine.title);
    void adopt(job);
  } else if (mesh) viewMesh(job, mesh);
  else say('This job has no result yet, and this browser does not know its drawing.');
});

function viewMesh(job: Job, mesh: ResultMesh): void {
  viewing = true;
  forget();
  const { unit, up } = mesh.extras as { unit?: string; up?: string };
  const request: Request = { units: unit, up };
  const [x, y, z] = (mesh.extras.origin as Vec3 | undefined) ?? [0, 0, 0];
  host.frame = new Frame([x, y, z], request);
  redraw();
  show(job, mesh, JSON.stringify(request));
  stage.fit(false, FIRST_VIEW);
  showEverything();
}

const FORMS = ['Link', 'Embed', 'curl', 'Python', 'TypeScript'] as const;

let shares = 0;

/** The text in one of its forms; form and text change together, so that what is copied is what its button says. */
async function showShare(form: (typeof FORMS)[number]): Promise<void> {
  shares += 1;
  const own = shares;
  const { kind, request, title } = doc();
  const shared = { kind, request, title, camera: worldPose(), colour };
  const text = form === 'Link' ? await share.linkOf(shared)
    : form === 'Embed' ? await share.embedOf(shared)
      : form === 'curl' ? share.curl(kind, request) : form === 'Python' ? share.python(kind, request) : share.typescript(kind, request);
  if (own !== shares) return;
  $('share-forms').replaceChildren(...FORMS.map((each) => el('button', { type: 'button', 'aria-pressed': String(each === form), onclick: () => void showShare(each) }, each)));
  $<HTMLTextAreaElement>('share-text').value = text;
  $('copied').textContent = '';
}

// ---- Wiring ----

function showKinds(): void {
  const kinds = (Object.keys(KINDS) as Kind[]).filter((kind) => schemaOf(openapi, KINDS[kind].path));
  const legend = $('kinds').querySelector('legend')!;
  $('kinds').replaceChildren(legend, ...kinds.map((kind) => {
    const radio = el('input', { type: 'radio', name: 'kind', value: kind });
    radio.addEventListener('change', () => switchKind(kind));
    return el('label', {}, radio, KINDS[kind].label);
  }));
  $('blank-starts').replaceChildren(...kinds.map((kind) => el('button', {
    type: 'button', onclick: () => { $<HTMLDialogElement>('gallery').close(); startBlank(kind); },
  }, `Draw a ${KINDS[kind].label.toLowerCase()}`)));
}

/** What was last drawn of each kind, to come back to. */
const drafts = new Map<Kind, { request: Request; title: string | null }>();

function switchKind(kind: Kind): void {
  const before = doc();
  if (before.kind === kind) return;
  drafts.set(before.kind, { request: structuredClone(before.request), title: before.title });
  const kept = drafts.get(kind);
  const first = examples.find((each) => each.kind === kind);
  if (kept) {
    replace(kind, kept.request, kept.title);
    changed();
  } else if (first) void openExample(FIRST_OF[kind] ?? first.name);
  else startBlank(kind);
}

/** The example that a kind begins with. */
const FIRST_OF: Partial<Record<Kind, string>> = { ruled_surface: 'wavy-strip', uniform_mesh: 'vault' };

function setTheme(theme: string): void {
  document.documentElement.dataset.theme = theme;
  $('theme').setAttribute('aria-pressed', String(theme === 'dark'));
  const style = THEMES[theme]!;
  Object.assign(look, style.look);
  sketch.restyle(style.sketch);
  stage.grid.style(...style.grid);
  stage.shadow.style(style.shadow);
  surface.restyle();
  compare.restyle();
  redraw();
  stage.invalidate();
}

function wire(): void {
  const on = (id: string, event: string, act: (event: Event) => unknown): void => $(id).addEventListener(event, (each) => { void act(each); });
  on('solve', 'click', () => (isWhole(doc().kind, doc().request) ? solve() : say(hint())));
  on('cancel', 'click', () => { next = null; return cancel(); });
  on('live', 'change', () => $<HTMLInputElement>('live').checked && isStale() && solve());
  on('draw', 'click', () => (tools.drawing ? tools.stopDrawing() : tools.startDrawing()));
  on('undo', 'click', () => restore(() => history.undo()));
  on('redo', 'click', () => restore(() => history.redo()));
  on('finish', 'click', () => tools.finishDrawing());
  on('give-up', 'click', () => tools.stopDrawing());
  on('snap', 'change', () => { tools.snapping = $<HTMLInputElement>('snap').checked; });
  on('level', 'change', () => { tools.level = $<HTMLInputElement>('level').valueAsNumber || 0; });
  on('previous-point', 'click', () => tools.step(-1));
  on('next-point', 'click', () => tools.step(1));
  on('insert-point', 'click', () => tools.insert());
  on('delete-point', 'click', () => tools.remove());
  on('remove-line', 'click', () => tools.removeLine());
  for (const form of ['point', 'options', 'key-form', 'drawing']) on(form, 'submit', (event) => event.preventDefault());
  for (const input of document.querySelectorAll<HTMLInputElement>('#point input')) {
    input.addEventListener('input', () => { input.dataset.dirty = '1'; });
    input.addEventListener('blur', () => { delete input.dataset.dirty; });
    input.addEventListener('change', () => {
      delete input.dataset.dirty;
      const value = typed(input.value);
      if (!Number.isFinite(value)) {
        if (input.value.trim() !== '') toast(`${JSON.stringify(input.value)} is not a number.`);
        showPoint();
      } else if (input.id === 'edge') tools.setEdgeBefore(value);
      else tools.setAxis(Number(input.dataset.axis), value);
    });
  }
  $('entry').addEventListener('keydown', (event) => {
    if (event.key !== 'Enter') return;
    event.preventDefault();
    event.stopPropagation();
    const entry = $<HTMLInputElement>('entry');
    if (entry.value.trim() === '') {
      tools.finishDrawing();
      return;
    }
    const fault = tools.enter(entry.value);
    if (fault) toast(fault);
    else entry.value = '';
  });
  for (const button of document.querySelectorAll<HTMLElement>('[data-view]')) {
    button.addEventListener('click', () => {
      const views: Record<string, Vec3> = { top: [0, 1, 1e-3], front: [0, 0.02, 1], side: [1, 0.02, 0] };
      const view = views[button.dataset.view!];
      if (view) stage.look(view);
      else stage.fit(true);
    });
  }
  for (const button of document.querySelectorAll<HTMLElement>('[data-mode]')) button.addEventListener('click', () => setMode(button.dataset.mode as typeof mode));
  for (const button of document.querySelectorAll<HTMLElement>('[data-panel]')) button.addEventListener('click', () => showPanel(button.dataset.panel!));
  on('quantity', 'change', () => {
    colour = $<HTMLSelectElement>('quantity').value;
    label(null);
    if (shown) showQuantities(shown.mesh, shown.job.kind, shown.request);
    stage.invalidate();
    keep();
  });
  on('request-box', 'toggle', () => { if ($<HTMLDetailsElement>('request-box').open) showRequest(); });
  on('apply-request', 'click', applyRequest);
  on('save-request', 'click', () => save(new Blob([print({ kind: doc().kind, ...doc().request })], { type: 'application/json' }), `${doc().kind.replaceAll('_', '-')}.json`));
  const file = $<HTMLInputElement>('file');
  file.accept = ACCEPT;
  on('open-file', 'click', () => file.click());
  on('file', 'change', async () => {
    const [chosen] = file.files ?? [];
    if (chosen) await take(() => openFile(chosen), chosen.name);
    file.value = '';
  });
  wireDropAndPaste();

  const galleryBox = $<HTMLDialogElement>('gallery');
  const openGallery = (): void => galleryBox.showModal();
  on('open-gallery', 'click', openGallery);
  on('intro-gallery', 'click', openGallery);
  on('intro-draw', 'click', () => startBlank('minimal_surface'));
  on('open-recent', 'click', showRecent);
  on('open-share', 'click', async () => {
    await showShare('Link');
    $<HTMLDialogElement>('share').showModal();
  });
  on('open-settings', 'click', () => $<HTMLDialogElement>('settings').showModal());
  on('copy', 'click', async () => {
    try {
      await navigator.clipboard.writeText($<HTMLTextAreaElement>('share-text').value);
      $('copied').textContent = 'Copied.';
    } catch {
      $<HTMLTextAreaElement>('share-text').select();
      $('copied').textContent = 'Press Ctrl C: the browser does not let this page copy.';
    }
  });
  on('picture', 'click', async () => {
    save(await stage.picture(2, document.documentElement.dataset.theme === 'dark' ? '#1a2023' : '#f3f4f3'), 'plateau.png');
  });
  for (const dialog of document.querySelectorAll('dialog')) {
    dialog.querySelector('[data-close]')!.addEventListener('click', () => dialog.close());
    dialog.addEventListener('click', (event) => { if (event.target === dialog) dialog.close(); });
  }
  on('theme', 'click', () => {
    const theme = document.documentElement.dataset.theme === 'dark' ? 'light' : 'dark';
    setTheme(theme);
    localStorage.setItem('theme', theme);
  });
  on('api-key', 'change', () => {
    const { value } = $<HTMLInputElement>('api-key');
    api.setKey(value);
    if (value) sessionStorage.setItem('api-key', value);
    else sessionStorage.removeItem('api-key');
    $<HTMLDialogElement>('settings').close();
    if (!ready) void arrive();
  });
  document.addEventListener('keydown', shortcut);
  window.addEventListener('pagehide', keepNow);
  // A link that is put into the address of an open studio changes its hash alone.
  window.addEventListener('hashchange', () => {
    if (location.hash.startsWith('#s=') && ready) void open(linked, (found) => { if (found) openKept(found); });
  });
}

function showPanel(name: string): void {
  document.querySelector('main')!.dataset.panel = name;
  for (const button of document.querySelectorAll<HTMLElement>('[data-panel]:is(button)')) button.setAttribute('aria-pressed', String(button.dataset.panel === name));
}

function wireDropAndPaste(): void {
  document.addEventListener('dragover', (event) => {
    event.preventDefault();
    document.body.classList.add('dropping');
  });
  document.addEventListener('dragleave', (event) => { if (!event.relatedTarget) document.body.classList.remove('dropping'); });
  document.addEventListener('drop', (event) => {
    event.preventDefault();
    document.body.classList.remove('dropping');
    const [file] = event.dataTransfer?.files ?? [];
    const text = event.dataTransfer?.getData('text/plain') ?? '';
    if (file) void take(() => openFile(file), file.name);
    else if (text) void take(() => openText(text), '');
  });
  document.addEventListener('paste', (event) => {
    if ((event.target as HTMLElement).matches('input, textarea')) return;
    const [file] = event.clipboardData?.files ?? [];
    const text = event.clipboardData?.getData('text/plain') ?? '';
    if (file) void take(() => openFile(file), file.name);
    else if (text.trim() !== '') void take(() => openText(text), '');
    else return;
    event.preventDefault();
  });
}

function shortcut(event: KeyboardEvent): void {
  const target = event.target as HTMLElement;
  const typing = target.matches('input:not([type="radio"], [type="checkbox"]), textarea, select') || document.querySelector('dialog[open]') !== null;
  const control = event.ctrlKey || event.metaKey;
  const key = event.key.toLowerCase();
  if (control && !typing && key === 'z') restore(() => (event.shiftKey ? history.redo() : history.undo()));
  else if (control && !typing && key === 'y') restore(() => history.redo());
  else if (tools.drawing && event.key === 'Enter' && !target.matches('button, summary, a')) tools.finishDrawing();
  else if (tools.drawing && event.key === 'Escape') tools.stopDrawing();
  else if (tools.drawing && !typing && !control && /^[\d.,@-]$/.test(event.key)) {
    // A number typed while drawing is the next point.
    const entry = $<HTMLInputElement>('entry');
    entry.focus();
    entry.value += event.key;
  } else return;
  event.preventDefault();
}

interface Kept { kind: Kind; request: Request; draft?: Vec3[] | null; title?: string | null; camera?: Pose; colour?: string; job?: string | null }

/** What the link in the address holds; null without one, and, said in a note, for a damaged one. */
async function linked(): Promise<Kept | null> {
  const [, packed] = /^#s=(.+)$/.exec(location.hash) ?? [];
  if (!packed) return null;
  try {
    const found = await share.unpack(packed) as Kept;
    if (!embedded) window.history.replaceState(null, '', location.pathname + location.search);
    if (found.kind in KINDS && found.request !== null && typeof found.request === 'object') return found;
  } catch {
    // Said below.
  }
  toast('This link is damaged: it does not hold a request.');
  return null;
}

/** What to begin with: a link's content, or what was being worked on; null if there is neither or the address names an example. */
async function begin(): Promise<Kept | null> {
  const found = await linked();
  if (found) return found;
  if (new URLSearchParams(location.search).has('example') || embedded) return null;
  try {
    const work = JSON.parse(sessionStorage.getItem(WORK) ?? localStorage.getItem(WORK) ?? 'null') as Kept | null;
    return work && work.kind in KINDS ? work : null;
  } catch {
    return null;
  }
}

/** A link's content in a studio that is open: one step that can be undone. */
function openKept({ kind, request, title, camera, colour: kept }: Kept): void {
  forget();
  colour = kept ?? 'plain';
  replace(kind, request, title ?? null);
  if (camera) placeWorld(camera);
  changed();
  if (!isWhole(kind, request)) say('');
}

/** What a first visit sees: a canopy on a ring that rises and falls. */
const HERO: Kept = {
  kind: 'minimal_surface', title: 'A saddle canopy',
  request: {
    boundaries: [Array.from({ length: 24 }, (_, i) => {
      const angle = (i * Math.PI) / 12;
      return [7 * Math.cos(angle), 5.5 * Math.sin(angle), 2.6 + 2 * Math.cos(2 * angle)].map((value) => Number(value.toFixed(3)));
    })],
    objective: 'minimal_area', resolution: { triangles: 2000 },
  },
};

const arrive = (): Promise<void> => whileBusy(async () => {
  $('problem').hidden = true;
  try {
    const [document, { objectives: known }, { examples: ready_made }, kept] = await Promise.all([
      api.getJson<OpenApi>('/openapi.json'), api.getJson<{ objectives: Objective[] }>('/v1/objectives'), api.getJson<{ examples: ExampleSummary[] }>('/v1/examples'), begin(),
    ]);
    [openapi, objectives, examples] = [document, known, ready_made];
    showKinds();
    $('gallery-list').replaceChildren(...gallery(examples, ({ name }) => {
      $<HTMLDialogElement>('gallery').close();
      void openExample(name);
    }));
    ready = true;
    if (kept) {
      Object.assign(history.document, { kind: kept.kind, request: kept.request, draft: kept.draft ?? null, title: kept.title ?? null });
      colour = kept.colour ?? 'plain';
      load();
      if (kept.camera) placeWorld(kept.camera);
      const job = kept.job ? await api.getJson<Job>(`/v1/jobs/${kept.job}`).catch(() => null) : null;
      if (job && job.status !== 'cancelled' && job.status !== 'failed') await adopt(job);
      else if (isWhole(kept.kind, kept.request) && doc().draft === null) await solve();
    } else {
      const name = new URLSearchParams(location.search).get('example');
      const example = examples.find((each) => each.name === name);
      const found = example ? await api.getJson<Example>(`/v1/examples/${encodeURIComponent(example.name)}`) : HERO;
      const { kind: _, ...request } = found.request;
      Object.assign(history.document, { kind: found.kind, request, title: found.title });
      load({ direction: FIRST_VIEW });
      $('intro').hidden = example !== undefined;
      showDock();
      await solve();
    }
  } catch (error) {
    showProblem(error);
    say('Not ready.');
    if (error instanceof api.Problem && error.status === 401) $<HTMLDialogElement>('settings').showModal();
  }
});

wire();
// A picture of the model alone, as the gallery has them: no ground.
if (embedded && new URLSearchParams(location.search).get('ground') === 'none') stage.grid.mesh.visible = false;
setTheme(localStorage.getItem('theme') ?? (matchMedia('(prefers-color-scheme: dark)').matches ? 'dark' : 'light'));
showPanel('setup');
$('look').hidden = true;
const storedKey = sessionStorage.getItem('api-key');
if (storedKey) {
  $<HTMLInputElement>('api-key').value = storedKey;
  api.setKey(storedKey);
}
void arrive();

/** For tests, and for whoever opens the console: what is shown, where it is drawn, and how often. */
Object.assign(window, {
  studio: {
    request: () => structuredClone(doc().request), kind: () => doc().kind, draft: () => structuredClone(doc().draft), pose: () => worldPose(), frames: () => stage.frames,
    project: (point: Vec3) => stage.project(host.frame.toScene(point)), lines: (): Line[] => host.lines, faulty: () => [...host.faulty], selection: () => tools.selection,
    points: () => sketch.places.map((place) => stage.project(place)), shown: () => (shown ? { job: shown.job.id, solved: shown.solved, stale: isStale() } : null), draw: () => stage.draw(), fit: () => stage.fit(false), openExample, covers: (x: number, y: number) => surface.pick(stage, x, y) !== null,
    corners: () => host.lines.flatMap((line) => line.points.map(coordinates)), quantity: () => current, humanise,
  },
});
