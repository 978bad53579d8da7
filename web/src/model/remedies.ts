// Changes of a request that are likely to help after a failure, each made by one press.

import { cablesOf } from './cables';
import type { Request } from './request';

export interface Remedy { label: string; apply(request: Request): void }

/** Modes of a cable whose value is a force, or a force per length. */
const FORCES = ['force', 'end_tension', 'horizontal_component', 'force_density'];

/** The remedy for a kind of failure; null if none is known. */
export function remedyFor(type: string, request: Request): Remedy | null {
  if (type !== '/problems/no-equilibrium') return null;
  if (cablesOf(request).some(({ mode = 'force' }) => FORCES.includes(mode))) {
    return {
      label: 'Double the forces of the cables',
      apply: (changed) => { for (const cable of cablesOf(changed)) if (FORCES.includes(cable.mode ?? 'force')) cable.value *= 2; },
    };
  }
  if (typeof request.pressure === 'number' && request.pressure !== 0) {
    return { label: 'Halve the pressure', apply: (changed) => { changed.pressure = (changed.pressure as number) / 2; } };
  }
  return null;
}
