// Changes of a request that are likely to help after a failure, each made by one press.

import { cablesOf } from './cables';
import { coordinates, type Request, type Vec3 } from './request';

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
  // A curve in space may cross itself only as it is seen from one side, which does not matter to a mesh that begins as a disk.
  '/problems/self-intersecting-boundary': ({ boundaries, initial_mesh: mesh }) => {
    if (!Array.isArray(boundaries) || boundaries.length !== 1 || mesh === 'disk' || isPlane(boundaries[0])) return null;
    return { label: 'Begin with a disk', apply: (changed) => { changed.initial_mesh = 'disk'; } };
  },
};

/** The remedy for a failure; null if none is known. */
export const remedyFor = (type: string, request: Request): Remedy | null => REMEDIES[type]?.(request) ?? null;

/** Whether points lie in one plane, up to a millionth of their extent. */
function isPlane(line: unknown): boolean {
  const points = Array.isArray(line) ? line.flatMap((point) => { const at = coordinates(point); return at ? [at] : []; }) : [];
  const [origin] = points;
  if (!origin) return true;
  const arms = points.map((point): Vec3 => [point[0] - origin[0], point[1] - origin[1], point[2] - origin[2]]);
  const size = Math.max(...arms.map((arm) => Math.hypot(...arm)));
  const cross = (a: Vec3, b: Vec3): Vec3 => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  const far = arms.reduce((a, b) => (Math.hypot(...b) > Math.hypot(...a) ? b : a));
  const normal = arms.map((arm) => cross(far, arm)).reduce((a, b) => (Math.hypot(...b) > Math.hypot(...a) ? b : a));
  return arms.every((arm) => Math.abs(arm[0] * normal[0] + arm[1] * normal[1] + arm[2] * normal[2]) <= 1e-6 * size ** 3);
}
