// The request's points as handles over the model: drag them, or move the selected one with the keyboard.

import { meet, subtract, add, scale } from './camera.js';
import { svg } from './dom.js';

/** More handles than this hide the model and slow the page; such requests are edited as JSON. */
const MOST_HANDLES = 600;
const UP = [0, 1, 0];

export class Handles {
  /**
   * `world`: { to(point), from(position) } between the request's coordinates and the viewer's.
   * `edit`: { begin(), move(line, point, coordinates), end(), select(line, point), remove(), insert() }.
   */
  constructor(layer, camera, world, edit) {
    Object.assign(this, { layer, camera, world, edit, lines: [], circles: [], drawn: [], selected: null, faulty: new Set(), mode: 'ground' });
  }

  /** Rebuilds the handles; positions follow with `place`. */
  show(lines) {
    this.lines = lines;
    const count = lines.reduce((sum, line) => sum + line.points.length, 0);
    this.tooMany = count > MOST_HANDLES;
    this.circles = [];
    this.layer.replaceChildren();
    if (this.tooMany) return;
    lines.forEach((line, l) => line.points.forEach((_, p) => {
      const circle = svg('circle', { r: count > 240 ? 2.5 : count > 100 ? 3.5 : 6, role: 'button' });
      circle.addEventListener('pointerdown', (event) => this.grab(event, l, p));
      circle.addEventListener('keydown', (event) => this.key(event, l, p));
      circle.addEventListener('focus', () => this.edit.select(l, p));
      this.circles.push({ circle, l, p });
      this.layer.append(circle);
    }));
    this.mark();
  }

  /** Classes, labels and the one place in the tab order. */
  mark() {
    for (const { circle, l, p } of this.circles) {
      const chosen = this.selected?.line === l && this.selected.point === p;
      circle.classList.toggle('selected', chosen);
      circle.classList.toggle('faulty', this.faulty.has(`${l}/${p}`));
      circle.setAttribute('tabindex', chosen || (!this.selected && l === 0 && p === 0) ? 0 : -1);
      circle.setAttribute('aria-label', `${this.lines[l].name}, point ${p + 1}: ${this.lines[l].points[p].join(', ')}`);
    }
  }

  focusSelected() {
    const found = this.circles.find(({ l, p }) => this.selected?.line === l && this.selected.point === p);
    found?.circle.focus({ preventScroll: true });
  }

  /** Puts every handle where the camera sees its point. */
  place() {
    for (const { circle, l, p } of this.circles) {
      const point = this.lines[l]?.points[p];
      if (!point) continue;
      const { x, y, visible } = this.camera.project(this.world.to(point));
      circle.setAttribute('cx', x.toFixed(1));
      circle.setAttribute('cy', y.toFixed(1));
      circle.style.display = visible ? '' : 'none';
    }
    this.layer.querySelectorAll('.drawn').forEach((dot) => dot.remove());
    for (const point of this.drawn) {
      const { x, y } = this.camera.project(this.world.to(point));
      this.layer.append(svg('circle', { class: 'drawn', r: 4, cx: x.toFixed(1), cy: y.toFixed(1) }));
    }
  }

  grab(event, l, p) {
    if (event.button !== 0) return;
    event.preventDefault();
    event.stopPropagation();
    const { circle } = this.circles.find((each) => each.l === l && each.p === p);
    circle.focus({ preventScroll: true });
    circle.setPointerCapture(event.pointerId);
    const start = this.world.to(this.lines[l].points[p]);
    const seen = this.camera.project(start);
    const grip = { x: event.offsetX - seen.x, y: event.offsetY - seen.y };
    let moved = false;
    const move = (next) => {
      const box = this.layer.getBoundingClientRect();
      const at = { x: next.clientX - box.left - grip.x, y: next.clientY - box.top - grip.y };
      if (!moved && Math.hypot(at.x - seen.x, at.y - seen.y) < 2) return;
      if (!moved) this.edit.begin();
      moved = true;
      const vertical = (this.mode === 'height') !== next.shiftKey;
      const target = vertical ? this.raised(start, at, seen) : this.onPlane(start, at);
      if (target) this.edit.move(l, p, this.rounded(target, start));
    };
    const done = () => {
      circle.removeEventListener('pointermove', move);
      circle.removeEventListener('pointerup', done);
      circle.removeEventListener('pointercancel', done);
      if (moved) this.edit.end();
    };
    circle.addEventListener('pointermove', move);
    circle.addEventListener('pointerup', done);
    circle.addEventListener('pointercancel', done);
  }

  /** Along the level plane through the start; along the screen if that plane is seen edge-on. */
  onPlane(start, { x, y }) {
    const { back } = this.camera.axes();
    const normal = Math.abs(back[1]) > 0.08 ? UP : back;
    const hit = meet(this.camera.ray(x, y), start, normal);
    // Beyond the horizon there is no sensible place.
    const far = hit && Math.hypot(...subtract(hit, start)) > 50 * this.camera.radius;
    return far ? null : hit;
  }

  /** Up and down by as much as the pointer moved up and down, corrected for the angle of view. */
  raised(start, { y }, seen) {
    const steepness = Math.max(this.camera.axes().up[1], 0.15);
    return add(start, scale(UP, ((seen.y - y) * this.camera.pixel(start)) / steepness));
  }

  /** Coordinates no finer than a pixel deserves; those that did not move keep every digit. */
  rounded(position, start) {
    const step = 10 ** Math.floor(Math.log10(this.world.length(this.camera.pixel(position))));
    const before = this.world.from(start);
    return this.world.from(position).map((value, axis) => {
      if (Math.abs(value - before[axis]) < 1e-9 * this.world.length(this.camera.radius)) return null;
      return Number((Math.round(value / step) * step).toPrecision(15));
    });
  }

  key(event, l, p) {
    const point = this.lines[l].points[p];
    const step = 10 ** Math.round(Math.log10(this.world.length(this.camera.pixel(this.world.to(point)) * 10))) * (event.shiftKey ? 10 : 1);
    const up = this.world.upAxis;
    const ground = up === 2 ? [0, 1] : [0, 2];
    const away = up === 2 ? 1 : -1;
    const moves = {
      ArrowLeft: [ground[0], -1], ArrowRight: [ground[0], 1], ArrowUp: [ground[1], away], ArrowDown: [ground[1], -away],
      PageUp: [up, 1], PageDown: [up, -1],
    };
    if (event.key in moves) {
      const [axis, sign] = moves[event.key];
      const next = [null, null, null];
      next[axis] = Number(((point[axis] ?? 0) + sign * step).toPrecision(12));
      this.edit.begin();
      this.edit.move(l, p, next);
      this.edit.end();
    } else if (event.key === 'Delete' || event.key === 'Backspace') this.edit.remove();
    else if (event.key === 'Insert' || event.key === 'Enter') this.edit.insert();
    else if (event.key === ']') this.edit.step(1);
    else if (event.key === '[') this.edit.step(-1);
    else return;
    event.preventDefault();
  }
}
