// Options that the rest of a request rules out, each with the reason that the form shows.

import type { Kind } from 'plateau-client';
import { cablesOf } from './cables';
import { humanise } from '../text';
import type { Request } from './request';

interface Rule {
  kind: Kind;
  /** The field, as names joined by dots; for a single choice of a field, `field=choice`. */
  field: string;
  /** Why the field does not apply to a request; null if it does. */
  reason: (request: Request) => string | null;
}

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
  { kind: 'ruled_surface', field: 'objective=minimal_normal_variation', reason: hasNormals },
  { kind: 'ruled_surface', field: 'objective.weights.minimal_normal_variation', reason: hasNormals },
  { kind: 'tensile_structure', field: 'pressure', reason: inflated('volume') },
  { kind: 'tensile_structure', field: 'volume', reason: inflated('pressure') },
  { kind: 'tensile_structure', field: 'film.tension', reason: (request) => (woven(request) ? 'Not together with warp and weft.' : layered(request)) },
  { kind: 'tensile_structure', field: 'film.weight', reason: (request) => layered(request) },
  { kind: 'tensile_structure', field: 'film', reason: (request) => layered(request) },
];

/** An objective of the catalogue, with the options that can act with it. */
export interface Objective { name: string; kind: string; options: { name: string; needs: Record<string, string[]>[] }[] }

let catalogue: Objective[] = [];

/** Takes the objectives of the service, which say what each option needs. */
export function useCatalogue(objectives: Objective[]): void {
  catalogue = objectives;
}

/** What a request asks for if it lacks the member. */
const DEFAULTS: Record<string, string> = { solver: 'auto', topology: 'fixed', initial_mesh: 'auto', closed: 'false', optimise: 'nodes', optimise_nodes: 'true' };

/** The value of a member as the catalogue names it. */
function chosen(request: Request, member: string): string {
  const value = request[member] ?? DEFAULTS[member];
  if (value === null || typeof value !== 'object') return String(value);
  return member === 'domain' ? Object.keys(value).find((name) => name !== 'holes') ?? '' : member === 'objective' ? 'weighted' : 'given';
}

const DEFAULT_OBJECTIVES: Partial<Record<Kind, string>> = { minimal_surface: 'minimal_area', ruled_surface: 'minimal_area', uniform_mesh: 'most_equal_edges' };

/** Why an option of the catalogue has no effect in a request; null if it has one. */
function idle(kind: Kind, request: Request, field: string): string | null {
  const own = catalogue.filter((each) => each.kind === kind);
  const withIt = own.filter(({ options }) => options.some(({ name }) => name === field));
  if (withIt.length === 0) return null;
  const asked = request.objective === undefined ? DEFAULT_OBJECTIVES[kind] : chosen(request, 'objective');
  // A weighted sum is no entry of the catalogue. It has the options that every objective has.
  const objective = asked === 'weighted' ? withIt.length === own.length && withIt[0] : withIt.find(({ name }) => name === asked);
  if (!objective && own.length > 1) return `Only with the objective ${withIt.map(({ name }) => humanise(name).toLowerCase()).join(' or ')}.`;
  const needs = (objective || withIt[0]!).options.find(({ name }) => name === field)!.needs;
  if (needs.length === 0 || needs.some((all) => Object.entries(all).every(([member, values]) => values.includes(chosen(request, member))))) return null;
  const phrase = (all: Record<string, string[]>): string => Object.entries(all).map(([member, values]) => `${humanise(member).toLowerCase()} ${values.map((value) => humanise(value).toLowerCase()).join(' or ')}`).join(' and ');
  return `Only with ${needs.map(phrase).join(', or with ')}.`;
}

/** Why a field, or one of its choices, does not apply to a request; null if it does. */
export const whyNot = (kind: Kind, request: Request, field: string): string | null =>
  RULES.find((rule) => rule.kind === kind && rule.field === field)?.reason(request) ?? idle(kind, request, field);

/** Removes the options that the service would refuse beside the others. Gives whether there were any. */
export function dropRefused(kind: Kind, request: Request): boolean {
  let dropped = false;
  for (let again = true; again;) {
    const gone = Object.keys(request).filter((field) => request[field] !== undefined && request[field] !== null && idle(kind, request, field) !== null);
    for (const field of gone) delete request[field];
    again = gone.length > 0;
    dropped ||= again;
  }
  return dropped;
}
