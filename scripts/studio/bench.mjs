// Prints figures of the studio as lines for benches/results.jsonl:
//
// - arrival: how soon a first visit sees a solved film,
// - live: how often a live drag is answered,
// - orbit: what an orbit costs in script,
// - memory: what memory a page has after 10,000 drags.
//
// CHROMIUM=… PLATEAU_BIN=… node scripts/studio/bench.mjs [NAME …] >> benches/results.jsonl, on a quiet machine. Without a
// name all of them are measured. Each line says what it is measured against.

import { execSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { cpus, loadavg } from 'node:os';
import { apply, launch, onStage, points, request, solved, startServer } from './harness.mjs';

const server = await startServer();
const browser = await launch();
const page = await browser.newPage({ viewport: { width: 1280, height: 720 } });
page.setDefaultTimeout(300_000);
const median = (values) => [...values].sort((a, b) => a - b)[Math.floor(values.length / 2)];
const common = {
  date: new Date().toISOString().slice(0, 10), commit: execSync('git rev-parse --short HEAD').toString().trim(), machine: `${cpus().length} cores x86_64`, renderer: 'SwiftShader', load_before: Number(loadavg()[0].toFixed(2)),
};
const say = (line) => console.log(JSON.stringify({ ...common, ...line }));

const round = (value, digits = 0) => Number(value.toFixed(digits));

/** From the navigation to the first frame with the solved film, in a browser that was never here; the server is new at first. */
async function arrival() {
  const times = [];
  for (let visit = 0; visit < 7; visit += 1) {
    const context = await browser.newContext({ viewport: { width: 1280, height: 720 } });
    const fresh = await context.newPage();
    await fresh.goto(server.url, { waitUntil: 'commit' });
    const seen = await fresh.waitForFunction(() => {
      const shown = window.studio?.shown();
      if (!shown || shown.stale) return false;
      // Reading a pixel waits until the picture is drawn.
      window.studio.draw();
      const pixel = Object.assign(document.createElement('canvas'), { width: 1, height: 1 }).getContext('2d');
      pixel.drawImage(document.querySelector('#view'), 0, 0, 1, 1);
      pixel.getImageData(0, 0, 1, 1);
      return performance.now();
    }, null, { polling: 'raf', timeout: 60_000 });
    times.push(await seen.jsonValue());
    await context.close();
  }
  say({ bench: 'studio_arrival', server: 'debug build', first_ms: round(times[0]), median_ms: round(median(times)), max_ms: round(Math.max(...times)), goal_ms: 2000 });
}

/** 2,000 triangles: updates a second while a point is dragged for four seconds, and the time from its release to the final film. */
async function live() {
  await page.goto(`${server.url}/?example=tent`);
  await solved(page);
  await apply(page, { ...await request(page), resolution: { triangles: 2000 } });
  await solved(page);
  await page.evaluate(() => {
    window.seen = [];
    let last = '';
    const look = () => {
      const { job } = window.studio.shown();
      if (job !== last) window.seen.push([performance.now(), job]);
      last = job;
      requestAnimationFrame(look);
    };
    look();
  });
  const [, from] = await points(page);
  const [x, y] = await onStage(page, from);
  await page.mouse.move(x, y);
  await page.mouse.down();
  const started = await page.evaluate(() => performance.now());
  for (let step = 1; step <= 240; step += 1) {
    await page.mouse.move(x - 60 * Math.sin(step / 20), y - 30 * Math.sin(step / 13));
    await page.waitForTimeout(16); // the pace of a hand: a move in each frame
  }
  const released = await page.evaluate(() => performance.now());
  await page.mouse.up();
  await solved(page);
  const seen = await page.evaluate(() => window.seen);
  const during = seen.filter(([time]) => time > started && time < released).length;
  say({ bench: 'studio_live_drag', triangles: 2000, updates_per_second: round(during / ((released - started) / 1000), 1), after_release_ms: round(seen.at(-1)[0] - released), old_studio: { updates_per_second: 9 } });
}

/** 100,000 triangles and 500 points: milliseconds of script for each step of an orbit. */
async function orbit() {
  const boundary = Array.from({ length: 500 }, (_, i) => {
    const angle = (2 * Math.PI * i) / 500;
    return [10 * Math.cos(angle), 10 * Math.sin(angle), 2 * Math.cos(2 * angle)];
  });
  await apply(page, { boundaries: [boundary], resolution: { triangles: 100_000 } });
  await solved(page);
  const costs = await page.evaluate(async () => {
    const canvas = document.querySelector('#view');
    const box = canvas.getBoundingClientRect();
    const event = (type, x, y, buttons) => new PointerEvent(type, { clientX: box.left + x, clientY: box.top + y, buttons, button: type === 'pointermove' ? -1 : 0, pointerId: 1, pointerType: 'mouse', bubbles: true, cancelable: true });
    const found = [];
    canvas.dispatchEvent(event('pointerdown', 40, 100, 1));
    for (let step = 0; step < 60; step += 1) {
      const before = performance.now();
      canvas.dispatchEvent(event('pointermove', 40 + 3 * step, 100 + step, 1));
      const handled = performance.now() - before;
      const drawn = performance.now();
      window.studio.draw();
      found.push(handled + performance.now() - drawn);
      await new Promise((resolve) => { requestAnimationFrame(resolve); });
    }
    document.dispatchEvent(event('pointerup', 220, 160, 0));
    return found;
  });
  say({ bench: 'studio_orbit', triangles: 100_000, points: 500, script_ms_median: round(median(costs), 2), script_ms_max: round(Math.max(...costs), 2), old_studio: { script_ms_for_the_handles: 17 } });
}

/**
 * Drags of a film of 2,000 triangles. Each is a press, a move that is followed, and a release whose film is solved and
 * shown.
 */
const DRAGS = 10_000;
/** The first drags compile the script and fill the history of 500 steps. Growth is counted from here. */
const WARM_UP_DRAGS = 1000;

/** Memory of the page, its worker and its graphics in megabytes, after the garbage was collected. */
async function memoryOf(context, fresh) {
  const session = await context.newCDPSession(fresh);
  await session.send('Performance.enable');
  await session.send('HeapProfiler.collectGarbage');
  const { metrics } = await session.send('Performance.getMetrics');
  const metric = (name) => metrics.find((each) => each.name === name).value;
  const { bytes, breakdown } = await fresh.evaluate(() => performance.measureUserAgentSpecificMemory());
  const ofWorkers = breakdown.filter(({ attribution }) => attribution.some(({ scope }) => scope.includes('Worker')));
  const system = await browser.newBrowserCDPSession();
  const { processInfo } = await system.send('SystemInfo.getProcessInfo');
  // The renderer of this page has used the most processor time.
  const { id } = processInfo.filter(({ type }) => type === 'renderer').sort((a, b) => b.cpuTime - a.cpuTime)[0];
  const resident = /VmRSS:\s+(\d+) kB/.exec(readFileSync(`/proc/${id}/status`, 'utf8'))[1];
  await session.detach();
  await system.detach();
  return {
    script_mb: round(metric('JSHeapUsedSize') / 1e6, 1), page_and_workers_mb: round(bytes / 1e6, 1), workers_mb: round(ofWorkers.reduce((sum, each) => sum + each.bytes, 0) / 1e6, 1),
    renderer_resident_mb: round(Number(resident) / 1000), nodes: metric('Nodes'), listeners: metric('JSEventListeners'),
  };
}

/** Drags the second point to and fro within the page, which waits for no frame of the software renderer. */
const dragWithin = (fresh, count) => fresh.evaluate(async (count) => {
  const canvas = document.querySelector('#view');
  const box = canvas.getBoundingClientRect();
  const event = (type, x, y, buttons) => new PointerEvent(type, { clientX: box.left + x, clientY: box.top + y, buttons, button: type === 'pointermove' ? -1 : 0, pointerId: 1, pointerType: 'mouse', isPrimary: true, bubbles: true, cancelable: true });
  const until = async (condition) => { while (!condition()) await new Promise((resolve) => { setTimeout(resolve, 1); }); };
  const atRest = () => document.body.getAttribute('aria-busy') === 'false';
  for (let drag = 0; drag < count; drag += 1) {
    const { x, y } = window.studio.points()[1];
    const step = drag % 2 === 0 ? 12 : -12;
    const before = window.studio.shown().job;
    canvas.dispatchEvent(event('pointerdown', x, y, 1));
    canvas.dispatchEvent(event('pointermove', x + step, y + step / 2, 1));
    await until(() => atRest() && window.studio.shown().job !== before);
    canvas.dispatchEvent(event('pointerup', x + step, y + step / 2, 0));
    await until(() => atRest() && !window.studio.shown().stale);
  }
}, count);

async function memory() {
  const context = await browser.newContext({ viewport: { width: 900, height: 600 }, reducedMotion: 'reduce' });
  const fresh = await context.newPage();
  fresh.setDefaultTimeout(300_000);
  await fresh.goto(`${server.url}/?example=tent`);
  await solved(fresh);
  await apply(fresh, { ...await request(fresh), resolution: { triangles: 2000 } });
  await solved(fresh);
  await fresh.waitForFunction(() => window.studio.solvesHere());
  const seen = {};
  const started = performance.now();
  for (const many of [WARM_UP_DRAGS, DRAGS / 2, DRAGS]) {
    const done = Number(Object.keys(seen).at(-1)?.slice('after_'.length) ?? 0);
    await dragWithin(fresh, many - done);
    await solved(fresh);
    seen[`after_${many}`] = await memoryOf(context, fresh);
  }
  const [first, last] = [seen[`after_${WARM_UP_DRAGS}`], seen[`after_${DRAGS}`]];
  const growth = (1000 * (last.page_and_workers_mb - first.page_and_workers_mb)) / (DRAGS - WARM_UP_DRAGS);
  say({ bench: 'studio_memory', triangles: 2000, drags: DRAGS, minutes: round((performance.now() - started) / 60_000, 1), ...seen, growth_kb_a_drag: round(growth, 3) });
  await context.close();
}

const figures = { arrival, live, orbit, memory };
const wanted = process.argv.slice(2);
for (const [name, measure] of Object.entries(figures)) if (wanted.length === 0 || wanted.includes(name)) await measure();
await browser.close();
await server.stop();
