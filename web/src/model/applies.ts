// Options that the rest of a request rules out, each with the reason that the form shows.

import type { Kind } from 'plateau-client';
import { cablesOf } from './cables';
import type { Request } from './request';

interface Rule {
  kind: Kind;
  /** The field, as names joined by dots; for a single choice of a field, `field=choice`. */
  field: string;
  /** Why the field does not apply to a request; null if it does. */
  reason: (request: Request) => string | null;
  /** The service refuses the field where it does not apply. It then goes when another choice rules it out. */
  refused?: boolean;
}

const objective = (request: Request): unknown => request.objective ?? 'minimal_area';
const unless = (holds: (request: Request) => boolean, reason: string) => (request: Request): string | null => (holds(request) ? null : reason);
const hasNormals = unless(({ normals }) => Array.isArray(normals), 'Needs normals along the rails.');

/** A pressure and a volume exclude the same other parts of a structure, and each other. */
const inflated = (other: 'pressure' | 'volume') => (request: Request): string | null => {
  if (typeof request[other] === 'number' && request[other] !== 0) return `Not together with a ${other}.`;
  if (cablesOf(request).some(({ along }) => along)) return 'Not with cables along a boundary.';
  for (const field of ['supports', 'rings', 'layers']) if (Array.isArray(request[field]) && (request[field] as unknown[]).length > 0) return `Not with ${field}.`;
  return null;
};

const woven = ({ film }: Request): boolean => film !== null && typeof film === 'object' && ['warp', 'weft'].some((name) => typeof (film as Request)[name] === 'number');

const layered = unless(({ layers }) => !Array.isArray(layers) || layers.length === 0, 'Each of the layers has its own.');

const RULES: Rule[] = [
  { kind: 'ruled_surface', field: 'secondary_objective', reason: unless((request) => objective(request) === 'maximal_convexity', 'Only with the objective maximal convexity.'), refused: true },
  { kind: 'ruled_surface', field: 'objective=minimal_normal_variation', reason: hasNormals },
  { kind: 'ruled_surface', field: 'objective.weights.minimal_normal_variation', reason: hasNormals },
  { kind: 'ruled_surface', field: 'caps', reason: unless(({ closed }) => closed === true, 'Only with closed rails.') },
  { kind: 'minimal_surface', field: 'certify', reason: unless((request) => objective(request) === 'minimal_area', 'Only with the objective minimal area.'), refused: true },
  { kind: 'minimal_surface', field: 'boundary_curvature', reason: unless((request) => objective(request) === 'minimal_mean_curvature', 'Only with the objective minimal mean curvature.') },
  { kind: 'minimal_surface', field: 'least_squares_tolerance', reason: unless((request) => objective(request) === 'minimal_mean_curvature', 'Only with the objective minimal mean curvature.') },
  { kind: 'minimal_surface', field: 'linear_solver', reason: unless(({ solver }) => solver === 'pinkall_polthier', 'Only with the solver of Pinkall and Polthier.') },
  { kind: 'minimal_surface', field: 'fairing_tolerance', reason: unless(({ solver }) => solver === 'vertex_relaxation', 'Only with the solver vertex relaxation.') },
  { kind: 'uniform_mesh', field: 'max_distinct_lengths', reason: unless(({ optimise }) => optimise === 'lengths', 'Only where the lengths are optimised.') },
  { kind: 'tensile_structure', field: 'pressure', reason: inflated('volume') },
  { kind: 'tensile_structure', field: 'volume', reason: inflated('pressure') },
  { kind: 'tensile_structure', field: 'film.tension', reason: (request) => (woven(request) ? 'Not together with warp and weft.' : layered(request)) },
  { kind: 'tensile_structure', field: 'film.weight', reason: (request) => layered(request) },
  { kind: 'tensile_structure', field: 'film', reason: (request) => layered(request) },
];

/** Why a field, or one of its choices, does not apply to a request; null if it does. */
export const whyNot = (kind: Kind, request: Request, field: string): string | null =>
  RULES.find((rule) => rule.kind === kind && rule.field === field)?.reason(request) ?? null;

/** Removes the fields that the service would refuse beside the others. Gives whether there were any. */
export function dropRefused(kind: Kind, request: Request): boolean {
  const gone = RULES.filter((rule) => rule.kind === kind && rule.refused && request[rule.field] !== undefined && request[rule.field] !== null && rule.reason(request) !== null);
  for (const { field } of gone) delete request[field];
  return gone.length > 0;
}
