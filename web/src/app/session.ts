// The state that all modules of the page share: the document, the stage on which the document is drawn, and the shown
// result. Nothing here acts. The other modules read and change this state, and each of them imports only modules that
// main.ts names before it.

import type { ExampleSummary, JobInfo, Objective } from 'plateau-client';
import { $ } from '../dom';
import { Frame } from '../model/frame';
import { type Document, History } from '../model/history';
import { blank, type Request, type Vec3 } from '../model/request';
import type { OpenApi } from '../panels/form';
import type { ResultMesh } from '../stage/mesh';
import type { Quantity } from '../stage/quantities';
import { Sketch, type SketchLook } from '../stage/sketch';
import { Stage } from '../stage/stage';
import { type Look, Surface } from '../stage/surface';
import { type Host, Tools } from '../stage/tools';
import { Requests } from './life';

/** The direction that a model is first seen from. */
export const FIRST_VIEW: Vec3 = [0.62, 0.5, 0.85];
/** Whether this is the page that other sites show in a frame. */
export const embedded = document.documentElement.hasAttribute('data-embed');

export const THEMES: Record<string, { sketch: SketchLook; look: Look; grid: [string, number]; shadow: number }> = {
  light: {
    sketch: { paper: '#ffffff', accent: '#0a6c7e', ink: '#1c2427', fault: '#c62f26', soft: '#6d7b81', cable: '#b4561f' },
    look: { membrane: '#f2eee6', ink: '#20292d', accent: '#b4561f', reaction: '#c2185b', rim: '#ffffff' }, grid: ['#5b6b73', 0.42], shadow: 0.5,
  },
  dark: {
    sketch: { paper: '#12181b', accent: '#56c4d4', ink: '#ffffff', fault: '#ff7a70', soft: '#8fa0a8', cable: '#ffb273' },
    look: { membrane: '#cbc7be', ink: '#0d1214', accent: '#ffb273', reaction: '#ff8fb8', rim: '#6c7c84' }, grid: ['#90a4ad', 0.3], shadow: 0.85,
  },
};

/** A result on the stage, and the request that it belongs to, also as the text that was solved. */
export interface Shown { job: JobInfo; mesh: ResultMesh; solved: string; request: Request; dragging: boolean }

/** The parts of the page that the first film does not need, once they are there. */
export const later: { parts: typeof import('../later') | null } = { parts: null };

/** What the server offers. */
export const server = { openapi: {} as OpenApi, objectives: [] as Objective[], examples: [] as ExampleSummary[] };

export type Mode = 'model' | 'compare' | 'flat';

export const session = {
  /** What fills the stage: the model, the objectives of a strip side by side, or its flat pattern. */
  mode: 'model' as Mode,
  shown: null as Shown | null,
  /** A job is shown of which only the mesh is known here: the drawing is put aside. */
  viewing: false,
  requests: new Requests(),
  /** How long the last job took, in seconds. */
  lastDuration: 0,
  /** The quantity that the surface is coloured by: its name, and its values. */
  colour: 'plain',
  quantity: null as Quantity | null,
  /** Points that the server found wrong, as `line/point`. */
  serverFaulty: new Set<string>(),
  /** Whether the camera came with the document, so that its first result does not move it. */
  cameraGiven: false,
  /** The card about a file or a unit, and the request that it is about as JSON text. */
  card: null as { of: string; close(): void } | null,
  /** Whether the server was heard and the document is one. */
  ready: false,
};

export const history = new History({ kind: 'minimal_surface', request: blank('minimal_surface'), draft: null, title: null });
export const doc = (): Document => history.document;

/** Whether the result is one of an earlier drawing. */
export function isStale(): boolean {
  const { shown, viewing } = session;
  return shown !== null && !viewing && (shown.solved !== JSON.stringify(doc().request) || shown.job.kind !== doc().kind);
}

export const look: Look = { ...THEMES.light!.look };
export const stage = new Stage($<HTMLCanvasElement>('view'), () => ({
  top: 64, right: 34, left: 34, bottom: Math.max(embedded ? 40 : 70, $('look').offsetHeight + 34),
}));
export const sketch = new Sketch(THEMES.light!.sketch);
export const surface = new Surface(look);
stage.model.add(surface.group, sketch.group);

/** What the tools tell the page; main.ts says who listens. */
export const host: Host = {
  history, stage, sketch, surface, lines: [], frame: new Frame([0, 0, 0], doc().request), faulty: new Set(), fixed: embedded,
  changed() {}, selectionChanged() {}, moved() {}, rig() {}, label() {}, read() {}, readLine() {}, announce() {},
};
export const tools = new Tools(host);
