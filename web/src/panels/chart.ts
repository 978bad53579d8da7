// Two small charts with axes: the objective on a linear scale, the residual on a logarithmic one.

import type { HistoryRow } from 'plateau-client';
import { el, svg } from '../dom';
import { number } from '../text';

export interface Sample { iteration: number; phase: string; value: number | null; residual: number | null }

const WIDTH = 300, HEIGHT = 118, RIGHT = 8, TOP = 8, BOTTOM = 22;
/** Size of the labels, as in style.css, and the space between a label and the axis. */
const TEXT = 10, GAP = 6;

const ruler = document.createElement('canvas').getContext('2d');

/** Width of a label. The page's digits are all as wide as the widest, which is wider than a canvas draws them. */
function widthOf(text: string): number {
  if (!ruler) return 7 * text.length;
  ruler.font = `${TEXT}px ${getComputedStyle(document.body).fontFamily}`;
  const digit = Math.max(...[...'0123456789'].map((each) => ruler.measureText(each).width));
  return [...text].reduce((sum, each) => sum + (/\d/.test(each) ? digit : ruler.measureText(each).width), 0);
}

/** The charts of a run that is under way or over; none for fewer than three samples. */
export function charts(samples: Sample[], valueLabel: string, tolerance: number | null): HTMLElement[] {
  const found: HTMLElement[] = [];
  const values = samples.filter((each) => each.value !== null && Number.isFinite(each.value)).map((each, i) => ({ x: i, y: each.value! }));
  const residuals = samples.filter((each) => each.residual !== null && each.residual > 0).map((each, i) => ({ x: i, y: each.residual! }));
  if (values.length >= 3) found.push(chart(valueLabel, values, false, null));
  if (residuals.length >= 3) found.push(chart('Residual', residuals, true, tolerance));
  return found;
}

function chart(label: string, points: { x: number; y: number }[], logarithmic: boolean, floor: number | null): HTMLElement {
  const scale = (y: number): number => (logarithmic ? Math.log10(y) : y);
  const all = points.map(({ y }) => scale(y));
  if (floor !== null && floor > 0) all.push(scale(floor));
  let low = Math.min(...all), high = Math.max(...all);
  if (logarithmic) [low, high] = [Math.floor(low), Math.ceil(high)];
  if (high - low < 1e-12 * Math.max(Math.abs(high), 1e-300)) [low, high] = [low - Math.abs(low || 1) * 0.01, high + Math.abs(high || 1) * 0.01];
  const lastX = points.at(-1)!.x || 1;
  const marks = ticks(low, high, logarithmic);
  // As many digits as it takes to tell one mark from the next.
  const digits = logarithmic ? 4 : Math.min(9, Math.max(4, 1 + Math.ceil(Math.log10(Math.max(Math.abs(low), Math.abs(high)) / Math.abs(marks[1]! - marks[0]!)))));
  const labels = marks.map((tick) => number(logarithmic ? 10 ** tick : tick, digits));
  const left = Math.ceil(Math.max(...labels.map(widthOf))) + GAP + 2;
  const x = (value: number): number => left + ((WIDTH - left - RIGHT) * value) / lastX;
  const y = (value: number): number => HEIGHT - BOTTOM - ((HEIGHT - TOP - BOTTOM) * (value - low)) / (high - low);
  const picture = svg('svg', { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, class: 'chart', role: 'img', 'aria-label': `${label} over ${points.length} steps, from ${number(points[0]!.y, 4)} to ${number(points.at(-1)!.y, 4)}` });
  marks.forEach((tick, i) => {
    picture.append(
      svg('line', { class: 'rule', x1: left, x2: WIDTH - RIGHT, y1: y(tick).toFixed(1), y2: y(tick).toFixed(1) }),
      svg('text', { x: left - GAP, y: (y(tick) + 3.5).toFixed(1), 'text-anchor': 'end' }, labels[i]!),
    );
  });
  picture.append(
    svg('text', { x: left, y: HEIGHT - 6 }, '0'),
    svg('text', { x: WIDTH - RIGHT, y: HEIGHT - 6, 'text-anchor': 'end' }, `${number(points.length - 1)} steps`),
  );
  if (floor !== null && floor > 0) picture.append(svg('path', { class: 'floor', d: `M${left},${y(scale(floor)).toFixed(1)}H${WIDTH - RIGHT}` }));
  picture.append(svg('path', { class: 'curve', d: points.map((point, i) => `${i ? 'L' : 'M'}${x(point.x).toFixed(1)},${y(scale(point.y)).toFixed(1)}`).join('') }));
  return el('figure', { className: 'chart-box' }, el('figcaption', {}, label), picture);
}

function ticks(low: number, high: number, logarithmic: boolean): number[] {
  if (logarithmic) {
    const step = Math.max(1, Math.ceil((high - low) / 3));
    return Array.from({ length: Math.floor((high - low) / step) + 1 }, (_, i) => low + i * step);
  }
  const raw = (high - low) / 3;
  const power = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 5, 10].map((k) => k * power).find((each) => each >= raw) ?? raw;
  const first = Math.ceil(low / step) * step;
  const found: number[] = [];
  for (let tick = first; tick <= high + 1e-9 * step; tick += step) found.push(Math.abs(tick) < 1e-9 * step ? 0 : tick);
  return found.length > 1 ? found : [low, high];
}


export const samplesOf = (rows: HistoryRow[] | undefined | null): Sample[] =>
  (rows ?? []).map((each) => ({ iteration: each.iteration, phase: each.phase, value: each.area ?? null, residual: each.residual ?? null }));
