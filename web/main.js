// The studio: a request on the left, the model in the middle, the result on the right.

import * as api from './api.js';
import { Camera } from './camera.js';
import { $, element, number, save } from './dom.js';
import { build, schemaOf } from './form.js';
import { parseGlb } from './glb.js';
import { Handles } from './handles.js';
import { navigate } from './navigate.js';
import { at, blank, KINDS, linesOf, metresOf, place } from './request.js';
import { ResultView } from './result.js';
import { Viewer } from './viewer.js';

const EMPTY = '(empty)';
/** In live mode, a job that takes longer than this is cancelled when its input has changed. */
const PATIENCE_MS = 2000;
const UNDO_STEPS = 200;

const state = {
  openapi: null, objectives: [], examples: [], kind: null, request: {}, lines: [], origin: [0, 0, 0],
  selected: null, drawing: null, undo: [], drafts: {}, run: null, wanted: false,
};

// ---- The model's place: the viewer is in metres, y up, around an origin near the request's points. ----

const world = {
  get upAxis() { return state.request.up === 'y' ? 1 : 2; },
  to(point) {
    const [x, y, z] = [0, 1, 2].map((axis) => ((point[axis] ?? 0) - state.origin[axis]) * metresOf(state.request));
    return this.upAxis === 2 ? [x, z, -y] : [x, y, z];
  },
  from([x, y, z]) {
    const turned = this.upAxis === 2 ? [x, -z, y] : [x, y, z];
    return turned.map((value, axis) => value / metresOf(state.request) + state.origin[axis]);
  },
  length(metres) { return metres / metresOf(state.request); },
};

const camera = new Camera();
const handles = new Handles($('handles'), camera, world, {
  begin: remember, move: movePoint, end: () => changed(), select: selectPoint, remove: deletePoint, insert: insertPoint, step: stepPoint,
});
const viewer = new Viewer($('view'), camera, () => handles.place());
const result = new ResultView(viewer, world, showProblem);
navigate($('view'), camera, () => viewer.invalidate(), (x, y) => state.drawing && drawAt(x, y));
$('no-webgl').hidden = viewer.gl !== null;

function bounds() {
  const points = [...state.lines.flatMap((line) => line.points), ...(state.drawing ?? [])].map((point) => world.to(point));
  if (result.mesh) {
    const { positions, offset } = result.mesh;
    for (let i = 0; i < positions.length; i += 3) points.push([0, 1, 2].map((axis) => positions[i + axis] + offset[axis]));
  }
  if (points.length === 0) return { centre: [0, 0, 0], radius: 5 * metresOf(state.request) };
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  for (const point of points) {
    for (let axis = 0; axis < 3; axis += 1) {
      low[axis] = Math.min(low[axis], point[axis]);
      high[axis] = Math.max(high[axis], point[axis]);
    }
  }
  const centre = low.map((value, axis) => (value + high[axis]) / 2);
  return { centre, radius: Math.max(Math.hypot(...low.map((value, axis) => high[axis] - value)) / 2, 1e-9) };
}

function fit() {
  const { centre, radius } = bounds();
  camera.fit(centre, radius);
  viewer.invalidate();
}

// ---- The request ----

function load(kind, request, { refit = true } = {}) {
  state.kind = kind;
  state.request = request;
  state.selected = null;
  handles.selected = null;
  stopDrawing();
  const radio = document.querySelector(`#kinds input[value="${kind}"]`);
  if (radio) radio.checked = true;
  const schema = schemaOf(state.openapi, KINDS[kind].path);
  build($('options'), state.openapi, schema, state.request, (name) => {
    describeObjective();
    changed({ option: name });
  });
  describeObjective();
  result.forget();
  hideProblem();
  state.lines = linesOf(kind, request);
  const all = state.lines.flatMap((line) => line.points);
  // The middle of the box, so that survey coordinates keep their digits in the viewer's 32 bits.
  state.origin = [0, 1, 2].map((axis) => {
    const values = all.map((point) => point[axis] ?? 0);
    return values.length ? (values.reduce((a, b) => Math.min(a, b)) + values.reduce((a, b) => Math.max(a, b))) / 2 : 0;
  });
  showLines();
  showRequest();
  if (refit) {
    Object.assign(camera, { yaw: 0.6, pitch: 0.5, flat: false });
    fit();
  }
}

function describeObjective() {
  const schema = schemaOf(state.openapi, KINDS[state.kind].path);
  const name = state.request.objective ?? schema?.properties?.objective?.default;
  const found = state.objectives.find((each) => each.kind === state.kind && each.name === name);
  $('formula').textContent = found ? `${found.minimises} [${found.unit}]. ${found.source}.` : '';
}

/** After every change of the request, also while a point is being dragged. */
function changed({ dragging = false, option = null } = {}) {
  if (option === 'closed' || option === 'units' || option === 'up') state.lines = linesOf(state.kind, state.request);
  if (option === 'units' || option === 'up') {
    result.forget();
    showLines();
    fit();
  } else showSketch();
  handles.faulty.clear();
  handles.mark();
  showPoint();
  if (!dragging) showRequest();
  if ($('live').checked) solve();
  else if (result.job && !state.run) say('Changed since it was solved.');
}

function showRequest() {
  $('request').value = JSON.stringify(state.request, null, 1).replace(/\[\s+([^[\]{}]*?)\s+\]/g, (_, inner) => `[${inner.replace(/\s+/g, ' ')}]`);
  $('request-fault').hidden = true;
  $('undo').disabled = state.undo.length === 0;
}

function remember() {
  state.undo.push(JSON.stringify(state.request));
  if (state.undo.length > UNDO_STEPS) state.undo.shift();
  $('undo').disabled = false;
}

function undo() {
  const before = state.undo.pop();
  if (!before) return;
  const { selected } = state;
  load(state.kind, JSON.parse(before), { refit: false });
  if (selected && state.lines[selected.line]?.points[selected.point]) selectPoint(selected.line, selected.point);
  changed();
}

// ---- Points and lines ----

function showLines() {
  state.lines = linesOf(state.kind, state.request);
  handles.show(state.lines);
  $('hint').textContent = handles.tooMany ? 'Too many points for handles: edit them as JSON.' : '';
  showSketch();
  showPoint();
}

/** The input's lines as the viewer draws them. */
function showSketch() {
  const segments = [];
  const join = (points, closed) => {
    const places = points.map((point) => world.to(point));
    const last = closed && places.length > 2 ? places.length : places.length - 1;
    for (let i = 0; i < last; i += 1) segments.push(...places[i], ...places[(i + 1) % places.length]);
  };
  state.lines.forEach((line) => join(line.points, line.closed));
  if (state.drawing) join(state.drawing, false);
  handles.drawn = state.drawing ?? [];
  viewer.setLines('input', new Float32Array(segments), [0, 0, 0], { width: 2.2, color: [0.04, 0.45, 0.52, 1], lift: 2e-4 });
}

function movePoint(line, point, coordinates) {
  const target = state.lines[line].points[point];
  coordinates.forEach((value, axis) => { if (value !== null && axis < target.length) target[axis] = value; });
  changed({ dragging: true });
}

function selectPoint(line, point) {
  state.selected = { line, point };
  handles.selected = state.selected;
  handles.mark();
  showPoint();
  viewer.invalidate();
}

function showPoint() {
  const { selected } = state;
  const line = selected && state.lines[selected.line];
  const point = line?.points[selected.point];
  $('point').hidden = !point;
  $('remove-line').disabled = !point;
  if (!point) return;
  $('point-name').textContent = `${line.name}, ${selected.point + 1} of ${line.points.length}`;
  for (const input of $('point').querySelectorAll('input')) {
    const value = point[Number(input.dataset.axis)];
    input.disabled = value === undefined;
    if (document.activeElement !== input) input.value = value ?? '';
  }
}

function stepPoint(by) {
  if (!state.selected) return;
  const { line, point } = state.selected;
  const count = state.lines[line].points.length;
  let next = { line, point: point + by };
  if (next.point >= count) next = { line: (line + 1) % state.lines.length, point: 0 };
  if (next.point < 0) {
    const previous = (line - 1 + state.lines.length) % state.lines.length;
    next = { line: previous, point: state.lines[previous].points.length - 1 };
  }
  selectPoint(next.line, next.point);
  handles.focusSelected();
}

/** Normals and tangents that a request gives for the points of a line: they come and go with the points. */
function companions(line) {
  const lists = ['normals', 'tangents'].map((name) => state.request[name]?.[line]);
  return lists.filter((vectors) => Array.isArray(vectors) && vectors.length === state.lines[line].points.length);
}

function insertPoint() {
  if (!state.selected) return;
  const { line, point } = state.selected;
  const { points, closed } = state.lines[line];
  const next = point + 1 < points.length ? points[point + 1] : closed ? points[0] : points[point].map((value, axis) => 2 * value - (points[point - 1]?.[axis] ?? value - 1));
  remember();
  const middle = point + 1 < points.length || closed;
  points.splice(point + 1, 0, points[point].map((value, axis) => (middle ? (value + next[axis]) / 2 : next[axis])));
  companions(line).forEach((vectors) => vectors.splice(point + 1, 0, [...vectors[point]]));
  showLines();
  selectPoint(line, point + 1);
  handles.focusSelected();
  changed();
}

function deletePoint() {
  if (!state.selected) return;
  const { line, point } = state.selected;
  const { points } = state.lines[line];
  if (points.length <= 1) {
    removeLine();
    return;
  }
  remember();
  companions(line).forEach((vectors) => vectors.splice(point, 1));
  points.splice(point, 1);
  showLines();
  selectPoint(line, Math.min(point, points.length - 1));
  handles.focusSelected();
  changed();
}

function removeLine() {
  if (!state.selected) return;
  remember();
  const { path } = state.lines[state.selected.line];
  const parent = at(state.request, path.slice(0, -1));
  const last = path.at(-1);
  if (Array.isArray(parent)) parent.splice(last, 1);
  else delete parent[last];
  for (const name of ['normals', 'tangents']) if (Array.isArray(state.request[name])) state.request[name].splice(last, 1);
  state.selected = null;
  handles.selected = null;
  showLines();
  changed();
}

// ---- Drawing a new line: clicks on the ground, Enter or a click on the first point ends it ----

function startDrawing() {
  state.drawing = [];
  $('draw').setAttribute('aria-pressed', 'true');
  $('stage').classList.add('drawing');
  if (Math.abs(camera.axes().back[1]) < 0.5) camera.look(0, Math.PI / 2);
  const { line } = KINDS[state.kind];
  $('hint').textContent = `Click to add the points of the ${firstPolygon() ? 'polygon' : line}. Enter, or a click on its first point, ends it; Escape gives up.`;
  viewer.invalidate();
}

const firstPolygon = () => state.kind === 'uniform_mesh' && !state.request.domain?.polygon;

function stopDrawing() {
  state.drawing = null;
  $('draw').setAttribute('aria-pressed', 'false');
  $('stage').classList.remove('drawing');
  $('hint').textContent = '';
}

function drawAt(x, y) {
  if (state.drawing.length >= KINDS[state.kind].least) {
    const first = camera.project(world.to(state.drawing[0]));
    if (Math.hypot(first.x - x, first.y - y) < 9) {
      finishDrawing();
      return;
    }
  }
  const position = handles.onPlane([camera.target[0], 0, camera.target[2]], { x, y });
  if (!position) return;
  const step = 10 ** Math.floor(Math.log10(world.length(camera.pixel(position))));
  state.drawing.push(world.from(position).map((value) => Number((Math.round(value / step) * step).toPrecision(12))));
  showSketch();
  viewer.invalidate();
}

function finishDrawing() {
  const points = state.drawing;
  const { least, lines, line } = KINDS[state.kind];
  if (points.length < least) {
    $('hint').textContent = `A ${line} needs at least ${least} points.`;
    return;
  }
  stopDrawing();
  remember();
  if (firstPolygon()) state.request.domain = { ...state.request.domain, polygon: points };
  else {
    if (state.kind === 'uniform_mesh') state.request.domain.holes ??= [];
    else state.request[lines[0]] ??= [];
    at(state.request, lines).push(points);
  }
  showLines();
  const made = state.lines.findIndex((each) => each.points === points);
  if (made >= 0) selectPoint(made, 0);
  changed();
}

// ---- Solving ----

const say = (text) => { $('status').textContent = text; };

/** One job at a time; in live mode what changed meanwhile is solved next. */
async function solve() {
  if (state.run) {
    state.wanted = true;
    if (performance.now() - state.run.since > PATIENCE_MS) cancel();
    return;
  }
  const live = $('live').checked;
  const run = { since: performance.now(), job: null, cancelled: false };
  state.run = run;
  state.wanted = false;
  busy(true);
  try {
    await carryOut(run, live);
  } catch (error) {
    showProblem(error);
    say('Not solved.');
  } finally {
    state.run = null;
    busy(false);
  }
  if (state.wanted && $('live').checked) solve();
}

async function carryOut(run, live) {
  const { kind } = state;
  const request = structuredClone(state.request);
  say('Submitting…');
  run.job = await api.submit(KINDS[kind].path, request);
  hideProblem();
  if (run.cancelled) run.job = await api.cancel(run.job);
  if (!api.hasEnded(run.job)) {
    say(run.job.status === 'queued' ? 'Waiting in the queue…' : 'Running…');
    run.job = await api.follow(run.job, showProgress);
  }
  const { job } = run;
  if (job.status === 'failed') {
    showProblem(job.error);
    say('Failed.');
  } else if (job.status === 'cancelled') {
    say('Cancelled.');
  } else {
    const mesh = parseGlb(await api.getBytes(`${job.links.mesh}?format=glb`));
    if (state.kind !== kind) return;
    const superseded = result.job?.live ? result.job : null;
    result.show({ ...job, live }, mesh, request);
    sayHowItWent(job, mesh);
    if (superseded) api.remove(superseded).catch(() => {});
  }
}

function sayHowItWent(job, mesh) {
  const time = (Date.parse(job.finished_at) - Date.parse(job.started_at)) / 1000;
  // The server keeps results: the same request again takes no time.
  const how = time > 0 ? `Solved in ${number(Number(time.toPrecision(3)))} s` : 'Solved before';
  const size = (mesh.triangles.length / 3).toLocaleString('en');
  say(`${how}: ${size} triangles.${job.statistics.converged === false ? ' Not converged.' : ''}`);
}

function busy(is) {
  $('solve').disabled = is && !$('live').checked;
  $('cancel').disabled = !is;
  $('running').hidden = !is;
  document.body.setAttribute('aria-busy', String(is));
  if (is) $('progress').removeAttribute('value');
}

function showProgress({ progress }) {
  $('progress').value = progress.fraction;
  const parts = [
    progress.phase && progress.phase.replaceAll('_', ' '),
    progress.iteration > 0 && `iteration ${progress.iteration}`,
    Number.isFinite(progress.objective_value) && `objective ${number(progress.objective_value)}`,
    Number.isFinite(progress.residual) && `residual ${number(progress.residual)}`,
  ];
  say(`${Math.round(progress.fraction * 100)} % · ${parts.filter(Boolean).join(' · ')}`);
}

/** Cancels on the server; a job that is still being submitted, as soon as it has an id. */
async function cancel() {
  const { run } = state;
  if (!run) return;
  run.cancelled = true;
  if (!run.job) return;
  try {
    await api.cancel(run.job);
  } catch (error) {
    showProblem(error);
  }
}

function hideProblem() {
  $('problem').hidden = true;
  handles.faulty.clear();
  handles.mark();
}

/** A problem document, a failed job's error, or a defect of this page: what is wrong, and each offending value as a button. */
function showProblem({ title, detail, message, errors = [], omitted = false }) {
  const list = errors.map((error) => {
    const found = place(state.lines, error.pointer);
    if (found.point >= 0) handles.faulty.add(`${found.line}/${found.point}`);
    const control = $('options').elements.namedItem(error.pointer.split('/')[1] ?? '');
    const words = [element('b', {}, found.text), ` ${error.detail}`];
    if (found.line === undefined && !control) return element('li', {}, ...words);
    const button = element('button', { type: 'button' }, ...words);
    button.addEventListener('click', () => {
      if (found.line === undefined) {
        control.closest('details')?.setAttribute('open', '');
        control.focus();
      } else {
        selectPoint(found.line, found.point ?? 0);
        handles.focusSelected();
      }
    });
    return element('li', {}, button);
  });
  if (omitted) list.push(element('li', {}, 'and more'));
  $('problem').replaceChildren(
    element('strong', {}, title ?? 'Something went wrong'),
    detail ?? message ?? '',
    ...(list.length > 0 ? [element('ul', {}, ...list)] : []),
  );
  $('problem').hidden = false;
  handles.mark();
}

// ---- Wiring ----

async function choose(kind, name = state.examples.find((each) => each.kind === kind)?.name) {
  try {
    if (!name || name === EMPTY) {
      const request = blank(kind);
      if (name === EMPTY) {
        if (kind === 'uniform_mesh') request.domain = {};
        else request[KINDS[kind].lines[0]] = [];
      }
      load(kind, request);
      if (name === EMPTY) startDrawing();
    } else {
      const example = await api.getJson(`/v1/examples/${encodeURIComponent(name)}`);
      const { kind: _, ...request } = example.request;
      load(example.kind, request);
    }
    state.undo = [];
    showExamples(name);
    say('Ready.');
    if ($('live').checked && state.lines.length > 0) solve();
  } catch (error) {
    showProblem(error);
  }
}

function showExamples(chosen) {
  const list = state.examples.filter((each) => each.kind === state.kind);
  $('examples').replaceChildren(
    ...list.map((each) => element('option', { value: each.name }, each.title ?? each.name)),
    element('option', { value: EMPTY }, 'Empty: draw your own'),
  );
  $('examples').value = chosen ?? EMPTY;
}

function showKinds() {
  const offered = Object.entries(KINDS).filter(([, { path }]) => schemaOf(state.openapi, path));
  $('kinds').append(...offered.map(([kind, { label }]) => {
    const radio = element('input', { type: 'radio', name: 'kind', value: kind });
    radio.addEventListener('change', () => {
      state.drafts[state.kind] = { request: state.request, example: $('examples').value };
      const draft = state.drafts[kind];
      if (!draft) choose(kind);
      else {
        load(kind, draft.request);
        state.undo = [];
        showExamples(draft.example);
        say('Ready.');
      }
    });
    return element('label', {}, radio, label);
  }));
  return offered.map(([kind]) => kind);
}

function applyRequest() {
  const fault = (text) => {
    $('request-fault').textContent = text;
    $('request-fault').hidden = false;
  };
  let request;
  try {
    request = JSON.parse($('request').value);
  } catch (error) {
    fault(`This is not JSON: ${error.message}`);
    return;
  }
  if (request === null || typeof request !== 'object' || Array.isArray(request)) {
    fault('A request is an object, { … }.');
    return;
  }
  const { kind = state.kind, ...rest } = request;
  if (!schemaOf(state.openapi, KINDS[kind]?.path)) {
    fault(`This server has no kind ${JSON.stringify(kind)}.`);
    return;
  }
  if (kind === state.kind) remember();
  else state.undo = [];
  load(kind, rest);
  showExamples();
  changed();
}

async function openRequest() {
  const [file] = $('request-file').files;
  if (!file) return;
  $('request').value = await file.text();
  $('request-file').value = '';
  applyRequest();
}

function curl() {
  const url = new URL(KINDS[state.kind].path.slice(1), document.baseURI);
  const body = JSON.stringify(state.request).replaceAll("'", String.raw`'\''`);
  return `curl -s -H 'Content-Type: application/json' -H 'Prefer: wait=30' -d '${body}' '${url}'`;
}

function setTheme(theme) {
  document.documentElement.dataset.theme = theme;
  $('theme').setAttribute('aria-pressed', String(theme === 'dark'));
  result.restyle();
}

$('solve').addEventListener('click', () => solve());
$('cancel').addEventListener('click', () => { state.wanted = false; cancel(); });
$('live').addEventListener('change', () => { if ($('live').checked) solve(); });
$('examples').addEventListener('change', (event) => choose(state.kind, event.target.value));
$('draw').addEventListener('click', () => (state.drawing ? (stopDrawing(), showSketch()) : startDrawing()));
$('remove-line').addEventListener('click', removeLine);
$('undo').addEventListener('click', undo);
$('previous-point').addEventListener('click', () => stepPoint(-1));
$('next-point').addEventListener('click', () => stepPoint(1));
$('insert-point').addEventListener('click', insertPoint);
$('delete-point').addEventListener('click', deletePoint);
for (const form of ['point', 'options', 'key-form']) $(form).addEventListener('submit', (event) => event.preventDefault());
for (const input of $('point').querySelectorAll('input')) {
  input.addEventListener('change', () => {
    if (!state.selected || input.value === '') return;
    const next = [null, null, null];
    next[Number(input.dataset.axis)] = input.valueAsNumber;
    remember();
    movePoint(state.selected.line, state.selected.point, next);
    changed();
  });
}
for (const radio of document.querySelectorAll('input[name="move"]')) {
  radio.addEventListener('change', () => { handles.mode = radio.value; });
}
for (const button of document.querySelectorAll('[data-view]')) {
  button.addEventListener('click', () => {
    const views = { top: [0, Math.PI / 2], front: [0, 0], side: [Math.PI / 2, 0] };
    if (button.dataset.view in views) camera.look(...views[button.dataset.view]);
    fit();
  });
}
$('apply-request').addEventListener('click', applyRequest);
$('open-request').addEventListener('click', () => $('request-file').click());
$('request-file').addEventListener('change', openRequest);
$('save-request').addEventListener('click', () => {
  const body = JSON.stringify({ kind: state.kind, ...state.request }, null, 1);
  save(new Blob([body], { type: 'application/json' }), `${state.kind.replaceAll('_', '-')}.json`);
});
$('copy-curl').addEventListener('click', async () => {
  try {
    await navigator.clipboard.writeText(curl());
    say('Copied.');
  } catch {
    say('The browser does not let this page copy.');
  }
});
$('theme').addEventListener('click', () => {
  const theme = document.documentElement.dataset.theme === 'dark' ? 'light' : 'dark';
  setTheme(theme);
  localStorage.setItem('theme', theme);
});
$('api-key').addEventListener('change', () => {
  api.setKey($('api-key').value);
  if ($('api-key').value) sessionStorage.setItem('api-key', $('api-key').value);
  else sessionStorage.removeItem('api-key');
  if (!state.openapi) start();
});
document.addEventListener('keydown', (event) => {
  const typing = event.target.matches?.('input, textarea, select');
  if (state.drawing && event.key === 'Enter') finishDrawing();
  else if (state.drawing && event.key === 'Escape') {
    stopDrawing();
    showSketch();
  } else if (!typing && (event.ctrlKey || event.metaKey) && event.key === 'z') undo();
  else return;
  event.preventDefault();
});

async function start() {
  hideProblem();
  try {
    const [openapi, { objectives }, { examples }] = await Promise.all([
      api.getJson('/openapi.json'), api.getJson('/v1/objectives'), api.getJson('/v1/examples'),
    ]);
    Object.assign(state, { openapi, objectives, examples });
    const kinds = showKinds();
    const wanted = new URLSearchParams(location.search).get('example');
    const example = examples.find((each) => each.name === wanted) ?? examples.find((each) => each.kind === kinds[0]);
    await choose(example?.kind ?? kinds[0], example?.name);
  } catch (error) {
    showProblem(error);
    say('Not ready.');
  }
}

setTheme(localStorage.getItem('theme') ?? (matchMedia('(prefers-color-scheme: dark)').matches ? 'dark' : 'light'));
const storedKey = sessionStorage.getItem('api-key');
if (storedKey) {
  $('api-key').value = storedKey;
  api.setKey(storedKey);
}
start();
