// The flat pattern over the whole stage. A drag moves the pattern, and the wheel zooms about the pointer. A job of the
// service has the service's drawing with names, angles, sizes and a scale bar. It is printed as the service's PDF.

import { type JobInfo, ProblemError } from 'plateau-client';
import { isStatic, plateau } from '../api';
import { $, el, save } from '../dom';
import { metresOf, type Request, unitOf } from '../model/request';
import { fileOf, isOfPage } from '../solvers';
import { count, number, typed } from '../text';

/** Height of the names and angles on the stage, in pixels, where the whole pattern is shown. */
const TEXT_PX = 9;
/** Bounds of the service on the height of text, and on the page of a PDF, in mm. */
const TEXT_MM = [5, 500] as const, LARGEST_PAGE_MM = 5080;
/** Free room between the pattern and the controls above and below it, in pixels. */
const GAP_PX = 10;

/** A result whose pattern is shown, and the name of its files. */
export interface Drawn { job: JobInfo; request: Request; name: string }
type Statistics = { flat_pattern?: { width: number; height: number }; largest_fold_deg?: number };
type Fail = (error: unknown) => void;

export class Flat {
  private url = '';
  /** Counts the patterns that were asked for: a late one does not replace a newer one. */
  private asked = 0;
  private x = 0;
  private y = 0;
  private scale = 1;
  private drawn: Drawn | null = null;
  private fail: Fail = () => {};
  private readonly box = $('flat');
  private readonly image = $<HTMLImageElement>('flat-image');

  private readonly profile = el('select', { id: 'pattern-profile' }, el('option', { value: 'plain' }, 'Outlines and folds'), el('option', { value: 'sheet-metal' }, 'Sheet metal'));
  private readonly angles = el('input', { type: 'checkbox', id: 'pattern-angles', checked: true });
  private readonly thickness = el('input', { type: 'text', inputMode: 'decimal', id: 'pattern-thickness', value: '1' });
  private readonly radius = el('input', { type: 'text', inputMode: 'decimal', id: 'pattern-radius', placeholder: 'as thick' });
  private readonly relief = el('input', { type: 'checkbox', id: 'pattern-relief' });
  private readonly paper = el('select', { id: 'pattern-paper' }, el('option', { value: '' }, 'One page'), el('option', { value: 'a3' }, 'A3 sheets'), el('option', { value: 'a4' }, 'A4 sheets'), el('option', { value: 'fit' }, 'One page, reduced'));
  private readonly size = el('p', { id: 'pattern-size' });
  private readonly fault = el('p', { id: 'pattern-fault', className: 'fault', role: 'alert', hidden: true });
  private readonly metal = el('span', { className: 'row', hidden: true },
    el('label', {}, el('span', {}, 'Thickness mm'), this.thickness), el('label', {}, el('span', {}, 'Radius mm'), this.radius), el('label', { className: 'check' }, this.relief, 'Relief'));
  private readonly plain = el('label', { className: 'check' }, this.angles, 'Angles');
  /** What only the service can do. */
  private readonly served = el('div', { className: 'row' }, el('label', {}, el('span', {}, 'Drawing'), this.profile), this.plain, this.metal);
  private readonly files = el('div', { className: 'row' },
    el('button', { type: 'button', id: 'pattern-print', className: 'primary', onclick: () => void this.print() }, 'Print PDF'),
    el('label', {}, el('span', {}, 'on'), this.paper),
    ...(['svg', 'dxf', 'pdf'] as const).map((format) => el('button', { type: 'button', 'data-format': format, onclick: () => void this.download(format) }, format.toUpperCase())),
    el('button', { type: 'button', 'data-format': 'zip', title: 'Closed cut lines as DXF, one file for each piece', onclick: () => void this.download('zip') }, 'Cut lines'));
  private readonly bar = el('form', { id: 'flat-bar', className: 'card-panel', hidden: true, 'aria-label': 'Flat pattern', autocomplete: 'off' }, this.size, this.served, this.files, this.fault);

  constructor() {
    $('stage').append(this.bar);
    this.bar.addEventListener('submit', (event) => event.preventDefault());
    for (const input of [this.profile, this.angles, this.thickness, this.radius, this.relief]) input.addEventListener('change', () => void this.redraw());
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

  /** Whether the service has the result, whose drawings are then the service's. */
  private get isServed(): boolean { return this.drawn !== null && !isOfPage(this.drawn.job) && !isStatic; }

  async show(drawn: Drawn, fail: Fail): Promise<void> {
    this.drawn = drawn;
    this.fail = fail;
    await this.redraw();
  }

  private async redraw(): Promise<void> {
    const { drawn } = this;
    if (!drawn) return;
    this.asked += 1;
    const own = this.asked;
    this.metal.hidden = this.profile.value !== 'sheet-metal';
    this.plain.hidden = !this.metal.hidden;
    try {
      const bytes = this.isServed ? await this.fetch('svg', this.textHeight(drawn)) : await fileOf(drawn.job, 'svg');
      if (own !== this.asked) return;
      await this.put(drawn, new Blob([bytes], { type: 'image/svg+xml' }));
    } catch (error) {
      if (own === this.asked) this.say(error);
    }
  }

  private async put(drawn: Drawn, drawing: Blob): Promise<void> {
    const [, width = '0', height = '0'] = /width="([\d.]+)mm" height="([\d.]+)mm"/.exec(await drawing.text()) ?? [];
    URL.revokeObjectURL(this.url);
    this.url = URL.createObjectURL(drawing);
    this.fault.hidden = true;
    for (const each of [this.served, this.paper.parentElement!, ...this.files.querySelectorAll<HTMLElement>('[data-format="pdf"], [data-format="zip"]')]) each.hidden = !this.isServed;
    this.size.textContent = describe(drawn, await drawing.text());
    // A large pattern is printed reduced, unless somebody asks for sheets to be joined.
    const [whole] = this.paper.options;
    whole!.disabled = Math.max(Number(width), Number(height)) > LARGEST_PAGE_MM;
    if (whole!.disabled && whole!.selected) this.paper.value = 'fit';
    this.box.hidden = this.bar.hidden = false;
    this.image.src = this.url;
    await this.image.decode();
    this.fit();
  }

  /** A file of the service's. */
  private fetch(format: string, text = 0, profile = this.profile.value): Promise<ArrayBuffer> {
    const query = new URLSearchParams({ profile, format });
    if (profile === 'sheet-metal') {
      for (const [name, input] of [['thickness', this.thickness], ['radius', this.radius]] as const) if (input.value.trim() !== '') query.set(name, String(typed(input.value)));
      if (this.relief.checked) query.set('relief', 'auto');
    } else if (profile === 'plain') query.set('angles', String(this.angles.checked));
    if (text > 0) query.set('text_height', String(text));
    if (format === 'pdf' && /^a\d/.test(this.paper.value)) query.set('paper', this.paper.value);
    return plateau.send(`v1/jobs/${this.drawn!.job.id}/pattern?${query}`);
  }

  /** The height of text, in mm, at which it can be read where the whole pattern is shown. */
  private textHeight({ job, request }: Drawn): number {
    const { flat_pattern: { width, height } = { width: 0, height: 0 } } = job.statistics as Statistics;
    const pixel = (1000 * metresOf(request) * Math.max(width / (this.box.parentElement!.clientWidth - 60), height / (this.box.parentElement!.clientHeight - 200)));
    return Number(Math.min(Math.max(TEXT_PX * pixel, TEXT_MM[0]), TEXT_MM[1]).toPrecision(3));
  }

  /**
   * Opens the service's PDF, which prints true to scale. The browser prints a reduced drawing, and each one without the
   * service.
   */
  async print(): Promise<void> {
    if (!this.drawn) return;
    if (!this.isServed || this.paper.value === 'fit') {
      print();
      return;
    }
    const file = await this.file('pdf');
    if (!file) return;
    const url = URL.createObjectURL(file);
    // A browser that opens no window gets the file.
    if (!open(url)) save(file, `${this.drawn.name}-pattern.pdf`);
    setTimeout(() => URL.revokeObjectURL(url), 600_000);
  }

  private async download(format: 'svg' | 'dxf' | 'pdf' | 'zip'): Promise<void> {
    const file = await this.file(format);
    if (file) save(file, `${this.drawn!.name}-pattern.${format}`);
  }

  /** A file of the pattern; null if it cannot be made, which is said. */
  private async file(format: 'svg' | 'dxf' | 'pdf' | 'zip'): Promise<Blob | null> {
    try {
      const bytes = !this.isServed ? await fileOf(this.drawn!.job, format as 'svg') : format === 'zip' ? await this.fetch('dxf', 0, 'cut') : await this.fetch(format);
      this.fault.hidden = true;
      return new Blob([bytes], { type: format === 'pdf' ? 'application/pdf' : '' });
    } catch (error) {
      this.say(error);
      return null;
    }
  }

  /** A drawing that cannot be made with these values is said beside them; everything else is a problem of the page. */
  private say(error: unknown): void {
    const values = error instanceof ProblemError && (error.status === 400 || error.status === 422);
    if (!values) this.fail(error);
    this.fault.hidden = !values;
    this.fault.textContent = values ? error.detail ?? error.message : '';
    if (values) this.fit();
  }

  hide(): void {
    this.asked += 1;
    this.box.hidden = this.bar.hidden = true;
  }

  fit(): void {
    const { clientWidth, clientHeight } = this.box;
    const { naturalWidth, naturalHeight } = this.image;
    if (naturalWidth === 0) return;
    const [top, bottom] = [$('bar').offsetTop + $('bar').offsetHeight + GAP_PX, this.bar.offsetHeight + 2 * GAP_PX];
    this.scale = 0.94 * Math.min((clientWidth - 24) / naturalWidth, Math.max(clientHeight - top - bottom, 80) / naturalHeight);
    this.x = (clientWidth - naturalWidth * this.scale) / 2;
    this.y = top + (clientHeight - top - bottom - naturalHeight * this.scale) / 2;
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

/** The pieces with their size and folds, in words. */
function describe({ job, request }: Drawn, drawing: string): string {
  const { flat_pattern: size, largest_fold_deg: fold } = job.statistics as Statistics;
  const pieces = [...drawing.matchAll(/<g id="piece-.*?<\/g>/gs)].filter(([piece]) => piece.includes('class="cut"')).length;
  const folds = drawing.match(/class="(?:fold_|bend_(?:up|down))/g)?.length ?? 0;
  return [
    pieces > 0 && count(pieces, 'piece'), size && `${number(size.width, 4)} × ${number(size.height, 4)} ${unitOf(request)}`,
    folds > 0 && `${count(folds, 'fold')}${fold === undefined ? '' : `, the largest of ${number(fold, 3)}°`}`,
  ].filter(Boolean).join(' · ');
}
