// The first document of the page. It is the content of a link, the last document that was worked on, an example that
// the address names, or a canopy.

import { ConnectionFailed, type ExampleSummary, type Kind, NotFound, type ObjectiveList, Unauthorized } from 'plateau-client';
import { hasKey, plateau, published } from '../api';
import { $, el } from '../dom';
import { useCatalogue } from '../model/applies';
import { isWhole, KINDS, type Vec3 } from '../model/request';
import type { OpenApi } from '../panels/form';
import { useTrees } from '../stage/surface';
import { ask, opening, whileBusy } from './busy';
import { load, showForm, startBlank } from './document';
import { rigs, showDock } from './drawing';
import { keep, type Kept, kept, placeWorld } from './keeping';
import { say } from './notes';
import { type Example, fetchExample, linked, openExample, switchKind } from './opening';
import { hideProblem, KEY_REFUSED, showProblem } from './problems';
import { showReport } from './result';
import { doc, embedded, history, host, later, server, session } from './session';
import { resumeJob, solve } from './solving';

/** What a first visit sees: a canopy on a ring that rises and falls. */
const HERO: Example = {
  kind: 'minimal_surface', title: 'A saddle canopy',
  request: {
    boundaries: [Array.from({ length: 24 }, (_, i) => {
      const angle = (i * Math.PI) / 12;
      return [7 * Math.cos(angle), 5.5 * Math.sin(angle), 2.6 + 2 * Math.cos(2 * angle)].map((value) => Number(value.toFixed(3)));
    })],
    objective: 'minimal_area', resolution: { triangles: 2000 },
  },
};

const named = (): string | null => new URLSearchParams(location.search).get('example');

/** The first film needs nothing but its request: it is solved while the server's documents are still being read. */
export const arrive = (): Promise<void> => whileBusy(async () => {
  const turn = ask();
  hideProblem(turn);
  try {
    const begun = begin();
    await Promise.all([begun, learn(begun)]);
  } catch (error) {
    say('Not ready.');
    showProblem(error, turn);
  }
});

/** What is wrong with the key that was set; null if the server takes it. */
export async function faultOfKey(): Promise<string | null> {
  try {
    await plateau.getJson('v1/jobs?limit=1');
    return null;
  } catch (error) {
    if (error instanceof Unauthorized) return hasKey() ? KEY_REFUSED : 'This server asks for a key.';
    return error instanceof ConnectionFailed ? 'The server cannot be reached, so the key was not tried.' : null;
  }
}

/** The first document. Another one that was opened or drawn while it was fetched stays. */
function begin(): Promise<void> {
  const before = JSON.stringify(doc());
  return opening(first, ({ found, example }) => {
    if (JSON.stringify(doc()) !== before) return;
    if (found) {
      resume(found);
      return;
    }
    const { kind, title, request: { kind: _, ...request } } = example ?? HERO;
    Object.assign(history.document, { kind, request, title });
    load();
    $('intro').hidden = example !== null;
    showDock();
    film = solve();
  }, (error) => { throw error; });
}

async function first(): Promise<{ found: Kept | null; example: Example | null }> {
  const found = await linked() ?? (named() !== null || embedded ? null : kept());
  // A name that the server does not know leads to the first film.
  const example = found || named() === null ? null : await fetchExample(named()!).catch((error: unknown) => {
    if (error instanceof NotFound) return null;
    throw error;
  });
  return { found, example };
}

/** The first film, if there is one to be solved. */
let film: Promise<unknown> = Promise.resolve();
/** The rest of the page waits so long for the first film at most. */
const FILM_MS = 1500;

/** The parts of the page that can wait until the first film is there. */
async function loadLater(begun: Promise<void>): Promise<typeof import('../later')> {
  await begun.catch(() => {});
  await Promise.race([film, new Promise((resolve) => { setTimeout(resolve, FILM_MS); })]);
  return import('../later');
}

/** What the server offers: kinds, options, objectives and examples. */
async function learn(begun: Promise<void>): Promise<void> {
  const [parts, openapi, { objectives }, { examples }] = await Promise.all([
    loadLater(begun),
    published<OpenApi>('openapi.json'), published<ObjectiveList>('v1/objectives'), published<{ examples: ExampleSummary[] }>('v1/examples'),
  ]);
  Object.assign(server, { openapi, objectives, examples: [...examples, ...parts.OWN] });
  useCatalogue(objectives);
  later.parts = parts;
  Object.assign(host, { moved: (from: Vec3, to: Vec3 | null) => parts.follow(doc().request, from, to), rig: parts.placeRig });
  Object.assign(rigs, { show: parts.showRigs, hint: parts.hintOfRig });
  parts.offerBox();
  showReport();
  useTrees(parts.trees);
  showKinds(parts.schemaOf);
  showForm();
  $('gallery-list').replaceChildren(...parts.gallery(server.examples, ({ name }) => {
    $<HTMLDialogElement>('gallery').close();
    void openExample(name);
  }));
  session.ready = true;
  keep();
}

/** Goes on where a link or the last visit was. A request that was cancelled then is not solved again by itself. */
function resume({ kind, request, draft, title, camera, colour, phase, job }: Kept): void {
  Object.assign(history.document, { kind, request, draft: draft ?? null, title: title ?? null });
  session.colour = colour ?? 'plain';
  load();
  if (camera) placeWorld(camera);
  if (phase === 'cancelled') {
    session.requests.wasCancelled(kind, JSON.stringify(request));
    say('Cancelled.');
  } else if (job) film = resumeJob(job);
  else if (isWhole(kind, request) && doc().draft === null) film = solve();
}

function showKinds(schemaOf: typeof import('../panels/form').schemaOf): void {
  const kinds = (Object.keys(KINDS) as Kind[]).filter((kind) => schemaOf(server.openapi, KINDS[kind].path));
  const legend = $('kinds').querySelector('legend')!;
  $('kinds').replaceChildren(legend, ...kinds.map((kind) => {
    const radio = el('input', { type: 'radio', name: 'kind', value: kind });
    radio.addEventListener('change', () => switchKind(kind));
    return el('label', {}, radio, KINDS[kind].label);
  }));
  $('blank-starts').replaceChildren(...kinds.filter((kind) => KINDS[kind].lines.length > 0).map((kind) => el('button', {
    type: 'button', onclick: () => { $<HTMLDialogElement>('gallery').close(); startBlank(kind); },
  }, `Draw a ${KINDS[kind].noun}`)));
}
