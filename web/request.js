// Requests as plain JSON: where their polylines are, and what a JSON Pointer into one means to a person.

export const KINDS = {
  minimal_surface: { path: '/v1/minimal-surfaces', label: 'Minimal surface', line: 'boundary', lines: ['boundaries'], least: 3 },
  ruled_surface: { path: '/v1/ruled-surfaces', label: 'Ruled strip', line: 'directrix', lines: ['directrices'], least: 2 },
  uniform_mesh: { path: '/v1/uniform-meshes', label: 'Uniform mesh', line: 'hole', lines: ['domain', 'holes'], least: 3 },
};

const METRES = { mm: 0.001, cm: 0.01, m: 1, in: 0.0254, ft: 0.3048 };
export const unitOf = (request) => (request.units in METRES ? request.units : 'm');
export const metresOf = (request) => METRES[unitOf(request)];

const isPoint = (value) => Array.isArray(value) && value.length >= 2 && value.length <= 3 && value.every(Number.isFinite);
const isLine = (value) => Array.isArray(value) && value.every(isPoint);

/** Every polyline of a request that can be drawn and edited: { name, path, points, closed }. Unsound parts are left out. */
export function linesOf(kind, request) {
  const closed = kind === 'ruled_surface' ? request.closed === true : true;
  const found = [];
  const one = (name, path, points, isClosed) => { if (isLine(points)) found.push({ name, path, points, closed: isClosed }); };
  const many = (name, path, list, isClosed) => {
    if (Array.isArray(list)) list.forEach((points, i) => one(`${name} ${i + 1}`, [...path, i], points, isClosed));
  };
  if (kind === 'ruled_surface') many('directrix', ['directrices'], request.directrices, closed);
  if (kind === 'minimal_surface') many('boundary', ['boundaries'], request.boundaries, true);
  const { domain } = request;
  if (domain && typeof domain === 'object') {
    if (domain.polygon) one('polygon', ['domain', 'polygon'], domain.polygon, true);
    many('hole', ['domain', 'holes'], domain.holes, true);
    many('boundary', ['domain', 'boundaries'], domain.boundaries, true);
    for (const patch of ['bezier', 'nurbs']) {
      many('control row', ['domain', patch, 'control_points'], domain[patch]?.control_points, false);
    }
  }
  return found;
}

/** The value that a path leads to; with `make`, missing lists on the way are made. */
export function at(request, path, make = false) {
  return path.reduce((value, step) => {
    if (make && value[step] === undefined) value[step] = typeof step === 'number' ? {} : [];
    return value?.[step];
  }, request);
}

/** A pointer as words, and the point that it names if it names one: { text, line, point }. */
export function place(lines, pointer) {
  const steps = pointer.split('/').slice(1).map((step) => step.replaceAll('~1', '/').replaceAll('~0', '~'));
  const index = lines.findIndex((line) => line.path.every((step, i) => String(step) === steps[i]));
  if (index < 0) return { text: steps.join(' › ') || 'the request' };
  const line = lines[index];
  const [point, axis] = steps.slice(line.path.length).map(Number);
  if (!Number.isInteger(point)) return { text: line.name, line: index };
  const suffix = axis === undefined ? '' : `, ${'xyz'[axis] ?? 'coordinate'}`;
  return { text: `${line.name}, point ${point + 1}${suffix}`, line: index, point: Math.min(point, line.points.length - 1) };
}

/** A request to start from where the server has no example of a kind. */
export function blank(kind) {
  const square = [[0, 0, 0], [10, 0, 0], [10, 10, 0], [0, 10, 0]];
  if (kind === 'ruled_surface') return { directrices: [[[0, 0, 0], [5, 0, 2], [10, 0, 0]], [[0, 5, 0], [10, 5, 1]]] };
  if (kind === 'uniform_mesh') return { domain: { polygon: square }, edge_length: 1 };
  return { boundaries: [[[0, 0, 0], [10, 0, 3], [10, 10, 0], [0, 10, 3]]] };
}
