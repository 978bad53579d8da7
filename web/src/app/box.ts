// The bounding box of the result, with its three sizes.

import { $, el } from '../dom';
import { metresOf, unitOf, type Vec3 } from '../model/request';
import { type Lines, retire, wideLines } from '../stage/surface';
import { number } from '../text';
import { measures, tagReactions } from './notes';
import { moreLayers } from './result';
import { look, session, stage, surface } from './session';

let isOn = false;
let lines: Lines | null = null;
const button = el('button', { type: 'button', id: 'box', 'aria-pressed': 'false', title: 'Show the box around the result with its sizes', onclick: toggle }, 'Box');

export function offerBox(): void {
  moreLayers.push(button);
  $('layers').append(button);
  measures.of = place;
}

function toggle(): void {
  isOn = !isOn;
  button.setAttribute('aria-pressed', String(isOn));
  tagReactions();
  stage.measure();
  stage.keepInside(true);
}

/** Puts the box around the result. Returns the labels of its sizes, and its corners. */
function place(): { tip: Vec3; text: string }[] {
  if (lines) {
    retire(lines);
    surface.group.remove(lines);
    lines = null;
  }
  const { shown } = session;
  if (!isOn || !shown) return [];
  const { geometry } = shown.mesh;
  geometry.computeBoundingBox();
  const { min, max } = geometry.boundingBox!;
  const corner = (bits: number): Vec3 => [bits & 1 ? max.x : min.x, bits & 2 ? max.y : min.y, bits & 4 ? max.z : min.z];
  const edges = Array.from({ length: 8 }, (_, from) => [1, 2, 4].filter((bit) => !(from & bit)).map((bit) => [from, from | bit] as const)).flat();
  lines = wideLines(new Float32Array(edges.flatMap(([from, to]) => [...corner(from), ...corner(to)])), 1.4, look.ink, undefined, 0.55);
  surface.group.add(lines);
  const { x, y, z } = surface.group.position;
  const unit = unitOf(shown.request);
  const moved = (at: Vec3): Vec3 => [at[0] + x, at[1] + y, at[2] + z];
  // Labels stand at one edge along each axis, on the side from which a model is first seen.
  const sizes = ([[4, 5], [5, 7], [1, 5]] as const).map(([from, to]) => {
    const [a, b] = [corner(from), corner(to)];
    const size = Math.hypot(...a.map((value, axis) => value - b[axis]!)) / metresOf(shown.request);
    return { tip: moved(a.map((value, axis) => (value + b[axis]!) / 2) as Vec3), text: `${number(Number(size.toPrecision(4)), 4)} ${unit}` };
  });
  return [...sizes, ...Array.from({ length: 8 }, (_, bits) => ({ tip: moved(corner(bits)), text: '' }))];
}
