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
  const isCurve = (part: unknown): boolean => Array.isArray(part) && part.length > 0 && part.every(isPoint);
  if (curve.length > 0 && curve.every(isCurve)) throw invalid('', `${TOO_MANY}: ${POINTS}`);
  if (!curve.every(isPoint)) throw invalid('', 'expected points as [[x, y, z], …]');
  return curve.map((point: PointLike) => ('x' in point ? [point.x, point.y, point.z] : [...point]));
}

/** The points of a curve of a request; the error leads to the curve. */
export function curveAt(pointer: string, given: CurveLike): number[][] {
  try {
    return points(given);
  } catch (error) {
    throw error instanceof InvalidRequest ? invalid(pointer, error.detail) : error;
  }
}

/** The curves of a field of a request; the pointers of errors lead to the curve. */
export function curves(field: string, given: readonly CurveLike[]): number[][][] {
  if (!Array.isArray(given) || (given.length > 0 && given.every(isPoint))) throw invalid(`/${field}`, `${TOO_FEW}: ${CURVES}`);
  if (given.length > 0 && given.every((one) => levels(one) > 2)) throw invalid(`/${field}`, `${TOO_MANY}: ${CURVES}`);
  return given.map((curve: CurveLike, index) => curveAt(`/${field}/${index}`, curve));
}

// The words of the server for the same slips.
const POINTS = 'it must be a list of points [x, y, z], such as [[0, 0, 0], [4, 0, 1], [4, 3, 0]]';
const CURVES = 'it must be a list of polylines, which are lists of points [x, y, z], such as [[[0, 0, 0], [4, 0, 1], [4, 3, 0]]]';
const TOO_MANY = 'has a level of brackets too many';
const TOO_FEW = 'lacks a level of brackets';

/** Number of levels of brackets around the first number of a value. */
function levels(value: unknown): number {
  return Array.isArray(value) ? 1 + levels(value[0]) : 0;
}

/** Whether a value is x y z, and not a list of points. */
function isPoint(value: unknown): boolean {
  if (Array.isArray(value)) return value.length > 0 && value.every((one) => typeof one === 'number');
  return typeof value === 'object' && value !== null && 'x' in value;
}

/** Membranes and nets have a unit of force too, so that the unit of length alone is not enough. */
export function checkUnits({ kind, units }: { kind?: unknown; units?: unknown }, pointer = ''): void {
  if ((kind !== 'tensile_structure' && kind !== 'cable_net') || typeof units !== 'string') return;
  throw invalid(`${pointer}/units`, `must be an object, such as {"force":"kN","length":"${units}"}`);
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

/** The error for a value that the client itself refuses. */
export function invalid(pointer: string, detail: string): InvalidRequest {
  return new InvalidRequest({ title: 'The request is invalid', detail, errors: [{ pointer, detail }] });
}
