// The page's own sentences for the warnings of the service (failures.ts and objectives.ts have the others). They
// count from 1, as people do, while the service counts from 0. Anything else is shown in the service's words.

import { count, number } from './text';

export type Values = Record<string, number>;

/** A number that a sentence needs; it reads `?` if the service did not send it. */
const figure = (values: Values, name: string, digits = 4): string => (values[name] === undefined ? '?' : number(values[name], digits));
/** A place in a list, counted from 1. */
const nth = (values: Values, name: string, more = 0): string => (values[name] === undefined ? '?' : number(values[name] + 1 + more));
const many = (values: Values, name: string, one: string, several?: string): string => count(values[name] ?? 0, one, several);
const spot = (values: Values): string => `(${['x', 'y', 'z'].map((axis) => figure(values, axis)).join(', ')})`;
const verb = (values: Values, name: string, one: string, several: string): string => (values[name] === 1 ? one : several);

/** Sentences of the warnings by code; `u` is the unit of lengths. */
export const WARNINGS: Record<string, (values: Values, u: string) => string> = {
  apex_inside: (v) => `Rail ${nth(v, 'directrix')} is a single point between two strips, so the surface is pinched there.`,
  beyond_support: (v, u) => `The film has slid up to ${figure(v, 'distance')} ${u} beyond the border of support ${nth(v, 'support')}, which goes on flat there. Make the support larger.`,
  closing_corner: (v) => `The film is nearly closed at corner ${nth(v, 'point')} of curve ${nth(v, 'boundary')}: its sides meet at ${figure(v, 'angle_deg', 3)}°.${v.force_factor === undefined ? '' : ` Forces of the cables there that are ${figure(v, 'force_factor', 3)} times as large would open it to 5°.`}`,
  crossing_directrices: (v) => `Rails ${nth(v, 'directrix')} and ${nth(v, 'directrix', 1)} cross or touch between points ${nth(v, 'from')} and ${nth(v, 'to')} of rail ${nth(v, 'directrix')}, so the strip is pinched there.`,
  edge_length_missed: (v, u) => `The edges of the mesh are ${figure(v, 'mean_edge_length')} ${u} long on average, not ${figure(v, 'edge_length')} ${u} as asked for. Ask for a number of triangles to be sure of it.`,
  empty_triangles: (v) => `${many(v, 'count', 'triangle')} of strip ${nth(v, 'strip')} ${verb(v, 'count', 'has', 'have')} no area.`,
  far_from_zero: () => 'The model is so far from zero that an STL file cannot hold its coordinates. The STL file is relative to the origin in the statistics.',
  film: () => 'The film under the lattice has a warning.',
  films_cross: () => 'The films pass through each other or through themselves.',
  folds: (v) => `Strip ${nth(v, 'strip')}: neighbouring triangles fold back, by up to ${figure(v, 'largest_fold_deg')}°.${(v.largest_fold_deg ?? 0) > 179.9999 ? ' A fold of 180° lays one triangle upon the other.' : ''}`,
  held_points: (v) => `${many(v, 'count', 'fixed point')} ${verb(v, 'count', 'holds', 'hold')} the film, but a film cannot hang on a single point: what the mesh shows there shrinks as it gets finer. Draw a small closed curve in place of a point.`,
  identical_directrices: (v) => `Rails ${nth(v, 'directrix')} and ${nth(v, 'directrix', 1)} are the same line, so the strip between them has no area.`,
  joined: (v, u) => `${many(v, 'count', 'point')} ${verb(v, 'count', 'was', 'were')} joined to others that were almost in the same place, by up to ${figure(v, 'distance', 3)} ${u}.`,
  junction_point: (v) => `In ${many(v, 'points', 'point')} a number of junctions other than four meet, for example ${figure(v, 'junctions')}. A soap film would split there.`,
  large_area: (v) => `Strip ${nth(v, 'strip')} has ${figure(v, 'factor', 3)} times the area of the strip of least area.`,
  layers_cross: (v, u) => `Layer ${nth(v, 'layer')} lies in front of the layer above it: the volume between them is ${figure(v, 'volume')} ${u}³. Change the pressures.`,
  lengths_not_reached: (v, u) => `${many(v, 'lengths', 'length')} cannot stand for all members: some differ by up to ${figure(v, 'deviation', 3)} ${u}.`,
  mechanism: () => 'Nothing resists a motion of the structure.',
  merged_points: (v) => `${v.directrix === undefined ? '' : `Rail ${nth(v, 'directrix')}: `}${many(v, 'count', 'point')} ${verb(v, 'count', 'was', 'were')} merged with a neighbour that is equal or nearly equal.`,
  near_critical: (v) => `The film is near its limit and may collapse if the boundary changes a little. Its margin is ${figure(v, 'margin', 3)}, and that of a flat film is 1.`,
  nearly_joined: (v, u) => `An end lies ${figure(v, 'distance', 3)} ${u} beside a point or a side and is not joined to it.`,
  no_certificate: () => 'No lower bound of the area was found.',
  no_connected_film: (v) => `No film connects all boundaries.${v.largest_gap_fraction === undefined ? '' : ` One would if the gap between them were at most ${number(100 * v.largest_gap_fraction, 3)} % as wide.`}`,
  no_lattice: () => 'No edge of the lattice fits into the domain, which is too narrow for this edge length.',
  not_balanced: () => 'The forces within the film could not be balanced, so there are no reactions.',
  not_converged: (v) => (v.residual === undefined ? 'The solver stopped before it met its tolerance.' : `The solver stopped at a residual of ${figure(v, 'residual', 3)}${v.tolerance === undefined ? '' : `, above the tolerance of ${figure(v, 'tolerance', 3)}`}.`),
  not_minimal: (v) => `The solver stopped by its own rule at a residual of ${figure(v, 'residual', 3)}, above the tolerance of ${figure(v, 'tolerance', 3)}. The solver auto comes nearer to a minimal surface.`,
  not_normalised: () => 'One of the weighted objectives can be brought to zero on a strip, so it is not divided by its optimum.',
  opposite_directions: (v) => `Rails ${nth(v, 'directrix')} and ${nth(v, 'directrix', 1)} run in opposite directions.`,
  out_of_range: (v) => `${many(v, 'count', 'member')} ${verb(v, 'count', 'is', 'are')} shorter than the edge length or longer than twice the edge length.`,
  pierces_film: (v) => `${v.mast === undefined ? `Cable ${nth(v, 'cable')}` : `Mast ${nth(v, 'mast')}`} passes through the film at ${spot(v)}. Move its ends, or give the film an opening.`,
  ponding: (v, u) => `Water would stand on the film, up to ${figure(v, 'depth', 3)} ${u} deep, at ${spot(v)}.`,
  projected: (v, u) => `The points were not quite in one plane and were moved into it, by up to ${figure(v, 'distance', 3)} ${u}.`,
  refined: (v) => `A neck of the film needed a finer mesh than was asked for. The mesh has ${figure(v, 'triangles')} triangles.`,
  repeated_bridge: (v) => `Strip ${nth(v, 'strip')} runs all the way round one rail at a single point of the other.`,
  self_intersections: (v) => `${many(v, 'pairs', 'pair')} of triangles ${verb(v, 'pairs', 'crosses or touches', 'cross or touch')}, for example at ${spot(v)}.`,
  shared_points: (v) => `Point ${nth(v, 'point')} of boundary ${nth(v, 'boundary')} is also a point of another boundary. The films only touch there, because each has a vertex of its own.`,
  slack_cable: (v) => (v.cable === undefined ? `${many(v, 'count', 'edge')} ${verb(v, 'count', 'carries', 'carry')} no force by the targets alone. The least force density keeps a force there.` : `Cable ${nth(v, 'cable')} carries no force, because it is longer than the shape needs.`),
  stability_undecided: () => 'Whether the shape is stable cannot be told, because at least one motion changes its energy by less than rounding errors.',
  stress_deviates: (v) => `The stresses along warp and weft differ from those required, by ${number(100 * (v.deviation_rms ?? 0), 3)} % in the root mean square.`,
  strongly_bent: (v) => `${v.strip === undefined ? 'The strip' : `Strip ${nth(v, 'strip')}`} has ${figure(v, 'factor', 3)} times the bending energy of the strip that bends least.`,
  targets_missed: (v) => `${many(v, 'count', 'edge')} ${verb(v, 'count', 'misses its target', 'miss their targets')} by more than half.`,
  topology_changed: (v) => `The film came apart at ${many(v, 'pinches', 'place')}, so it is connected in another way than the mesh it began with.`,
  triangles_missed: (v) => `The mesh has ${figure(v, 'triangles')} triangles, not ${figure(v, 'asked')} as asked for, because of the boundary's own points or of thin triangles that were removed.`,
  unclosed_directrices: (v) => `${many(v, 'count', 'rail')} ${verb(v, 'count', 'ends where it begins', 'end where they begin')}, and the strip is open: its flat pattern begins and ends there. Tick closed rails to join it to itself. Its pattern is then cut at the bridge of least fold, or at one that you name.`,
  unstable: (v) => `The shape is in balance but not a minimum, so it would move away from it. It can do so in ${many(v, 'morse_index', 'independent way')}.`,
};

/** Codes whose sentence leaves out what only the service's own text says. */
const INCOMPLETE = ['film', 'mechanism', 'nearly_joined', 'no_certificate', 'not_balanced', 'not_converged', 'opposite_directions'];

export interface Said { sentence: string; detail: string | null }

/** A warning as the page says it, and the service's text where that says more. */
export function sayWarning(code: string, values: Values, detail: string, unit: string): Said {
  // The detail of this code begins with the code of the film's own warning.
  const [inner, ...rest] = detail.split(': ');
  if (code === 'film' && inner !== undefined && WARNINGS[inner]) {
    const { sentence, detail: more } = sayWarning(inner, values, rest.join(': '), unit);
    return { sentence: `The film under the lattice: ${sentence}`, detail: more };
  }
  const own = WARNINGS[code]?.(values, unit);
  return own === undefined ? { sentence: detail, detail: null } : { sentence: own, detail: INCOMPLETE.includes(code) ? detail : null };
}

/** Names of figures that say too little or too much when they are spelled out. */
export const FIGURES: Record<string, string> = {
  'stability.stable': 'Stable', 'stability.morse_index': 'Morse index', 'stability.lowest_eigenvalue': 'Lowest eigenvalue', 'stability.method': 'Found by',
  'edge_lengths.min': 'Shortest', 'edge_lengths.max': 'Longest', 'edge_lengths.mean': 'Mean', 'edge_lengths.std_dev': 'Standard deviation',
  'angles_deg.min': 'Smallest (°)', 'angles_deg.max': 'Largest (°)', 'self_intersections': 'Crossing pairs of triangles', 'stop_reason': 'Stopped by',
};

/**
 * Dimensions of figures by the last part of their path; `u` is the unit of lengths and `F` that of forces. The first
 * that fits counts.
 */
const DIMENSIONS: [RegExp, string][] = [
  [/(^|\.)(stability|stages\.name|out_of_range_reasons|valence_histogram|node_lower_bound|shared_lengths\.lengths)(\.|$)|(_deg|_ms|_s)(\.|$)|angles_deg/, ''],
  [/(^|\.)(certificate)\.(lower_bound|bound|area)$|(^|\.)(area|initial_area|extrapolated_area|error_estimate|lower_bound)$|extrapolated_area\.|surface\.area$/, 'u²'],
  [/area_error$|deviation$|_ratio$|imbalance$/, ''],
  [/(^|\.)mean_curvature\.|curvature_radius/, '1/u'],
  [/(^|\.)volume$/, 'u³'],
  [/(^|\.)pressure$/, 'F/u²'],
  [/(^|\.)stress\.(min|max)$|force_per_length|force_densities|(^|\.)force_density/, 'F/u'],
  [/(^|\.)(force|force_min|force_max|force_unit|residual_force|magnitudes|loads|reactions\.force|axial_force)$|balance\.(loads|reactions)$/, 'F'],
  [/load_path$/, 'F u'],
  [/(^|\.)(edge_lengths|lattice_edges|all|lattice)\.(min|max|mean|std_dev)$|(^|\.)(length|unstressed_length|sag|width|height|depth|shortest_bridge|longest_bridge|length_tolerance|distance_max|distance|origin|minimum_slope_at|at|from)$|length_histogram\./, 'u'],
];

/** The unit of a figure; empty for counts, ratios and figures without a dimension. */
export function unitOfFigure(path: string, objective: unknown, unit: string, force: string): string {
  if (path === 'length_histogram.counts') return '';
  const dimension = path === 'objective_value' && objective === 'minimal_area' ? 'u²' : DIMENSIONS.find(([pattern]) => pattern.test(path))?.[1] ?? '';
  return dimension.replace('F', force).replace('u', unit);
}

/** Figures of the solver, which say how a result was found and not what it is. */
export const NUMERICS = [
  'objective_value', 'secondary_value', 'solver', 'initial_mesh', 'euler_characteristic', 'genus', 'initial_area', 'extrapolated_area', 'mean_curvature', 'residual', 'residual_full', 'converged', 'stop_reason',
  'iterations', 'stability', 'edges_swapped', 'flipped_triangles', 'degenerate_triangles', 'self_intersections_skipped', 'balance', 'gradient', 'stages', 'shared_lengths', 'node_lower_bound', 'direction_decided_by',
  'length_tolerance', 'origin', 'normal_variation', 'mean_curvature_variation', 'total_normal_twist', 'contact_angle_deg', 'pinches', 'junctions', 'spanning',
  'flat_pattern.edge_length_error_max', 'surface.area_error',
];
/** Figures of a triangle mesh; of a lattice they are those of its members. */
export const OF_MESH = ['edge_lengths', 'angles_deg', 'vertices', 'components'];
