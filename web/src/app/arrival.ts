// What the page begins with: a link's content, what was being worked on, an example that the address names, or a canopy.

import { type ExampleSummary, type Kind, NotFound, Unauthorized } from 'plateau-client';
import { plateau } from '../api';
import { $, el } from '../dom';
import { isWhole, KINDS } from '../model/request';
import { type OpenApi, schemaOf } from '../panels/form';
import { gallery } from '../panels/gallery';
import { ask, opening, whileBusy } from './busy';
import { load, showForm, startBlank } from './document';
import { showDock } from './drawing';
import { keep, type Kept, kept, placeWorld } from './keeping';
import { say } from './notes';
import { type Example, fetchExample, linked, openExample, switchKind } from './opening';
import { hideProblem, showProblem } from './problems';
import { doc, embedded, history, server, session } from './session';
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
    await Promise.all([begin(), learn()]);
  } catch (error) {
    showProblem(error, turn);
    say('Not ready.');
    if (error instanceof Unauthorized) $<HTMLDialogElement>('settings').showModal();
  }
});

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
    void solve();
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

/** What the server offers: kinds, options, objectives and examples. */
async function learn(): Promise<void> {
  const [openapi, { objectives }, { examples }] = await Promise.all([
    plateau.getJson<OpenApi>('openapi.json'), plateau.objectives(), plateau.getJson<{ examples: ExampleSummary[] }>('v1/examples'),
  ]);
  Object.assign(server, { openapi, objectives, examples });
  showKinds();
  showForm();
  $('gallery-list').replaceChildren(...gallery(examples, ({ name }) => {
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
  } else if (job) void resumeJob(job);
  else if (isWhole(kind, request) && doc().draft === null) void solve();
}

function showKinds(): void {
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
