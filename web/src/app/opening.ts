// Other documents: examples, links, and the drawing of another kind. What is fetched first keeps the page busy from
// the press on.

import { ConnectionFailed, type Kind, NotFound, Unauthorized } from 'plateau-client';
import { published } from '../api';
import { isWhole, type Request } from '../model/request';
import { opening, supersedeOpenings } from './busy';
import { changed, isLive, replace, showForm, startBlank } from './document';
import { isKept, type Kept, placeWorld } from './keeping';
import { say, toast } from './notes';
import { showProblem } from './problems';
import { doc, embedded, server, session } from './session';

// ---- Examples and kinds ----

export interface Example { kind: Kind; title: string; request: Request }

/** An example of the service, or of the studio's own. */
export async function fetchExample(name: string): Promise<Example> {
  try {
    return await published<Example>(`v1/examples/${encodeURIComponent(name)}`);
  } catch (error) {
    const own = error instanceof NotFound && (await import('../later')).OWN.find((each) => each.name === name);
    if (own) return structuredClone(own);
    throw error;
  }
}

export const openExample = (name: string): Promise<void> => opening(() => fetchExample(name), (example) => {
  const { kind: _, ...request } = example.request;
  replace(example.kind, request, example.title);
  changed();
  if (!isLive()) say('Ready.');
}, (error, turn) => {
  // The form shows the kind of the document, because the kind that was pressed was not opened.
  showForm();
  showProblem(error, turn);
});

/** What was last drawn of each kind, to come back to. */
const drafts = new Map<Kind, { request: Request; title: string | null }>();
/** The example that a kind begins with. Its result has no warning. */
const FIRST_OF: Partial<Record<Kind, string>> = { ruled_surface: 'wavy-strip', uniform_mesh: 'courtyard', tensile_structure: 'four-point-sail', cable_net: 'four-cables' };

export function switchKind(kind: Kind): void {
  const before = doc();
  if (before.kind === kind) {
    supersedeOpenings();
    return;
  }
  drafts.set(before.kind, { request: structuredClone(before.request), title: before.title });
  const own = drafts.get(kind);
  const first = server.examples.find((each) => each.kind === kind);
  if (own) {
    replace(kind, own.request, own.title);
    changed();
  } else if (first) {
    if (!navigator.onLine) showForm();
    void openExample(FIRST_OF[kind] ?? first.name);
  } else startBlank(kind);
}

// ---- Links ----

/** What the link in the address holds; null without one, and, said in a note, for a damaged one. */
export async function linked(): Promise<Kept | null> {
  const [, how, packed] = /^#([js])=(.+)$/.exec(location.hash) ?? [];
  if (!packed) return null;
  let lost = 'This link is damaged: it does not hold a request.';
  try {
    const { openShort, unpack } = await import('../later');
    const found = how === 's' ? await unpack(packed) : await openShort(location.hash);
    if (!embedded) window.history.replaceState(null, '', location.pathname + location.search);
    if (isKept(found)) return found;
  } catch (error) {
    if (error instanceof ConnectionFailed || error instanceof Unauthorized) throw error;
    if (how === 'j') lost = 'The service no longer keeps what this link names.';
  }
  toast(lost);
  return null;
}

/** Opens a link that was put into the address of an open studio: only the hash changes. */
export const openLink = (): Promise<void> => opening(linked, (found) => {
  if (!found) return;
  const { kind, request, title, camera, colour } = found;
  session.colour = colour ?? 'plain';
  replace(kind, request, title ?? null);
  if (camera) placeWorld(camera);
  changed();
  if (!isWhole(kind, request)) say('');
}, showProblem);
