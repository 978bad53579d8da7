/** Client of Plateau, a service for form finding: films, strips, lattices, membranes and cable nets. */
export {
  Batch, Job, Live, Plateau, type PlateauOptions, Result, type SolveControl, type SubmitOptions, version,
} from './client.js';
export { type CurveLike, type PointLike, points } from './curves.js';
export {
  Busy, ConnectionFailed, InvalidRequest, JobCancelled, JobFailed, NotFound, PlateauError, ProblemError, ServerError,
  Unauthorized,
} from './errors.js';
export { type FollowControl, hasEnded } from './follow.js';
export { type Lines, Mesh } from './mesh.js';
export type * from './types.js';
export type { components, operations, paths } from './openapi.js';
