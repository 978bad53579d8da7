// Every objective of a strip as a tile with its own picture; all pictures share the camera.

import * as api from '../api/client';
import { $, el } from '../dom';
import type { Frame } from '../model/frame';
import { KINDS, type Request, unitOf } from '../model/request';
import { parseMesh } from '../stage/mesh';
import type { Stage } from '../stage/stage';
import { type Look, Surface } from '../stage/surface';
import { humanise, number } from '../text';

/** What a tile tells, and whether more or less of it is better. */
const FACTS: { name: string; label: string; unit: string; better: 'less' | 'more' }[] = [
  { name: 'area', label: 'Area', unit: 'u²', better: 'less' },
  { name: 'total_normal_twist', label: 'Twist', unit: '', better: 'less' },
  { name: 'convex_bridge_ratio', label: 'Convex', unit: '%', better: 'more' },
  { name: 'bending_energy', label: 'Bending', unit: '', better: 'less' },
  { name: 'mean_curvature_variation', label: 'Curvature var.', unit: '', better: 'less' },
  { name: 'largest_fold_deg', label: 'Fold', unit: '°', better: 'less' },
];

interface Tile { name: string; box: HTMLElement; facts: HTMLElement; picture: HTMLElement; surface: Surface; statistics: Record<string, unknown> | null }

export class Compare {
  private tiles: Tile[] = [];
  private turn = 0;

  /** Called with the objective that was chosen. */
  use: (objective: string) => void = () => {};

  constructor(private readonly stage: Stage, private readonly look: Look, private readonly fail: (error: unknown) => void) {}

  async open(request: Request, frame: Frame, objectives: string[]): Promise<void> {
    this.close();
    const turn = this.turn;
    const normals = Array.isArray(request.normals);
    const names = objectives.filter((name) => normals || name !== 'minimal_normal_variation');
    this.tiles = names.map((name) => {
      const button = el('button', { type: 'button', onclick: () => this.use(name) }, 'Use this');
      button.setAttribute('aria-label', `Use this: ${humanise(name)}`);
      const facts = el('div', {}, el('p', { className: 'wait' }, 'Solving…'));
      const picture = el('div', { className: 'picture' });
      const box = el('article', { className: 'tile' }, picture, el('div', { className: 'facts' }, el('header', {}, el('h2', {}, humanise(name)), button), facts));
      box.dataset.objective = name;
      return { name, box, facts, picture, surface: new Surface(this.look), statistics: null };
    });
    $('tiles').replaceChildren(...this.tiles.map(({ box }) => box));
    $('tiles').hidden = false;
    $('tiles').onscroll = () => this.stage.invalidate();
    this.stage.tiles = this.tiles.map(({ picture, surface }) => ({ element: picture, group: surface.group }));
    this.stage.invalidate();
    await Promise.all(this.tiles.map((tile) => this.solve(tile, request, frame, turn).catch((error: unknown) => {
      if (turn !== this.turn) return;
      tile.facts.replaceChildren(el('p', { className: 'wait' }, 'This objective found no strip.'));
      this.fail(error);
    })));
  }

  private async solve(tile: Tile, request: Request, frame: Frame, turn: number): Promise<void> {
    const { secondary_objective: secondary, ...rest } = request;
    const asked = { ...rest, objective: tile.name, all_objectives: false, ...(tile.name === 'maximal_convexity' && secondary ? { secondary_objective: secondary } : {}) };
    let job = await api.submit(KINDS.ruled_surface.path, asked);
    if (!api.hasEnded(job)) job = await api.follow(job, () => {});
    if (job.status !== 'succeeded') throw new api.Problem(job.error ?? {});
    const mesh = await parseMesh(await api.getBytes(`${job.links.mesh}?format=glb`));
    if (turn !== this.turn) return;
    tile.surface.show(mesh, 'ruled_surface', frame);
    tile.statistics = job.statistics as Record<string, unknown>;
    this.report(request);
    this.stage.invalidate();
  }

  /** The figures of all tiles, the best of each in bold. */
  private report(request: Request): void {
    const known = this.tiles.filter((tile) => tile.statistics !== null);
    const best = new Map(FACTS.map(({ name, better }) => {
      const values = known.map((tile) => tile.statistics![name]).filter((value): value is number => typeof value === 'number');
      return [name, better === 'less' ? Math.min(...values) : Math.max(...values)];
    }));
    for (const tile of known) {
      tile.box.classList.toggle('best', tile.name === (request.objective ?? 'minimal_area'));
      tile.facts.replaceChildren(el('dl', {}, ...FACTS.flatMap(({ name, label, unit }) => {
        const value = tile.statistics![name];
        if (typeof value !== 'number') return [];
        const first = Math.abs(value - best.get(name)!) <= 1e-9 * Math.abs(best.get(name)!);
        const shown = unit === '%' ? `${number(100 * value, 3)} %` : `${number(value, 4)}${unit === 'u²' ? ` ${unitOf(request)}²` : unit}`;
        return [el('dt', { title: humanise(name) }, label), el('dd', { className: first ? 'best' : '' }, shown)];
      })));
    }
  }

  restyle(): void {
    this.tiles.forEach(({ surface }) => surface.restyle());
  }

  close(): void {
    this.turn += 1;
    this.tiles.forEach(({ surface, picture }) => { surface.show(null, '', null as never); picture.remove(); });
    this.tiles = [];
    this.stage.tiles = null;
    $('tiles').hidden = true;
    $('tiles').replaceChildren();
    this.stage.invalidate();
  }
}
