// The flat pattern over the whole stage: drag to move, wheel to zoom about the pointer.

import type { JobInfo } from 'plateau-client';
import { $ } from '../dom';
import { fileOf } from '../solvers';

export class Flat {
  private url = '';
  /** Counts the patterns that were asked for: a late one does not replace a newer one. */
  private asked = 0;
  private x = 0;
  private y = 0;
  private scale = 1;
  private readonly box = $('flat');
  private readonly image = $<HTMLImageElement>('flat-image');

  constructor() {
    this.box.addEventListener('wheel', (event) => {
      event.preventDefault();
      const { left, top } = this.box.getBoundingClientRect();
      this.zoom(event.clientX - left, event.clientY - top, Math.exp(-event.deltaY * 0.0015));
    }, { passive: false });
    // One pointer moves the pattern, two fingers zoom it as well.
    const held = new Map<number, { x: number; y: number }>();
    /** The middle of the pointers, and their distance from it. */
    const grip = (): { x: number; y: number; reach: number } => {
      const all = [...held.values()];
      const [x, y] = (['x', 'y'] as const).map((axis) => all.reduce((sum, each) => sum + each[axis], 0) / all.length) as [number, number];
      return { x, y, reach: Math.max(...all.map((each) => Math.hypot(each.x - x, each.y - y))) };
    };
    const local = ({ clientX, clientY }: PointerEvent): { x: number; y: number } => {
      const { left, top } = this.box.getBoundingClientRect();
      return { x: clientX - left, y: clientY - top };
    };
    this.box.addEventListener('pointerdown', (event) => {
      this.box.setPointerCapture(event.pointerId);
      held.set(event.pointerId, local(event));
    });
    this.box.addEventListener('pointermove', (event) => {
      if (!held.has(event.pointerId)) return;
      const before = grip();
      held.set(event.pointerId, local(event));
      const after = grip();
      this.x += after.x - before.x;
      this.y += after.y - before.y;
      if (before.reach > 0 && after.reach > 0) this.zoom(after.x, after.y, after.reach / before.reach);
      else this.place();
    });
    for (const type of ['pointerup', 'pointercancel'] as const) this.box.addEventListener(type, (event) => held.delete(event.pointerId));
    this.box.addEventListener('keydown', (event) => {
      const { clientWidth, clientHeight } = this.box;
      if (event.key === '+' || event.key === '=') this.zoom(clientWidth / 2, clientHeight / 2, 1.2);
      else if (event.key === '-') this.zoom(clientWidth / 2, clientHeight / 2, 1 / 1.2);
      else if (event.key === '0') this.fit();
    });
    new ResizeObserver(() => { if (!this.box.hidden) this.fit(); }).observe(this.box);
  }

  async show(job: JobInfo): Promise<void> {
    this.asked += 1;
    const own = this.asked;
    const bytes = await fileOf(job, 'svg');
    if (own !== this.asked) return;
    URL.revokeObjectURL(this.url);
    this.url = URL.createObjectURL(new Blob([bytes], { type: 'image/svg+xml' }));
    this.box.hidden = false;
    this.image.src = this.url;
    await this.image.decode();
    this.fit();
  }

  hide(): void {
    this.asked += 1;
    this.box.hidden = true;
  }

  fit(): void {
    const { clientWidth, clientHeight } = this.box;
    const { naturalWidth, naturalHeight } = this.image;
    if (naturalWidth === 0) return;
    this.scale = 0.9 * Math.min((clientWidth - 24) / naturalWidth, (clientHeight - 150) / naturalHeight);
    this.x = (clientWidth - naturalWidth * this.scale) / 2;
    this.y = (clientHeight - naturalHeight * this.scale) / 2 + 24;
    this.place();
  }

  private zoom(x: number, y: number, factor: number): void {
    this.scale *= factor;
    this.x = x + (this.x - x) * factor;
    this.y = y + (this.y - y) * factor;
    this.place();
  }

  private place(): void {
    const { style } = this.image;
    // A width instead of a transform: the drawing stays sharp at every size.
    style.width = `${this.image.naturalWidth * this.scale}px`;
    style.left = `${this.x}px`;
    style.top = `${this.y}px`;
  }
}
