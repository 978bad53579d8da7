/** The mesh of a job as typed arrays. */
import type { components } from './openapi.js';
import type { JobInfo, JobWarning, Request, Units, UpAxis } from './types.js';

/**
 * A triangle mesh in the axes and the unit of its request. The coordinates are the very f64 numbers that the solver
 * ended with, at survey coordinates too.
 */
export class Mesh<Statistics> {
  /** x y z of each vertex. The request's own points come first, in their order. */
  readonly vertices: Float64Array;
  /** Three indices of vertices for each triangle. A cable net has none. */
  readonly triangles: Uint32Array;
  /** Two indices of vertices for each edge of a cable net, cable by cable. Other kinds have none here. */
  readonly edges: Uint32Array;
  /** The force of each of `edges`. */
  readonly forces: Float64Array;
  /** Per vertex, 1/unit; null for kinds that have none. */
  readonly meanCurvature: Float64Array | null;
  readonly unit: Units;
  readonly up: UpAxis;
  /** How good the mesh is; its fields depend on the kind. */
  readonly statistics: Statistics;
  /** The request as this client sent it. Undefined for a job that another client submitted. */
  request: Request | undefined;

  constructor(
    /** The finished job: times, links, warnings. */
    readonly job: JobInfo,
    ply: ArrayBuffer,
  ) {
    this.statistics = job.statistics as Statistics;
    const read = readPly(ply);
    this.vertices = read.vertices;
    this.triangles = read.triangles;
    this.edges = read.edges;
    this.forces = read.forces;
    this.meanCurvature = read.meanCurvature;
    this.unit = read.unit as Units;
    this.up = read.up as UpAxis;
  }

  get id(): string {
    return this.job.id;
  }

  /** What the server wants the caller to know, each with a `code` and a `detail`. */
  get warnings(): JobWarning[] {
    return this.job.warnings;
  }

  /** Middle of the mesh's box. For programs that keep f32: the vertices are near to it, however far it is from zero. */
  get origin(): [number, number, number] {
    const low = [Infinity, Infinity, Infinity];
    const high = [-Infinity, -Infinity, -Infinity];
    this.vertices.forEach((value, index) => {
      const axis = index % 3;
      low[axis] = Math.min(low[axis]!, value);
      high[axis] = Math.max(high[axis]!, value);
    });
    const middle = (axis: number) => 0.5 * low[axis]! + 0.5 * high[axis]!;
    return [middle(0), middle(1), middle(2)];
  }
}

/** Reads the server's binary PLY: the format that keeps f64 coordinates and the mean curvature. */
export function readPly(buffer: ArrayBuffer) {
  const bytes = new Uint8Array(buffer);
  const text = new TextDecoder().decode(bytes.subarray(0, 4096));
  const end = text.indexOf('end_header\n');
  if (end < 0) throw new Error('the PLY file has no header');
  const header = text.slice(0, end).split('\n').map((line) => line.split(' '));
  // Each property of an element with the offset of its value. Lists belong to the faces.
  const rowOf = (element: string) => {
    let stride = 0;
    let current = '';
    const offsets = new Map<string, number>();
    for (const [word, type = '', name = ''] of header) {
      if (word === 'element') current = type;
      if (word !== 'property' || type === 'list' || current !== element) continue;
      offsets.set(name, stride);
      stride += { double: 8, float: 4, int: 4, uchar: 1 }[type] ?? 0;
    }
    return { offsets, stride };
  };
  const { offsets: columns, stride } = rowOf('vertex');
  const count = (element: string) => Number(header.find((line) => line[0] === 'element' && line[1] === element)?.[2]);
  const [, , unit = '', up = ''] = header.find((line) => line[0] === 'comment' && line[1] === 'unit') ?? [];

  const view = new DataView(buffer);
  let offset = new TextEncoder().encode(text.slice(0, end)).length + 'end_header\n'.length;
  const vertices = new Float64Array(3 * count('vertex'));
  const curvature = columns.get('mean_curvature');
  const meanCurvature = curvature === undefined ? null : new Float64Array(count('vertex'));
  for (let vertex = 0; 3 * vertex < vertices.length; vertex++, offset += stride) {
    for (let axis = 0; axis < 3; axis++) vertices[3 * vertex + axis] = view.getFloat64(offset + 8 * axis, true);
    if (meanCurvature) meanCurvature[vertex] = view.getFloat64(offset + curvature!, true);
  }
  const triangles = new Uint32Array(3 * count('face'));
  for (let triangle = 0; 3 * triangle < triangles.length; triangle++, offset += 13) {
    for (let corner = 0; corner < 3; corner++) {
      triangles[3 * triangle + corner] = view.getUint32(offset + 1 + 4 * corner, true);
    }
  }
  const edge = rowOf('edge');
  const edges = new Uint32Array(2 * (count('edge') || 0));
  const force = edge.offsets.get('force');
  const forces = new Float64Array(force === undefined ? 0 : edges.length / 2);
  for (let k = 0; 2 * k < edges.length; k++, offset += edge.stride) {
    for (let end = 0; end < 2; end++) edges[2 * k + end] = view.getUint32(offset + 4 * end, true);
    if (force !== undefined) forces[k] = view.getFloat64(offset + force, true);
  }
  return { vertices, triangles, edges, forces, meanCurvature, unit: unit.replace(',', ''), up };
}

/** Lines along a mesh that have a name in common, and their values. */
export interface Lines {
  /** Each line as indices of vertices. A closed line ends with its first vertex. */
  paths: Uint32Array[];
  /** Six coordinates for each straight line between points that are no vertices, such as those of `reactions`. */
  arrows: Float64Array;
  /** A number for each path or arrow, by its name, such as `force` or `length`. Empty if the lines have none. */
  values: Record<string, Float64Array>;
  /** Unit of the values. */
  unit: string | null;
}

/** The lines of a mesh in the server's JSON, by name. */
export function readLines(mesh: components['schemas']['Mesh']): Map<string, Lines> {
  return new Map(mesh.lines.map(({ name, paths, arrows, values }) => [name, {
    paths: paths.map((path) => Uint32Array.from(path)),
    arrows: Float64Array.from(arrows.flat(2)),
    values: values ? { [values.name]: Float64Array.from(values.values) } : {},
    unit: values?.unit ?? null,
  }]));
}
