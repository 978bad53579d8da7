// Changes of a request that are likely to help after a failure, each made by one press.

import { cablesOf } from './cables';
import type { Request } from './request';

export interface Remedy { label: string; apply(request: Request): void }

/** Modes of a cable whose value is a force, or a force per length. */
const FORCES = ['force', 'end_tension', 'horizontal_component', 'force_density'];

/** Remedies by the type of a failure; each gives null where it does not apply to the request. */
const REMEDIES: Record<string, (request: Request) => Remedy | null> = {
  '/problems/no-equilibrium': (request) => {
    if (cablesOf(request).some(({ mode = 'force' }) => FORCES.includes(mode))) {
      return {
        label: 'Double the forces of the cables',
        apply: (changed) => { for (const cable of cablesOf(changed)) if (FORCES.includes(cable.mode ?? 'force')) cable.value *= 2; },
      };
    }
    if (typeof request.pressure !== 'number' || request.pressure === 0) return null;
    return { label: 'Halve the pressure', apply: (changed) => { changed.pressure = (changed.pressure as number) / 2; } };
  },
  '/problems/no-connected-film': ({ topology }) => (topology === 'free' || topology === 'best' ? null
    : { label: 'Let the film come apart', apply: (changed) => { changed.topology = 'free'; } }),
};

/** The remedy for a failure; null if none is known. */
export const remedyFor = (type: string, request: Request): Remedy | null => REMEDIES[type]?.(request) ?? null;
