// Every objective of a strip as a tile with its own picture; all pictures share the camera.

import { JobFailed, type JobInfo, type Request as ApiRequest } from 'plateau-client';
import { isStatic, plateau } from '../api';
import { $, el } from '../dom';
import { dropRefused, whyNot } from '../model/applies';
import type { Frame } from '../model/frame';
import { type Request, unitOf } from '../model/request';
import { isUnusable, meshOfJob, solveHere } from '../solvers';
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

/**
 * Solves a strip in the page, because a comparison is no result that the service has to keep. The service takes the
 * page's place where its solvers cannot be loaded.
 */
async function solveStrip(request: Request, signal: AbortSignal): Promise<JobInfo> {
  try {
    return await solveHere('ruled_surface', request, { signal }, 'other');
  } catch (error) {
    if (isStatic || !isUnusable(error)) throw error;
  }
  const label = `Compared: ${humanise(String(request.objective))}`;
  const { info } = await plateau.submit({ ...request, kind: 'ruled_surface', label } as unknown as ApiRequest, { waitS: 1 });
  return plateau.waitFor(info, { signal });
}

interface Tile { name: string; box: HTMLElement; facts: HTMLElement; picture: HTMLElement; surface: Surface; statistics: Record<string, unknown> | null }

export class Compare {
  private tiles: Tile[] = [];
  /** Ends what is under way for the tiles that are shown. */
  private stop = new AbortController();

  /** `use` is called with the objective that was chosen. */
  constructor(private readonly stage: Stage, private readonly look: Look, private readonly use: (objective: string) => void) {}

  async open(request: Request, frame: Frame, objectives: string[], fail: (error: unknown) => void): Promise<void> {
    this.close();
    const { signal } = this.stop = new AbortController();
    const names = objectives.filter((name) => whyNot('ruled_surface', request, `objective=${name}`) === null);
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
    for (const tile of this.tiles) if (!signal.aborted) await this.fill(tile, request, frame, signal, fail);
  }

  private async fill(tile: Tile, request: Request, frame: Frame, signal: AbortSignal, fail: (error: unknown) => void): Promise<void> {
    try {
      await this.solve(tile, request, frame, signal);
    } catch (error) {
      if (signal.aborted) return;
      tile.facts.replaceChildren(el('p', { className: 'wait' }, 'This objective found no strip.'));
      fail(error);
    }
  }

  private async solve(tile: Tile, request: Request, frame: Frame, signal: AbortSignal): Promise<void> {
    const asked: Request = { ...request, objective: tile.name, all_objectives: false };
    dropRefused('ruled_surface', asked);
    const job = await solveStrip(asked, signal);
    if (job.status !== 'succeeded') throw new JobFailed(job);
    const mesh = await meshOfJob(job, signal);
    if (signal.aborted) return;
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
    this.stop.abort();
    this.tiles.forEach(({ surface, picture }) => { surface.show(null, '', null as never); picture.remove(); });
    this.tiles = [];
    this.stage.tiles = null;
    $('tiles').hidden = true;
    $('tiles').replaceChildren();
    this.stage.invalidate();
  }
}
