/** Client of Plateau, a service for form finding: minimal surfaces, ruled surfaces and uniform meshes. */
export { Job, Live, Plateau, type PlateauOptions, Result, type SolveControl, type SubmitOptions } from './client.js';
export { type CurveLike, type PointLike, points } from './curves.js';
export {
  Busy, ConnectionFailed, InvalidRequest, JobCancelled, JobFailed, NotFound, PlateauError, ProblemError, ServerError,
  Unauthorized,
} from './errors.js';
export { type FollowControl, hasEnded } from './follow.js';
export { Mesh } from './mesh.js';
export type * from './types.js';
export type { components, operations, paths } from './openapi.js';
