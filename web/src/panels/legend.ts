// The quantity that is looked at: its scale, range and histogram.

import { $, svg } from '../dom';
import { css } from '../stage/colours';
import { histogram, type Quantity } from '../stage/quantities';
import { number } from '../text';

const WIDTH = 220, HEIGHT = 34, BINS = 44;

export function showLegend(q: Quantity | null): void {
  $('scale').hidden = q === null;
  if (!q) return;
  const size = q.scale === 'diverging' && q.id === 'mean_curvature' ? '|H|' : 'All values';
  $('scale-note').textContent = q.nought ? `≈ 0: ${size} below ${number(q.noise, 2)}${q.unit && ` ${q.unit}`}` : `${q.label}${q.unit && ` [${q.unit}]`}`;
  const flat = !q.nought && q.high - q.low <= 1e-6 * Math.max(Math.abs(q.low), Math.abs(q.high));
  const bar = $('scale-bar');
  const steps = 40;
  const stops = Array.from({ length: steps + 1 }, (_, i) => css(q.scale, q.nought || flat ? (q.scale === 'diverging' || flat ? 0.5 : 0) : i / steps));
  bar.style.background = `linear-gradient(to right, ${stops.join(', ')})`;
  $('scale-low').textContent = q.nought ? '' : flat ? '' : number(q.low, 3);
  $('scale-middle').textContent = q.nought ? '≈ 0' : flat ? number(q.high, 5) : q.scale === 'diverging' ? '0' : '';
  $('scale-high').textContent = q.nought ? '' : flat ? '' : number(q.high, 3);
  const counts = histogram(q, BINS);
  const most = Math.max(...counts, 1);
  const box = $('scale-histogram');
  box.hidden = q.nought || flat;
  box.replaceChildren(svg('svg', { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, preserveAspectRatio: 'none', role: 'img', 'aria-label': `Histogram of ${q.values.length} values` },
    ...counts.map((count, i) => {
      // Square roots, so that rare values are seen beside common ones.
      const height = (HEIGHT * Math.sqrt(count)) / Math.sqrt(most);
      return svg('rect', { x: (i * WIDTH) / BINS, y: HEIGHT - height, width: WIDTH / BINS - 0.8, height });
    })));
}
