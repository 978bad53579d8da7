// A finished job: its mesh in the viewer with a switch for each layer, the colours' legend, statistics, warnings, files.

import * as api from './api.js';
import { $, element, number, save } from './dom.js';
import { edges } from './glb.js';
import * as report from './report.js';
import { metresOf, unitOf } from './request.js';

const MESH_FORMATS = ['glb', 'gltf', 'obj', 'ply', 'stl'];
const PATTERN_FORMATS = ['svg', 'dxf'];

/** Line styles by name, light on dark where the page is dark. */
function lineStyle(name) {
  const ink = document.documentElement.dataset.theme === 'dark' ? [0.9, 0.94, 0.95] : [0.06, 0.09, 0.1];
  if (name === 'boundaries' || name === 'directrices') return { width: 2.6, color: [...ink, 1], lift: 4e-4 };
  // These lie on the surface, which is never dark.
  if (name === 'bridges') return { width: 1.2, color: [0.06, 0.09, 0.1, 0.55], lift: 2e-4 };
  if (name === 'edges') return { width: 1, color: [0.06, 0.09, 0.1, 0.4], lift: 1e-4 };
  return { width: 1.6, color: [0.55, 0.25, 0.06, 0.9], lift: 3e-4 };
}

export class ResultView {
  /** `onProblem` is told what a download ran into. */
  constructor(viewer, world, onProblem) {
    Object.assign(this, { viewer, world, onProblem, job: null, mesh: null });
    this.layers = { surface: true, edges: false, colours: true, facets: false };
  }

  forget() {
    this.job = null;
    this.mesh = null;
    this.viewer.setSurface(null);
    this.viewer.removeLines((name) => name === 'input');
    $('result').hidden = true;
    $('nothing').hidden = false;
    $('legend').hidden = true;
    this.showLayers();
  }

  show(job, mesh, request) {
    const { viewer, layers } = this;
    const { extras } = mesh;
    const offset = this.world.to(extras.origin);
    // Folds are what a strip is about; a film is smooth.
    if (!this.mesh) layers.facets = job.kind === 'ruled_surface';
    this.job = job;
    this.mesh = { ...mesh, offset };
    this.request = request;
    viewer.setSurface(mesh, offset);
    const names = new Set(mesh.lines.map((line) => line.name));
    viewer.removeLines((name) => name === 'input' || names.has(name));
    mesh.lines.forEach((line) => viewer.setLines(line.name, line.segments, offset, lineStyle(line.name)));
    this.showLayers();
    this.showLegend();

    $('nothing').hidden = true;
    $('result').hidden = false;
    $('job-id').textContent = job.id;
    $('warnings').replaceChildren(...report.warnings(job.warnings));
    $('statistics').replaceChildren(...report.statistics(job.statistics));
    $('history').replaceChildren(...report.history(job.statistics.history, request.tolerance ?? 1e-6));
    this.offer($('downloads'), MESH_FORMATS, job, job.links.mesh);
    this.showPattern(job);
  }

  offer(box, formats, job, link) {
    box.replaceChildren(...formats.map((format) => {
      const button = element('button', { type: 'button' }, format.toUpperCase());
      button.addEventListener('click', async () => {
        try {
          save(await api.getBlob(`${link}?format=${format}`), `${job.kind.replaceAll('_', '-')}-${job.id}.${format}`);
        } catch (error) {
          this.onProblem(error);
        }
      });
      return button;
    }));
  }

  async showPattern(job) {
    const flat = job.links.pattern && job.statistics.flat_pattern;
    $('pattern').hidden = !flat;
    if (!flat) return;
    this.offer($('pattern-downloads'), PATTERN_FORMATS, job, job.links.pattern);
    try {
      const url = URL.createObjectURL(await api.getBlob(`${job.links.pattern}?format=svg`));
      const image = $('pattern-image');
      URL.revokeObjectURL(image.src);
      image.src = url;
    } catch (error) {
      // A live job may be superseded, and so removed, before its pattern was asked for.
      if (this.job?.id === job.id) this.onProblem(error);
    }
  }

  showLegend() {
    const range = this.mesh?.extras.color_range;
    $('legend').hidden = !range || !this.layers.colours;
    if (!range) return;
    // The mesh is in metres; people read it in their own unit.
    $('legend-unit').textContent = `[1/${unitOf(this.request)}]`;
    $('legend-max').textContent = number(Number((range.max * metresOf(this.request)).toPrecision(3)));
    const context = $('legend-bar').getContext('2d');
    const gradient = context.createLinearGradient(0, 0, 128, 0);
    const srgb = (value) => Math.round(255 * value ** (1 / 2.2));
    const steps = 32, { stops } = range;
    for (let i = 0; i <= steps; i += 1) {
      const position = (i / steps) * (stops.length - 1), low = Math.min(Math.floor(position), stops.length - 2);
      const color = stops[low].map((value, c) => srgb(value + (position - low) * (stops[low + 1][c] - value)));
      gradient.addColorStop(i / steps, `rgb(${color.join(' ')})`);
    }
    context.fillStyle = gradient;
    context.fillRect(0, 0, 128, 1);
  }

  /** A switch for the surface, its edges, its colours, and each line set of the result. */
  showLayers() {
    const { layers, mesh } = this;
    const lines = mesh?.lines.map((line) => line.name) ?? [];
    const offered = mesh ? ['surface', 'edges', ...(mesh.colors ? ['colours'] : []), 'facets', 'input', ...lines] : ['input'];
    $('layers').replaceChildren(...offered.map((name) => {
      layers[name] ??= true;
      const title = name.charAt(0).toUpperCase() + name.slice(1);
      const button = element('button', { type: 'button', 'aria-pressed': String(layers[name]) }, title);
      button.addEventListener('click', () => {
        layers[name] = !layers[name];
        button.setAttribute('aria-pressed', String(layers[name]));
        this.applyLayers();
      });
      return button;
    }));
    this.applyLayers();
  }

  applyLayers() {
    const { layers, mesh, viewer } = this;
    viewer.shown = layers.surface;
    viewer.tinted = layers.colours;
    viewer.facets = layers.facets;
    const wanted = Boolean(mesh && layers.edges);
    const segments = wanted ? (mesh.edges ??= edges(mesh.positions, mesh.triangles)) : new Float32Array();
    viewer.setLines('edges', segments, mesh?.offset, lineStyle('edges'));
    for (const { name } of viewer.lines) if (name !== 'edges') viewer.showLines(name, layers[name] ?? true);
    $('handles').style.display = layers.input === false ? 'none' : '';
    if (mesh?.extras.color_range) $('legend').hidden = !layers.colours;
    viewer.invalidate();
  }

  /** After a change of the page's theme. */
  restyle() {
    for (const line of this.viewer.lines) if (line.name !== 'input') line.style = lineStyle(line.name);
    this.viewer.invalidate();
  }
}
