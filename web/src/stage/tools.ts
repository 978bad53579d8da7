// Pointer and keyboard on the stage: selecting, moving, lifting, inserting and drawing points. What is left over
// orbits.

import { Vector3 } from 'three';
import type { Frame } from '../model/frame';
import { addCable, boundaryRemoved, cableAt, pointInserted, pointRemoved, removeCable, stretch } from '../model/cables';
import type { History } from '../model/history';
import { at, coordinates, isLoose, isShown, KINDS, type Line, type Request, unitOf, type Vec3 } from '../model/request';
import { CLICKS, CLOSED, pointsOf, type Shape } from '../model/shapes';
import { number } from '../text';
import { type PointRef, same, type Sketch } from './sketch';
import type { Stage } from './stage';
import type { Surface } from './surface';

/** Pixels within which the pointer takes hold of a point, of an edge, and snaps while drawing. */
const GRIP = { point: 11, touch: 24, edge: 8, handle: 10, snap: 12, align: 7 };
/** Pixels that a press may travel and still be a click. */
const STILL = 4;
/** The text beside the arrow after the first loop was closed. */
const PROMPT = 'Pull this corner up';
/** A loop of more points is a curve, which has no corners to lift. */
const MOST_CORNERS = 12;
/** Pixels that the arrow which lifts a point is long. */
const ARROW = 52;

export interface Host {
  readonly history: History;
  readonly stage: Stage;
  readonly sketch: Sketch;
  readonly surface: Surface;
  lines: Line[];
  frame: Frame;
  faulty: Set<string>;
  /** The drawing changed; `dragging` while the pointer is still down. */
  changed(dragging: boolean): void;
  /** The selection, or what the pointer would do, changed. */
  selectionChanged(): void;
  /** A line of text beside a pixel, or none. */
  label(text: string | null, x?: number, y?: number, anchor?: Vec3): void;
  /** A point of a tensile structure moved, or is gone. */
  moved(from: Vec3, to: Vec3 | null): void;
  /** Places what `rig` says, at a point, between two, or from a point to a place of the ground. */
  rig(from: PointRef | null, to: PointRef | null, place: Vec3 | null): void;
  /** The surface was clicked. */
  read(point: Vector3, face: number, x: number, y: number): void;
  /** A line with a value was clicked. */
  readLine(point: Vector3, value: string, x: number, y: number): void;
  announce(text: string): void;
  /** The model is only looked at. */
  readonly fixed: boolean;
}

type Mode = 'ground' | 'height';
interface Snap { point: Vec3; how: string; close: boolean }

export class Tools {
  selection: PointRef[] = [];
  mode: Mode = 'ground';
  snapping = true;
  /** What the points that are drawn stand for. */
  shape: Shape = 'points';
  /** The height, in the request's coordinates, at which points are drawn. */
  level = 0;
  /** Where the next point of the drawing would be. */
  private next: Snap | null = null;
  private hover: PointRef | null = null;
  /** The handle in the middle of an edge, at which a point is added; `held` while the pointer is on it. */
  private ghost: { line: number; after: number; point: Vec3; held: boolean } | null = null;
  /** Whether the arrow asks to be pulled, after the first loop was closed. */
  private prompting = false;
  private busy = false;
  /** Whether a click places a cable or another part of a tensile structure. */
  cabling = false;
  /** What a click places: a cable along edges or across the film, a mast, a stay, or a support. */
  rig: 'edge' | 'ridge' | 'mast' | 'stay' | 'hold' = 'edge';
  /** The cable that was clicked; -1 for none. */
  cable = -1;
  /** Places that are measured between, in the request's coordinates; null if nothing is measured. */
  private measured: Vec3[] | null = null;
  /** The point at which a cable of several segments begins. */
  private cableFrom: PointRef | null = null;
  private marquee: HTMLElement;
  /** The fingers on the stage, with where each is now. */
  private readonly fingers = new Map<number, PointerEvent>();
  /** Gives up what the first finger does when a second one comes; null if it does nothing. */
  private letGo: (() => void) | null = null;
  private handingOver = false;

  constructor(private readonly host: Host) {
    const { canvas } = host.stage;
    this.marquee = document.createElement('div');
    this.marquee.className = 'marquee';
    this.marquee.hidden = true;
    canvas.parentElement!.append(this.marquee);
    canvas.addEventListener('pointerdown', (event) => this.press(event), { capture: true });
    for (const type of ['pointermove', 'pointerup', 'pointercancel'] as const) {
      document.addEventListener(type, (event) => {
        if (!this.fingers.has(event.pointerId)) return;
        if (type === 'pointermove') this.fingers.set(event.pointerId, event);
        else this.fingers.delete(event.pointerId);
      }, { capture: true });
    }
    canvas.addEventListener('pointermove', (event) => this.glide(event));
    canvas.addEventListener('pointerleave', () => {
      if (this.busy) return;
      this.hover = null;
      this.ghost = null;
      this.next = null;
      if (this.drawing || this.cabling) host.label(null);
      this.refresh();
    });
    canvas.addEventListener('contextmenu', (event) => event.preventDefault());
    canvas.addEventListener('keydown', (event) => this.key(event));
    host.stage.beforeDraw = () => this.hints();
  }

  /** Whether cables can be drawn: they run along the boundaries of tensile structures. */
  get mayCable(): boolean { return this.host.history.document.kind === 'tensile_structure' && !this.host.fixed; }
  get measuring(): boolean { return this.measured !== null; }
  get drawing(): boolean { return this.host.history.document.draft !== null; }
  get only(): PointRef | null { return this.selection.length === 1 ? this.selection[0]! : null; }

  // ---- Selection ----

  select(refs: PointRef[]): void {
    this.selection = refs;
    if (this.prompting) {
      this.prompting = false;
      this.host.label(null);
    }
    if (refs.length > 0) this.cable = -1;
    this.refresh();
    this.host.selectionChanged();
    const { only } = this;
    const line = only && this.host.lines[only.line];
    if (line) this.host.announce(`${line.name}, point ${only.point + 1} of ${line.points.length}: ${(coordinates(line.points[only.point]) ?? []).map((value) => number(value, 6)).join(', ')}`);
  }

  /** After the lines were made anew: forgets what is no longer there. */
  prune(): void {
    const { lines } = this.host;
    if (!this.mayCable) this.stopCabling();
    if (this.cable >= this.cables) this.cable = -1;
    this.cableFrom = null;
    this.selection = this.selection.filter(({ line, point }) => point < (lines[line]?.points.length ?? 0));
    this.hover = null;
    this.ghost = null;
  }

  refresh(): void {
    const { sketch, stage, faulty } = this.host;
    sketch.mark((ref) => {
      if (ref.line < 0) return 4;
      if (same(this.cableFrom, ref)) return 2;
      if (this.selection.some((each) => same(each, ref))) return 2;
      if (faulty.has(`${ref.line}/${ref.point}`)) return 3;
      return same(this.hover, ref) ? 1 : 0;
    });
    stage.invalidate();
  }

  step(by: number): void {
    const { lines } = this.host;
    const all = lines.flatMap((line, l) => line.points.map((_, p) => ({ line: l, point: p })).filter(({ point }) => isShown(line, point)));
    if (all.length === 0) return;
    const now = all.findIndex((ref) => same(ref, this.selection.at(-1) ?? null));
    this.select([all[now < 0 ? (by > 0 ? 0 : all.length - 1) : (now + by + all.length) % all.length]!]);
  }

  // ---- Finding what is under the pointer ----

  private nearestPoint(x: number, y: number, reach: number): PointRef | null {
    const { stage, sketch, surface } = this.host;
    let best: { ref: PointRef; distance: number; place: Vec3 } | null = null;
    sketch.places.forEach((place, i) => {
      if (sketch.refs[i]!.line < 0) return;
      const seen = stage.project(place);
      const distance = Math.hypot(seen.x - x, seen.y - y);
      if (seen.visible && distance <= reach && (!best || distance < best.distance)) best = { ref: sketch.refs[i]!, distance, place };
    });
    if (!best) return null;
    // A point behind the surface is not there to be gripped, unless it is selected already.
    const { ref, place } = best as { ref: PointRef; place: Vec3 };
    if (this.selection.some((each) => same(each, ref))) return ref;
    const spot = new Vector3(...place);
    const hit = surface.pick(stage, stage.project(place).x, stage.project(place).y);
    const hidden = hit && hit.distance < stage.camera.position.distanceTo(spot) - 14 * stage.pixelAt(spot);
    return hidden ? null : ref;
  }

  /** The edge at a pixel, with its middle. `whole`: near its ends too, and however short it is seen. */
  private nearestEdge(x: number, y: number, whole = false): typeof this.ghost {
    const { stage, lines, frame } = this.host;
    let best: { line: number; after: number; point: Vec3; held: boolean; distance: number } | null = null;
    lines.forEach((line, l) => {
      if (isLoose(line) || line.name.startsWith('control')) return;
      const points = line.points.map(coordinates);
      const last = line.closed && points.length > 2 ? points.length : points.length - 1;
      for (let i = 0; i < last; i += 1) {
        const a = points[i], b = points[(i + 1) % points.length];
        if (!a || !b) continue;
        const p = stage.project(frame.toScene(a)), q = stage.project(frame.toScene(b));
        const length = (q.x - p.x) ** 2 + (q.y - p.y) ** 2;
        if (!p.visible || !q.visible || length < (whole ? 1 : 900)) continue;
        const along = ((x - p.x) * (q.x - p.x) + (y - p.y) * (q.y - p.y)) / length;
        const t = whole ? Math.min(0.9, Math.max(0.1, along)) : along;
        const point = a.map((value, axis) => settle((value + b[axis]!) / 2)) as Vec3;
        const middle = stage.project(frame.toScene(point));
        const held = Math.hypot(middle.x - x, middle.y - y) <= GRIP.handle;
        const distance = held ? 0 : Math.hypot(p.x + t * (q.x - p.x) - x, p.y + t * (q.y - p.y) - y);
        if (t < 0.08 || t > 0.92 || distance > GRIP.edge || (best && distance >= best.distance)) continue;
        best = { line: l, after: i, point, held, distance };
      }
    });
    return best;
  }

  private arrow(): { from: Vector3; to: Vector3 } | null {
    const { only } = this;
    const { stage, frame, lines } = this.host;
    const point = only && coordinates(lines[only.line]?.points[only.point]);
    if (!point || this.drawing || this.cabling || this.measured) return null;
    const from = new Vector3(...frame.toScene(point));
    const length = ARROW * stage.pixelAt(from);
    return { from, to: from.clone().addScaledVector(this.liftAxis(), length) };
  }

  /** Up; or up on the screen where the view looks straight down. */
  private liftAxis(): Vector3 {
    const { camera } = this.host.stage;
    const forward = camera.getWorldDirection(new Vector3());
    return Math.abs(forward.y) > 0.94 ? new Vector3(0, 1, 0).applyQuaternion(camera.quaternion) : new Vector3(0, 1, 0);
  }

  private onArrow(x: number, y: number): boolean {
    const arrow = this.arrow();
    if (!arrow) return false;
    const a = this.host.stage.project(arrow.from.toArray()), b = this.host.stage.project(arrow.to.toArray());
    const length = Math.hypot(b.x - a.x, b.y - a.y);
    if (length < 12) return false;
    const t = ((x - a.x) * (b.x - a.x) + (y - a.y) * (b.y - a.y)) / (length * length);
    const off = Math.abs((x - a.x) * (b.y - a.y) - (y - a.y) * (b.x - a.x)) / length;
    return t > 0.35 && t < 1.25 && off < 11;
  }

  // ---- Pointer ----

  private glide(event: PointerEvent): void {
    if (this.busy || event.buttons !== 0 || this.host.fixed) return;
    const { stage, host } = { stage: this.host.stage, host: this.host };
    const { x, y } = stage.local(event);
    if (this.drawing) {
      this.next = this.snap(x, y, event.altKey);
      this.showNext(x, y);
      stage.canvas.style.cursor = 'crosshair';
      stage.invalidate();
      return;
    }
    if (this.measured) {
      this.hover = this.nearestPoint(x, y, GRIP.point);
      this.ghost = null;
      stage.canvas.style.cursor = 'crosshair';
      this.refresh();
      return;
    }
    if (this.cabling) {
      this.hover = this.nearestPoint(x, y, GRIP.point);
      this.ghost = this.hover ? null : this.nearestEdge(x, y, true);
      stage.canvas.style.cursor = this.hover || this.ghost ? 'pointer' : '';
      this.refresh();
      return;
    }
    const onArrow = this.onArrow(x, y);
    const hover = onArrow ? null : this.nearestPoint(x, y, GRIP.point);
    const ghost = onArrow || hover ? null : this.nearestEdge(x, y);
    const changed = !same(hover, this.hover) || JSON.stringify(ghost) !== JSON.stringify(this.ghost);
    this.hover = hover;
    this.ghost = ghost;
    stage.canvas.style.cursor = onArrow ? 'ns-resize' : hover ? 'grab' : ghost?.held ? 'copy' : '';
    if (changed) {
      this.refresh();
      host.selectionChanged();
    }
  }

  private press(event: PointerEvent): void {
    const { stage, host } = { stage: this.host.stage, host: this.host };
    if (this.handingOver) return;
    stage.canvas.focus({ preventScroll: true });
    const touch = event.pointerType === 'touch';
    if (touch) this.fingers.set(event.pointerId, event);
    // Two fingers move the camera, whatever the first one began.
    if (this.fingers.size > 1) {
      this.letGo?.();
      return;
    }
    if (event.button !== 0 || this.busy || this.host.fixed) return;
    const start = stage.local(event);
    if (this.drawing) {
      this.onRelease(event, (x, y, travelled, last) => {
        if (travelled <= STILL) this.place(this.snap(x, y, last.altKey));
      });
      return;
    }
    if (this.measured) {
      this.onRelease(event, (x, y, travelled) => { if (travelled <= STILL) this.measureAt(x, y); });
      return;
    }
    if (this.cabling) {
      this.onRelease(event, (x, y, travelled) => { if (travelled <= STILL) this.clickCable(x, y, touch); });
      return;
    }
    if (this.onArrow(start.x, start.y)) {
      this.drag(event, this.only!, 'height');
      return;
    }
    const ref = this.nearestPoint(start.x, start.y, touch ? GRIP.touch : GRIP.point);
    if (ref) {
      this.drag(event, ref, this.mode);
      return;
    }
    const ghost = touch ? null : this.nearestEdge(start.x, start.y);
    if (ghost?.held && !event.shiftKey) {
      host.history.begin();
      this.insertAt(ghost.line, ghost.after, ghost.point);
      host.changed(true);
      this.drag(event, { line: ghost.line, point: ghost.after + 1 }, this.mode);
      return;
    }
    if (event.shiftKey) {
      this.selectBox(event);
      return;
    }
    this.onRelease(event, (x, y, travelled) => {
      if (travelled > STILL) return;
      const line = host.surface.pickLine(stage, x, y);
      const hit = host.surface.pick(stage, x, y);
      // A line lies on the surface or before it, unless the surface hides it.
      const eye = stage.camera.position;
      const hidden = line && hit && hit.distance < 0.98 * eye.distanceTo(line.point);
      if (line && !hidden) host.readLine(line.point, line.value, x, y);
      else if (hit) host.read(hit.point, hit.face, x, y);
      else {
        host.label(null);
        if (this.selection.length > 0) this.select([]);
      }
    });
  }

  /** Calls back when this pointer is released on the stage; the camera keeps the pointer meanwhile. */
  private onRelease(event: PointerEvent, done: (x: number, y: number, travelled: number, event: PointerEvent) => void): void {
    const { stage } = this.host;
    const from = stage.local(event);
    let travelled = 0;
    const move = (next: PointerEvent): void => {
      const { x, y } = stage.local(next);
      travelled = Math.max(travelled, Math.hypot(x - from.x, y - from.y));
    };
    const end = (): void => {
      document.removeEventListener('pointermove', move);
      document.removeEventListener('pointerup', up);
      document.removeEventListener('pointercancel', up);
      this.letGo = null;
    };
    const up = (last: PointerEvent): void => {
      if (last.pointerId !== event.pointerId) return;
      end();
      const { x, y } = stage.local(last);
      if (last.type === 'pointerup') done(x, y, travelled, last);
    };
    document.addEventListener('pointermove', move);
    document.addEventListener('pointerup', up);
    document.addEventListener('pointercancel', up);
    this.letGo = end;
  }

  /**
   * Takes the pointer from the camera until it is released. If a second finger comes first, `undo` is called instead of
   * `done`.
   */
  private seize(event: PointerEvent, move: (event: PointerEvent) => void, done: (event: PointerEvent) => void, undo: () => void = () => {}): void {
    const { stage } = this.host;
    this.busy = true;
    stage.controls.enabled = false;
    event.preventDefault();
    try {
      stage.canvas.setPointerCapture(event.pointerId);
    } catch {
      // A pointer that is gone already is released below.
    }
    const moving = (next: PointerEvent): void => { if (next.pointerId === event.pointerId) move(next); };
    const end = (): void => {
      document.removeEventListener('pointermove', moving);
      document.removeEventListener('pointerup', up);
      document.removeEventListener('pointercancel', up);
      this.busy = false;
      this.letGo = null;
      stage.controls.enabled = true;
    };
    const up = (last: PointerEvent): void => {
      if (last.pointerId !== event.pointerId) return;
      end();
      done(last);
    };
    document.addEventListener('pointermove', moving);
    document.addEventListener('pointerup', up);
    document.addEventListener('pointercancel', up);
    this.letGo = () => {
      end();
      undo();
      this.handOver(this.fingers.get(event.pointerId) ?? event);
    };
  }

  /** Tells the camera of a finger that it was not told of when that came down. */
  private handOver({ pointerId, pointerType, clientX, clientY }: PointerEvent): void {
    this.handingOver = true;
    const given = { pointerId, pointerType, clientX, clientY, button: 0, buttons: 1, isPrimary: true, bubbles: true, cancelable: true };
    this.host.stage.canvas.dispatchEvent(new PointerEvent('pointerdown', given));
    this.handingOver = false;
  }

  private drag(event: PointerEvent, ref: PointRef, mode: Mode): void {
    const { host } = this;
    const { stage, history, frame } = host;
    const held = host.lines[ref.line]!.points[ref.point];
    const start = coordinates(held);
    if (!start) return;
    const chosen = this.selection.some((each) => same(each, ref));
    // Shift adds a point to the selection by a click, and lifts it by a drag, which moves no other point unless it
    // was chosen before.
    const before = this.selection;
    if (!chosen) this.select([ref]);
    this.prompting = false;
    const group = this.selection.map((each) => ({ ref: each, from: coordinates(host.lines[each.line]!.points[each.point]) ?? start }));
    const place = new Vector3(...frame.toScene(start));
    const seen = stage.project(place.toArray());
    const from = stage.local(event);
    const grip = { x: from.x - seen.x, y: from.y - seen.y };
    let moved = false;
    history.begin();
    this.seize(event, (next) => {
      const { x, y } = stage.local(next);
      if (!moved && Math.hypot(x - from.x, y - from.y) < 2) return;
      moved = true;
      const vertical = (mode === 'height') !== next.shiftKey;
      const target = vertical ? this.raised(place, y - from.y) : this.grounded(place, x - grip.x, y - grip.y);
      if (!target) return;
      let aim = this.rounded(target, start);
      if (!vertical && this.snapping && !next.altKey) aim = this.onto(x, y, group.map((each) => each.ref)) ?? aim;
      for (const { ref: each, from: was } of group) this.write(each, was.map((value, axis) => settle(value + aim[axis]! - start[axis]!)) as Vec3);
      const spot = stage.project(frame.toScene(aim));
      const unit = unitOf(history.document.request);
      host.label(vertical ? `${'xyz'[frame.up]} ${number(aim[frame.up]!, 6)} ${unit}` : aim.map((value, axis) => `${'xyz'[axis]} ${number(value, 6)}`).join('  '), spot.x, spot.y);
      this.lifting = vertical;
      host.changed(true);
    }, (last) => {
      this.lifting = false;
      host.label(null);
      if (!moved && last.type === 'pointerup') {
        if (!event.shiftKey) this.select([ref]);
        else this.select(chosen ? before.filter((each) => !same(each, ref)) : [...before, ref]);
      }
      if (history.commit()) {
        host.changed(false);
        this.tellMoved();
      }
    }, () => {
      this.lifting = false;
      host.label(null);
      history.abandon();
      if (moved) host.changed(false);
    });
  }

  private lifting = false;

  private selectBox(event: PointerEvent): void {
    const { stage, sketch } = this.host;
    const from = stage.local(event);
    const before = this.selection;
    const { style } = this.marquee;
    this.seize(event, (next) => {
      const { x, y } = stage.local(next);
      const [left, top, right, bottom] = [Math.min(x, from.x), Math.min(y, from.y), Math.max(x, from.x), Math.max(y, from.y)];
      this.marquee.hidden = false;
      Object.assign(style, { left: `${left}px`, top: `${top}px`, width: `${right - left}px`, height: `${bottom - top}px` });
      const inside = sketch.refs.filter((ref, i) => {
        const seen = stage.project(sketch.places[i]!);
        return ref.line >= 0 && seen.visible && seen.x >= left && seen.x <= right && seen.y >= top && seen.y <= bottom;
      });
      this.selection = [...before, ...inside.filter((ref) => !before.some((each) => same(each, ref)))];
      this.refresh();
    }, () => {
      this.marquee.hidden = true;
      this.select(this.selection);
    });
  }

  /** Along the level plane through the start; along the screen if that plane is seen edge-on. */
  private grounded(start: Vector3, x: number, y: number): Vector3 | null {
    const { stage } = this.host;
    const forward = stage.camera.getWorldDirection(new Vector3());
    return stage.onPlane(x, y, start, Math.abs(forward.y) > 0.08 ? new Vector3(0, 1, 0) : forward);
  }

  /** Up and down by as much as the pointer moved up and down, corrected for the angle of view. */
  private raised(start: Vector3, dy: number): Vector3 {
    const { stage } = this.host;
    const steep = new Vector3(0, 1, 0).applyQuaternion(stage.camera.quaternion).y;
    return start.clone().add(new Vector3(0, (-dy * stage.pixelAt(start)) / Math.max(steep, 0.35), 0));
  }

  /** Coordinates no finer than a pixel deserves; those that did not move keep every digit. */
  private rounded(target: Vector3, start: Vec3): Vec3 {
    const { stage, frame } = this.host;
    const step = 10 ** Math.floor(Math.log10(frame.length(stage.pixelAt(target)) * 1.5));
    const found = frame.fromScene(target.toArray());
    const still = 1e-9 * frame.length(stage.radius) + 1e-12 * Math.max(...start.map(Math.abs));
    return found.map((value, axis) => (Math.abs(value - start[axis]!) <= still ? start[axis]! : settle(Math.round(value / step) * step))) as Vec3;
  }

  /** Another line's point under the pointer. */
  private onto(x: number, y: number, moving: PointRef[]): Vec3 | null {
    const { stage, sketch, lines } = this.host;
    const index = sketch.refs.findIndex((ref, i) => {
      if (ref.line < 0 || moving.some((each) => each.line === ref.line)) return false;
      const seen = stage.project(sketch.places[i]!);
      return seen.visible && Math.hypot(seen.x - x, seen.y - y) < GRIP.snap;
    });
    const ref = sketch.refs[index];
    return ref ? coordinates(lines[ref.line]!.points[ref.point]) : null;
  }

  // ---- Measuring ----

  startMeasuring(): void {
    this.stopDrawing();
    this.stopCabling();
    this.measured = [];
    this.select([]);
    this.host.stage.canvas.focus({ preventScroll: true });
  }

  stopMeasuring(): void {
    if (!this.measured) return;
    this.measured = null;
    this.host.label(null);
    this.host.stage.canvas.style.cursor = '';
    this.refresh();
    this.host.selectionChanged();
  }

  /** Takes a point, a place of the surface or of the ground as an end; a third one begins anew. */
  private measureAt(x: number, y: number): void {
    const { stage, frame, lines, surface } = this.host;
    const ref = this.nearestPoint(x, y, GRIP.point);
    const ground = new Vector3(0, stage.grid.mesh.position.y, 0);
    const hit = surface.pick(stage, x, y)?.point ?? stage.onPlane(x, y, ground, new Vector3(0, 1, 0));
    const place = (ref && coordinates(lines[ref.line]!.points[ref.point])) ?? (hit && frame.fromScene(hit.toArray()));
    if (!place) return;
    this.measured = this.measured!.length === 1 ? [this.measured![0]!, place] : [place];
    const [from, to] = this.measured;
    if (from && to) {
      const delta = to.map((value, axis) => value - from[axis]!);
      const text = `${number(Math.hypot(...delta), 4)} ${unitOf(this.host.history.document.request)}`;
      const middle = frame.toScene(from.map((value, axis) => (value + to[axis]!) / 2) as Vec3);
      this.host.label(`${text} (${delta.map((value, axis) => `${'xyz'[axis]} ${number(Number(value.toPrecision(4)), 4)}`).join(', ')})`, 0, 0, middle);
      this.host.announce(text);
    } else this.host.label(null);
    this.refresh();
  }

  // ---- Cables along boundaries ----

  private get cables(): number { return (this.host.history.document.request.cables as unknown[] | undefined)?.length ?? 0; }

  /** Whether the first of two points was chosen. */
  get hasBegun(): boolean { return this.cableFrom !== null; }

  startCabling(rig: Tools['rig'] = 'edge'): void {
    if (!this.mayCable) return;
    this.stopDrawing();
    this.stopMeasuring();
    this.cabling = true;
    this.rig = rig;
    this.cableFrom = null;
    this.cable = -1;
    this.select([]);
    this.host.selectionChanged();
  }

  stopCabling(): void {
    if (!this.cabling) return;
    this.cabling = false;
    this.cableFrom = null;
    this.ghost = null;
    this.host.label(null);
    this.host.stage.canvas.style.cursor = '';
    this.host.selectionChanged();
  }

  chooseCable(cable: number): void {
    this.selection = [];
    this.cable = cable;
    this.refresh();
    this.host.selectionChanged();
    if (cable >= 0) this.host.announce(`Cable ${cable + 1} of ${this.cables}`);
  }

  /** A click on an edge chooses its cable or makes one; a click on a point begins or ends a cable of several edges. */
  private clickCable(x: number, y: number, touch: boolean): void {
    const { stage, frame } = this.host;
    const point = this.nearestPoint(x, y, touch ? GRIP.touch : GRIP.point);
    const edge = point || this.rig !== 'edge' ? null : this.nearestEdge(x, y, true);
    const ground = point ? null : stage.onPlane(x, y, new Vector3(0, stage.grid.mesh.position.y, 0), new Vector3(0, 1, 0));
    this.takeForCable(point, edge, ground && frame.fromScene(ground.toArray()));
  }

  private takeForCable(taken: PointRef | null, edge: typeof this.ghost, place: Vec3 | null): void {
    // Feet of masts and anchors of stays carry nothing.
    const point = taken && !this.host.lines[taken.line]!.only ? taken : null;
    const from = this.cableFrom;
    if (this.rig !== 'edge') {
      this.cableFrom = from || this.rig === 'mast' || this.rig === 'hold' ? null : point;
      if (this.cableFrom === null) this.host.rig(from ?? point, point, place);
      this.refresh();
      this.host.selectionChanged();
    } else if (point && from && from.line === point.line && from.point !== point.point) this.makeCable(point.line, ...this.ordered(from, point.point));
    else if (point) {
      this.cableFrom = same(from, point) ? null : point;
      this.refresh();
      this.host.selectionChanged();
    } else if (edge) {
      const known = cableAt(this.host.history.document.request, edge.line, edge.after);
      if (known >= 0) this.chooseCable(known);
      else this.makeCable(edge.line, edge.after, (edge.after + 1) % this.host.lines[edge.line]!.points.length);
    } else {
      this.cableFrom = null;
      this.chooseCable(-1);
    }
  }

  /** The shorter way between two points of a boundary, in the boundary's direction. */
  private ordered({ line, point }: PointRef, other: number): [number, number] {
    const count = this.host.lines[line]!.points.length;
    return (other - point + count) % count <= count / 2 ? [point, other] : [other, point];
  }

  makeCable(line: number, from: number, to: number): void {
    let made = -1;
    this.cableFrom = null;
    const done = this.host.history.edit(({ request }) => { made = addCable(request, line, from, to); });
    if (done) this.host.changed(false);
    this.chooseCable(made);
  }

  /** A cable from the selected point to the next one, or the one that is there already. */
  cableFromPoint(): void {
    const { only } = this;
    if (!only || !this.mayCable) return;
    const known = cableAt(this.host.history.document.request, only.line, only.point);
    if (known >= 0) this.chooseCable(known);
    else this.makeCable(only.line, only.point, (only.point + 1) % this.host.lines[only.line]!.points.length);
  }

  dropCable(): void {
    const { cable } = this;
    if (cable < 0) return;
    const done = this.host.history.edit(({ request }) => removeCable(request, cable));
    this.cable = -1;
    if (done) this.host.changed(false);
    this.host.selectionChanged();
  }

  /** What the pointer would make or choose, in the scene's coordinates: pairs of ends. */
  private cableHint(): Vec3[] {
    const { lines, frame, history } = this.host;
    const { cableFrom: from, hover, ghost } = this;
    const line = lines[hover?.line ?? ghost?.line ?? -1];
    if (!line) return [];
    const place = (point: number): Vec3 => frame.toScene(coordinates(line.points[point]) ?? [0, 0, 0]);
    const pairs = (points: number[]): Vec3[] => points.slice(1).flatMap((point, i) => [place(points[i]!), place(point)]);
    if (ghost) return pairs([ghost.after, (ghost.after + 1) % line.points.length]);
    if (!from || from.line !== hover!.line || from.point === hover!.point) return [];
    const [a, b] = this.ordered(from, hover!.point);
    return pairs(stretch(history.document.request, { boundary: from.line, from: a, to: b }));
  }

  // ---- Changing points ----

  private write({ line, point }: PointRef, to: Vec3): void {
    const { points } = this.host.lines[line]!;
    const target = points[point];
    const was = this.mayCable && coordinates(target);
    if (Array.isArray(target)) target.splice(0, Math.max(3, target.length), ...to);
    else points[point] = to;
    if (was) this.host.moved(was, to);
  }

  /** Moves the selected points by as much, as one step. */
  moveBy(delta: Vec3): void {
    const { history } = this.host;
    const done = history.edit(() => {
      for (const ref of this.selection) {
        const was = coordinates(this.host.lines[ref.line]!.points[ref.point]);
        if (was) this.write(ref, was.map((value, axis) => settle(value + delta[axis]!)) as Vec3);
      }
    });
    if (!done) return;
    this.host.changed(false);
    this.tellMoved();
  }

  /** Announces where the selected points are after they moved. */
  private tellMoved(): void {
    const { only, host } = this;
    const line = only && host.lines[only.line];
    const place = line && coordinates(line.points[only.point]);
    if (line && place) host.announce(`${line.name}, point ${only.point + 1}: moved to ${place.map((value) => number(value, 6)).join(', ')} ${unitOf(host.history.document.request)}`);
    else if (this.selection.length > 0) host.announce(`${this.selection.length} points moved`);
  }

  /** Sets one coordinate of the selected points. */
  setAxis(axis: number, value: number): void {
    const done = this.host.history.edit(() => {
      for (const ref of this.selection) {
        const was: Vec3 = coordinates(this.host.lines[ref.line]!.points[ref.point]) ?? [0, 0, 0];
        was[axis] = value;
        this.write(ref, was);
      }
    });
    if (!done) return;
    this.host.changed(false);
    this.tellMoved();
  }

  /** The length of the edge before the selected point, which moves along that edge. */
  edgeBefore(): { length: number; previous: Vec3; point: Vec3 } | null {
    const { only } = this;
    const line = only && this.host.lines[only.line];
    if (!line || isLoose(line) || line.points.length < 2) return null;
    const index = only.point > 0 ? only.point - 1 : line.closed ? line.points.length - 1 : -1;
    const point = coordinates(line.points[only.point]), previous = coordinates(line.points[index]);
    return point && previous ? { length: Math.hypot(...point.map((value, axis) => value - previous[axis]!)), previous, point } : null;
  }

  setEdgeBefore(length: number): void {
    const edge = this.edgeBefore();
    const { only } = this;
    if (!edge || !only || !(length > 0) || edge.length === 0) return;
    const to = edge.previous.map((value, axis) => settle(value + ((edge.point[axis]! - value) * length) / edge.length)) as Vec3;
    if (!this.host.history.edit(() => this.write(only, to))) return;
    this.host.changed(false);
    this.tellMoved();
  }

  /** Normals and tangents that a request gives for the points of a line: they come and go with the points. */
  private companions(line: number): unknown[][] {
    const { request } = this.host.history.document;
    const { points, path } = this.host.lines[line]!;
    if (path[0] !== 'directrices') return [];
    return ['normals', 'tangents'].flatMap((name) => {
      const vectors = (request[name] as unknown[][] | undefined | null)?.[path[1] as number];
      return Array.isArray(vectors) && vectors.length === points.length ? [vectors] : [];
    });
  }

  private insertAt(line: number, after: number, point: Vec3): void {
    this.companions(line).forEach((vectors) => vectors.splice(after + 1, 0, structuredClone(vectors[after])));
    if (this.mayCable) pointInserted(this.host.history.document.request, line, after);
    this.host.lines[line]!.points.splice(after + 1, 0, point);
    this.selection = [{ line, point: after + 1 }];
  }

  /** A new point after the selected one: in the middle of its edge, or beyond an open line's end. */
  insert(): void {
    const { only } = this;
    const line = only && this.host.lines[only.line];
    if (!line || line.only) return;
    const here = coordinates(line.points[only.point]);
    const follows = coordinates(line.points[only.point + 1]) ?? (line.closed ? coordinates(line.points[0]) : null);
    if (!here) return;
    const before = coordinates(line.points[only.point - 1]) ?? here.map((value, axis) => value - (axis === 0 ? 1 : 0)) as Vec3;
    const point = here.map((value, axis) => settle(follows ? (value + follows[axis]!) / 2 : 2 * value - before[axis]!)) as Vec3;
    if (this.host.history.edit(() => this.insertAt(only.line, only.point, point))) this.host.changed(false);
    this.select(this.selection);
  }

  /** Removes the selected points, and lines that have none left. */
  remove(): void {
    const { host } = this;
    const { only } = this;
    const path = (only && host.lines[only.line]?.path) ?? [];
    const members = at(host.history.document.request, path.slice(0, 1));
    // A mast or a stay goes with its foot.
    if (path.length === 3 && Array.isArray(members) && this.mayCable) {
      host.history.edit(() => members.splice(Number(path[1]), 1));
      this.selection = [];
      host.changed(false);
      this.select([]);
      return;
    }
    if (this.selection.length === 0 || this.selection.some((ref) => host.lines[ref.line]?.only)) return;
    const [first] = this.selection;
    host.history.edit(() => {
      const gone = [...this.selection].sort((a, b) => b.line - a.line || b.point - a.point);
      for (const { line, point } of gone) {
        this.letGoOf(line, [point]);
        this.companions(line).forEach((vectors) => vectors.splice(point, 1));
        host.lines[line]!.points.splice(point, 1);
        if (this.mayCable) pointRemoved(host.history.document.request, line, point, host.lines[line]!.points.length);
      }
      for (let line = host.lines.length - 1; line >= 0; line -= 1) if (host.lines[line]!.points.length === 0) this.dropLine(line);
    });
    this.selection = [];
    host.changed(false);
    const left = host.lines[first!.line]?.points.length ?? 0;
    this.select(left > 0 && left > 1 ? [{ line: first!.line, point: Math.min(first!.point, left - 1) }] : []);
  }

  removeLine(): void {
    const { host } = this;
    const lines = [...new Set(this.selection.map((ref) => ref.line))].sort((a, b) => b - a);
    if (lines.length === 0 || lines.some((line) => host.lines[line]?.only)) return;
    host.history.edit(() => lines.forEach((line) => this.dropLine(line)));
    this.selection = [];
    host.changed(false);
    this.select([]);
  }

  /** Takes away what ends at points of a tensile structure that are removed. */
  private letGoOf(line: number, points: number[]): void {
    const places = this.mayCable ? points.map((point) => coordinates(this.host.lines[line]!.points[point])) : [];
    for (const place of places) if (place) this.host.moved(place, null);
  }

  private dropLine(line: number): void {
    const { request } = this.host.history.document;
    const { path, points } = this.host.lines[line]!;
    this.letGoOf(line, points.map((_, point) => point));
    const parent = at(request, path.slice(0, -1)) as Record<string, unknown> | unknown[];
    const last = path.at(-1)!;
    if (Array.isArray(parent)) parent.splice(Number(last), 1);
    else delete parent[last];
    if (this.mayCable) boundaryRemoved(request, line);
    if (path[0] === 'directrices') for (const name of ['normals', 'tangents']) if (Array.isArray(request[name])) (request[name] as unknown[]).splice(Number(last), 1);
  }

  // ---- Drawing a new line ----

  startDrawing(): void {
    const { history, stage, lines, frame } = this.host;
    if (this.drawing || KINDS[history.document.kind].lines.length === 0) return;
    this.stopCabling();
    this.stopMeasuring();
    if (!this.shapes.includes(this.shape)) this.shape = 'points';
    history.edit((document) => { document.draft = []; });
    this.select([]);
    const heights = lines.flatMap((line) => line.points.map((point) => coordinates(point)?.[frame.up] ?? Infinity));
    this.level = heights.length > 0 ? Math.min(...heights) : frame.origin[frame.up];
    this.next = null;
    const forward = stage.camera.getWorldDirection(new Vector3());
    if (Math.abs(forward.y) < 0.3) stage.look([0.25, 1.2, 0.6]);
    this.host.changed(false);
    stage.canvas.focus({ preventScroll: true });
  }

  /** Gives up the line that is being drawn. */
  stopDrawing(): void {
    if (!this.drawing) return;
    this.host.history.edit((document) => { document.draft = null; });
    this.endLine();
  }

  /** Points that end a line at least. */
  get least(): number { return CLICKS[this.shape] ?? KINDS[this.host.history.document.kind].least; }
  /** Shapes that the lines of this kind may have: a rail is open. */
  get shapes(): Shape[] { return (['points', 'curve', 'arc', 'rectangle', 'circle'] as const).filter((shape) => KINDS[this.host.history.document.kind].line !== 'rail' || !CLOSED.includes(shape)); }

  /** Adds a point to the line that is being drawn; a snap to its first point ends the line. */
  place(snap: Snap | null): void {
    if (!snap) return;
    if (snap.close) {
      this.finishDrawing();
      return;
    }
    const { history } = this.host;
    const isLast = history.document.draft!.length + 1 === CLICKS[this.shape];
    // The last point of a shape and the shape itself are one step of undo.
    if (isLast) history.begin();
    history.edit((document) => { document.draft!.push(snap.point); });
    if (isLast) {
      this.finishDrawing();
      history.commit();
    } else this.host.changed(false);
  }

  finishDrawing(): boolean {
    const { host } = this;
    const { history } = host;
    const { draft, kind: drawn } = history.document;
    if (!draft || draft.length < this.least) return false;
    const points = pointsOf(this.shape, draft, host.frame.up, KINDS[drawn].line !== 'rail');
    history.edit((document) => {
      const { kind, request } = document;
      const { lines } = KINDS[kind];
      document.draft = null;
      if (kind === 'uniform_mesh') {
        const domain = (request.domain ??= {}) as Record<string, unknown>;
        if (!domain.polygon && !domain.boundaries && !domain.bezier && !domain.nurbs) domain.polygon = points;
        else ((domain.polygon ? (domain.holes ??= []) : (domain.boundaries ??= [])) as unknown[]).push(points);
      } else ((request[lines[0]!] ??= []) as unknown[]).push(points);
    });
    this.endLine();
    this.askForLift();
    return true;
  }

  /** After a line was finished or given up. The keyboard goes on at the stage. */
  private endLine(): void {
    const { host } = this;
    this.next = null;
    host.label(null);
    host.stage.canvas.style.cursor = '';
    host.stage.canvas.focus({ preventScroll: true });
    host.changed(false);
  }

  /** The first loop of a film is flat: its nearest corner is chosen, with the arrow that lifts it. */
  private askForLift(): void {
    const { host } = this;
    const { kind } = host.history.document;
    const [line, ...others] = host.lines;
    const places = line?.points.map(coordinates) ?? [];
    const up = host.frame.up;
    if (!line || others.length > 0 || places.length > MOST_CORNERS || (kind !== 'minimal_surface' && kind !== 'tensile_structure') || places.some((place) => place?.[up] !== places[0]?.[up])) return;
    const eye = host.stage.camera.position;
    const away = places.map((place) => eye.distanceTo(new Vector3(...host.frame.toScene(place ?? [0, 0, 0]))));
    this.select([{ line: 0, point: away.indexOf(Math.min(...away)) }]);
    this.prompting = true;
    host.stage.invalidate();
  }

  /** A length along the present direction, `x, y, z`, or `@dx, dy, dz` from the last point. */
  enter(text: string): string | null {
    const draft = this.host.history.document.draft;
    if (!draft) return null;
    const last = draft.at(-1) ?? null;
    const values = text.replace(/^@/, '').trim().split(/[\s,;]+/).map(Number);
    if (values.length > 3 || values.some((value) => !Number.isFinite(value)) || text.trim() === '') return 'Type a length, or x, y, z.';
    const { up } = this.host.frame;
    const [a, b] = up === 2 ? [0, 1] : [0, 2];
    if (values.length === 1) {
      if (!last) return 'The first point needs x, y, z.';
      const toward = this.next?.point ?? null;
      const along = toward ? toward.map((value, axis) => value - last[axis]!) : [1, 0, 0];
      const size = Math.hypot(...along);
      if (size === 0) return 'Point into a direction first.';
      this.place({ point: last.map((value, axis) => settle(value + (along[axis]! / size) * values[0]!)) as Vec3, how: '', close: false });
      return null;
    }
    const point: Vec3 = [0, 0, 0];
    const base: Vec3 = text.trim().startsWith('@') ? last ?? [0, 0, 0] : [0, 0, 0];
    point[a!] = base[a!]! + values[0]!;
    point[b!] = base[b!]! + values[1]!;
    point[up] = values.length === 3 ? base[up] + values[2]! : text.trim().startsWith('@') ? base[up] : this.level;
    if (up === 1 && values.length === 3) point.splice(0, 3, ...base.map((value, axis) => value + values[axis]!));
    this.place({ point, how: '', close: false });
    return null;
  }

  private snap(x: number, y: number, free: boolean): Snap | null {
    const { stage, sketch, lines, frame, history } = this.host;
    const draft = history.document.draft ?? [];
    const closing = draft.length >= this.least && !CLICKS[this.shape] && KINDS[history.document.kind].line !== 'rail' ? draft[0] : null;
    if (closing) {
      const first = stage.project(frame.toScene(closing));
      if (Math.hypot(first.x - x, first.y - y) < GRIP.snap) return { point: closing, how: 'closes the loop', close: true };
    }
    if (!free && this.snapping) {
      const index = sketch.refs.findIndex((ref, i) => {
        const seen = stage.project(sketch.places[i]!);
        return ref.line >= 0 && seen.visible && Math.hypot(seen.x - x, seen.y - y) < GRIP.snap;
      });
      const ref = sketch.refs[index];
      const point = ref && coordinates(lines[ref.line]!.points[ref.point]);
      if (point) return { point, how: 'on a point', close: false };
    }
    const level: Vec3 = [...frame.origin];
    level[frame.up] = this.level;
    const hit = stage.onPlane(x, y, new Vector3(...frame.toScene(level)), new Vector3(0, 1, 0));
    if (!hit) return null;
    const point = frame.fromScene(hit.toArray());
    point[frame.up] = this.level;
    const pixel = frame.length(stage.pixelAt(hit));
    const ground = frame.up === 2 ? [0, 1] : [0, 2];
    const fine = 10 ** Math.floor(Math.log10(pixel * 1.5));
    const coarse = [1, 2, 5, 10, 20, 50].map((k) => k * fine).find((step) => step >= 9 * pixel) ?? fine;
    let how = '';
    for (const axis of ground) {
      const value = point[axis]!;
      // Straight above or beside the last or the first point.
      const aligned = free || !this.snapping ? undefined : [draft.at(-1), draft[0]].find((other) => other && Math.abs(other[axis]! - value) < GRIP.align * pixel);
      if (aligned) {
        point[axis] = aligned[axis]!;
        how = 'in line';
      } else {
        const step = free || !this.snapping ? fine : coarse;
        point[axis] = settle(Math.round(value / step) * step);
      }
    }
    return { point, how, close: false };
  }

  private showNext(x: number, y: number): void {
    const { host } = this;
    const { next } = this;
    const { draft, request } = host.history.document;
    if (!next || !draft) {
      host.label(null);
      return;
    }
    const last = draft.at(-1);
    const where = next.point.map((value) => number(value, 6)).join(', ');
    const length = last ? Math.hypot(...next.point.map((value, axis) => value - last[axis]!)) : 0;
    host.label([last ? `${number(length, 4)} ${unitOf(request)}` : where, next.how].filter(Boolean).join(' · '), x, y);
  }

  /** The rubber band, the place to insert, the arrow that lifts and the drop line below a point. */
  private hints(): void {
    const { sketch, stage, frame, history, lines } = this.host;
    const half = Math.tan((stage.camera.fov * Math.PI) / 360);
    sketch.setPixel((2 * half) / stage.height, stage.renderer?.getPixelRatio() ?? 1);
    const segments: Vec3[] = [], faint: Vec3[] = [], lift: Vec3[] = [];
    let ghost: Vec3 | null = null;
    const { draft } = history.document;
    if (draft && this.next) {
      const to = frame.toScene(this.next.point);
      ghost = to;
      const closed = KINDS[history.document.kind].line !== 'rail';
      if (draft.length > 0 && this.shape === 'points') segments.push(frame.toScene(draft.at(-1)!), to);
      if (draft.length > 1 && closed && this.shape === 'points') faint.push(to, frame.toScene(draft[0]!));
      if (draft.length > 0 && this.shape !== 'points') {
        const seen = pointsOf(this.shape, [...draft, this.next.point], frame.up, closed).map((point) => frame.toScene(point));
        const ends = closed ? [...seen, seen[0]!] : seen;
        segments.push(...ends.slice(1).flatMap((point, i) => [ends[i]!, point]));
      }
    } else if (this.measured) {
      const places = this.measured.map((place) => frame.toScene(place));
      if (places.length === 1) ghost = places[0]!;
      else lift.push(...places);
    } else if (this.cabling) segments.push(...this.cableHint());
    else if (this.ghost && !this.busy) ghost = frame.toScene(this.ghost.point);
    const arrow = this.arrow();
    if (this.prompting && !arrow) {
      this.prompting = false;
      this.host.label(null);
    }
    if (arrow) {
      const tip = arrow.to.toArray();
      const side = new Vector3(1, 0, 0).applyQuaternion(stage.camera.quaternion);
      const size = arrow.from.distanceTo(arrow.to);
      const base = arrow.to.clone().addScaledVector(arrow.to.clone().sub(arrow.from), -0.24);
      if (this.prompting) this.host.label(PROMPT, 0, 0, tip);
      lift.push(arrow.from.toArray(), tip);
      for (const sign of [-1, 1]) lift.push(base.clone().addScaledVector(side, sign * 0.14 * size).toArray(), tip);
      const { only } = this;
      const point = coordinates(lines[only!.line]!.points[only!.point])!;
      const foot: Vec3 = [...frame.toScene(point)];
      foot[1] = stage.grid.mesh.position.y;
      if (this.lifting || Math.abs(foot[1] - arrow.from.y) > size * 0.3) faint.push(arrow.from.toArray(), foot);
    }
    sketch.hint({ segments, faint, lift, ghost });
  }

  // ---- Keyboard ----

  private key(event: KeyboardEvent): void {
    const { stage, frame, lines } = this.host;
    if (event.ctrlKey || event.metaKey) {
      if (event.key !== 'a') return;
      this.select(lines.flatMap((line, l) => line.points.map((_, p) => ({ line: l, point: p })).filter(({ point }) => isShown(line, point))));
      event.preventDefault();
      return;
    }
    const chosen = this.selection.length > 0 && !this.drawing;
    const ground = frame.up === 2 ? [0, 1] : [0, 2];
    const away = frame.up === 2 ? 1 : -1;
    const moves: Record<string, [number, number]> = {
      ArrowLeft: [ground[0]!, -1], ArrowRight: [ground[0]!, 1], ArrowUp: [ground[1]!, away], ArrowDown: [ground[1]!, -away], PageUp: [frame.up, 1], PageDown: [frame.up, -1],
    };
    const turns: Record<string, [number, number]> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
    const move = moves[event.key];
    if (chosen && move) {
      const step = 10 ** Math.round(Math.log10(frame.length(stage.pixelAt(stage.centre)) * 10)) * (event.shiftKey ? 10 : 1);
      const delta: Vec3 = [0, 0, 0];
      delta[move[0]] = move[1] * step;
      this.moveBy(delta);
    } else if (turns[event.key]) {
      const [x, y] = turns[event.key]!;
      if (event.shiftKey) stage.pan(-24 * x, -24 * y);
      else stage.orbit(0.12 * x, 0.12 * y);
    } else if (this.cabling && event.key === 'Enter' && this.only) this.takeForCable(this.only, null, null);
    else if (this.cable >= 0 && (event.key === 'Delete' || event.key === 'Backspace')) this.dropCable();
    else if (chosen && (event.key === 'Delete' || event.key === 'Backspace')) this.remove();
    else if (chosen && (event.key === 'Insert' || event.key === 'Enter')) this.insert();
    else if (event.key === ']') this.step(1);
    else if (event.key === '[') this.step(-1);
    else if (event.key === '+' || event.key === '=') stage.zoom(stage.width / 2, stage.height / 2, 0.85);
    else if (event.key === '-' && !this.drawing) stage.zoom(stage.width / 2, stage.height / 2, 1 / 0.85);
    else if (event.key === 'Escape' && this.measured) this.stopMeasuring();
    else if (event.key === 'Escape' && chosen) this.select([]);
    else return;
    event.preventDefault();
  }
}

/** Without the digits that only binary fractions have. */
const settle = (value: number): number => Number(value.toPrecision(14));

export type { Request };
