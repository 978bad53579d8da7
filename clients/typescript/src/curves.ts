/** Points from whatever holds them. */
import { InvalidRequest } from './errors.js';

/** `[x, y, z]`, or an object such as three.js's Vector3. */
export type PointLike = readonly number[] | { readonly x: number; readonly y: number; readonly z: number };
/** Points, or their coordinates one after another (x y z x y z …). */
export type CurveLike = readonly PointLike[] | Float64Array | Float32Array;

export function points(curve: CurveLike): number[][] {
  if (curve instanceof Float64Array || curve instanceof Float32Array) {
    if (curve.length % 3 !== 0) throw invalid('', `expected x y z of each point, got ${curve.length} numbers`);
    return Array.from({ length: curve.length / 3 }, (_, i) => Array.from(curve.subarray(3 * i, 3 * i + 3)));
  }
  if (!Array.isArray(curve)) throw invalid('', 'expected points as [[x, y, z], …]');
  return curve.map((point: PointLike) => ('x' in point ? [point.x, point.y, point.z] : [...point]));
}

/** The curves of a field of a request; the pointers of errors lead to the curve. */
export function curves(field: string, given: readonly CurveLike[]): number[][][] {
  if (!Array.isArray(given)) throw invalid(`/${field}`, 'expected a list of curves');
  return given.map((curve: CurveLike, index) => {
    try {
      return points(curve);
    } catch (error) {
      throw error instanceof InvalidRequest ? invalid(`/${field}/${index}`, error.detail) : error;
    }
  });
}

/** The body of a request. JSON has no NaN: a number that is not finite is an error with its pointer. */
export function toJson(request: unknown): string {
  checkFinite(request, '');
  return JSON.stringify(request);
}

function checkFinite(value: unknown, pointer: string): void {
  if (typeof value === 'number' && !Number.isFinite(value)) throw invalid(pointer, `${value} is not a finite number`);
  if (typeof value !== 'object' || value === null) return;
  for (const [key, part] of Object.entries(value)) {
    if (typeof part === 'number' ? !Number.isFinite(part) : typeof part === 'object') {
      checkFinite(part, `${pointer}/${key.replaceAll('~', '~0').replaceAll('/', '~1')}`);
    }
  }
}

function invalid(pointer: string, detail: string): InvalidRequest {
  return new InvalidRequest({ title: 'The request cannot be worked on', detail, errors: [{ pointer, detail }] });
}
