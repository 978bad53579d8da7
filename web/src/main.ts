// The studio: the request on the left, the model in the middle, the result on the right. Puts the parts of `app`
// together and begins. They know each other in one direction only: life, session, notes, keeping, drawing, problems,
// modes, result, theme, solving, document, opening, arrival, wiring. The files of `later` stand above document.

import './style.css';
import { arrive } from './app/arrival';
import { applyRemedy, changed, gizmo, useObjective } from './app/document';
import { showDock } from './app/drawing';
import { keep } from './app/keeping';
import { comparison } from './app/modes';
import { announce, label, placeLabel, placeScale, placeTags, readLine, readSurface, showPanel, tips } from './app/notes';
import { openExample } from './app/opening';
import { repair } from './app/problems';
import { doc, embedded, host, isStale, session, sketch, stage, surface, tools } from './app/session';
import { preferredTheme, setTheme } from './app/theme';
import { wire } from './app/wiring';
import { $ } from './dom';
import type { Vec3 } from './model/request';
import { isLoaded } from './solvers';

Object.assign(host, { changed: (dragging: boolean) => changed({ dragging, edited: true }), selectionChanged: showDock, label, read: readSurface, readLine, announce });
comparison.use = useObjective;
repair.by = applyRemedy;
stage.under = (x, y) => surface.pick(stage, x, y)?.point ?? null;
stage.content = () => [...sketch.places, ...surface.outline(), ...tips()];
stage.onDraw = () => {
  gizmo.place();
  placeLabel();
  placeTags();
  placeScale();
};
stage.onRest = () => {
  stage.rememberWhetherAllIsSeen();
  keep();
};
$('no-webgl').hidden = stage.renderer !== null;
// A picture of the model alone, as the gallery has them: no ground.
if (embedded && new URLSearchParams(location.search).get('ground') === 'none') stage.grid.mesh.visible = false;

wire();
setTheme(preferredTheme());
showPanel('setup');
$('look').hidden = true;
void arrive();

/** For tests, and for whoever opens the console: what is shown, and where it is drawn. */
Object.assign(window, {
  studio: {
    request: () => structuredClone(doc().request), kind: () => doc().kind, draft: () => structuredClone(doc().draft),
    shown: () => (session.shown ? { job: session.shown.job.id, solved: session.shown.solved, stale: isStale() } : null),
    faulty: () => [...host.faulty], selection: () => tools.selection, points: () => sketch.places.map((place) => stage.project(place)),
    project: (point: Vec3) => stage.project(host.frame.toScene(point)), covers: (x: number, y: number) => surface.pick(stage, x, y) !== null,
    shadow: () => stage.shadow.plane.material.opacity, fit: () => stage.fit(false), draw: () => stage.draw(), isParallel: () => stage.isParallel, isAtRest: () => stage.isAtRest, openExample, solvesHere: () => isLoaded(doc().kind),
  },
});
