// The page's own sentences for the failures of the service, and its texts with numbers that count from 1, as people do.

/** Sentences of the failures, by the last part of their type: what is wrong, and what to try. */
export const FAILURES: Record<string, string> = {
  'degenerate-boundary': 'The boundary spans no area that a mesh could begin with. Move its points apart.',
  'equilibrium-not-found': 'No shape in equilibrium was found, which does not prove that there is none. Try another resolution, or begin nearer to the shape.',
  'internal': 'The service failed. This is a defect of the service and not of the drawing.',
  'invalid-mesh': 'The solver ended with a mesh that is no surface. Try another resolution or another solver.',
  'no-connected-film': 'No film connects the boundaries. Move them closer together, or choose a topology that lets the film come apart.',
  'no-equilibrium': 'The film closes or leaves its supports before it is in balance. Give the cables larger forces, lower the pressure, or move the supports closer together.',
  'no-initial-mesh': 'No mesh was found that the solver could begin with. Move the points apart, or choose another initial mesh.',
  'no-room-for-interior-vertices': 'The boundary is too small for the vertices that were asked for. Ask for fewer.',
  'not-flattenable': 'The surface cannot be laid flat.',
  'self-intersecting-boundary': 'The boundary crosses or touches itself, so no mesh without folds spans it. Move the points apart.',
  'slack-cable': 'A cable would carry no force. Make it shorter, or give it a larger force.',
  'targets-not-reached': 'No net meets the targets. Leave out some of them, or make them less strict.',
  'too-large': 'The mesh is too large for this service. Ask for fewer triangles or for longer edges.',
};

/** Words of the service before a number that counts from 0. */
const PLACES = /\b(point|boundary|boundaries|cable|layer|edge|vertex|vertices|support|ring|rail|directrix|directrices|triangle|mast|strip|hole|joint|segment|polyline)(s?) (\d+(?:(?:, | and | to | or )\d+)*)(?![\d.]*\d|\.\d)/gi;
/** A pointer into a request, as the service writes it. */
const POINTER = /(?<![\w/])((?:\/[a-z_]+(?:\/\d+)*)+)/g;

/** A text of the service with its places counted from 1, and its pointers as words. */
export const fromOne = (text: string): string => text
  .replace(PLACES, (_, word: string, plural: string, numbers: string) => `${word}${plural} ${numbers.replace(/\d+/g, (n) => String(Number(n) + 1))}`)
  .replace(POINTER, (pointer) => pointer.slice(1).split('/').map((step) => (/^\d+$/.test(step) ? String(Number(step) + 1) : step.replaceAll('_', ' '))).join(' '));
