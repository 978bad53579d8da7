// The axes in a corner of the stage: they turn with the camera, and a press looks along one of them.

import { Vector3 } from 'three';
import { svg } from '../dom';
import type { Frame } from '../model/frame';
import type { Vec3 } from '../model/request';
import type { Stage } from './stage';

const COLOURS = ['#c2413b', '#3d8b4f', '#3a6fb5'];
const LENGTH = 27;

export class Gizmo {
  private arms: { direction: Vec3; line: SVGElement | null; tip: SVGElement }[] = [];

  constructor(private readonly box: SVGElement, private readonly stage: Stage, frame: Frame) {
    this.build(frame);
  }

  build(frame: Frame): void {
    this.arms = [];
    this.box.replaceChildren();
    for (const axis of [0, 1, 2]) {
      for (const sign of [-1, 1]) {
        const own: Vec3 = [0, 0, 0];
        own[axis] = sign;
        const direction: Vec3 = frame.up === 2 ? [own[0], own[2], -own[1]] : own;
        const name = 'XYZ'[axis]!;
        const line = sign > 0 ? svg('line', { stroke: COLOURS[axis]! }) : null;
        const circle = svg('circle', { r: sign > 0 ? 8.5 : 5.5, fill: COLOURS[axis]!, 'fill-opacity': sign > 0 ? 1 : 0.35 });
        const tip = svg('g', { tabindex: 0, role: 'button', 'aria-label': `Look from ${sign > 0 ? '' : 'minus '}${name}` }, circle, ...(sign > 0 ? [svg('text', {}, name)] : []));
        const look = (): void => this.stage.lookAlong([direction[0], direction[1], direction[2] + (Math.abs(direction[1]) > 0.5 ? 1e-3 : 0)]);
        tip.addEventListener('click', look);
        tip.addEventListener('keydown', (event) => { if (['Enter', ' '].includes((event as KeyboardEvent).key)) { event.preventDefault(); look(); } });
        this.arms.push({ direction, line, tip });
      }
    }
    this.place();
  }

  place(): void {
    const turned = this.arms.map((arm) => ({ arm, at: new Vector3(...arm.direction).applyQuaternion(this.stage.camera.quaternion.clone().invert()).multiplyScalar(LENGTH) }));
    turned.sort((a, b) => a.at.z - b.at.z);
    for (const { arm, at } of turned) {
      const [x, y] = [at.x.toFixed(1), (-at.y).toFixed(1)];
      arm.line?.setAttribute('x2', x);
      arm.line?.setAttribute('y2', y);
      arm.tip.setAttribute('transform', `translate(${x} ${y})`);
    }
    // Nearer arms are drawn later; moving an element that has the focus would lose it.
    if (!this.box.contains(document.activeElement)) {
      const order = turned.flatMap(({ arm }) => [arm.line, arm.tip]).filter((each): each is SVGElement => each !== null);
      if (order.some((each, i) => this.box.children[i] !== each)) this.box.append(...order);
    }
  }
}
