// From the request to the result: live, long, cancelled, found again, compared.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { apply, covered, lacksOwnServer, onStage, points, request, showPanel, solved, startServer, test, useStudio } from './harness.mjs';

const studio = useStudio();

test('every kind is solved and shown with its own figures', async () => {
  const { page } = studio;
  for (const name of ['catenoid', 'wavy-strip', 'vault']) {
    await studio.open(name);
    const { job: id } = await page.evaluate(() => window.studio.shown());
    const job = await (await fetch(`${studio.url}/v1/jobs/${id}`)).json();
    assert.equal(job.status, 'succeeded');
    assert.ok((await page.textContent('#statistics')).includes(`Triangles${job.statistics.triangles.toLocaleString('en')}`), name);
    assert.ok(await covered(page) > 0.03, `${name}: the mesh is seen`);
  }
});

test('a live drag never shows an older film after a newer one, and ends with that of the last points', async () => {
  const { page } = studio;
  // Drawings that are slow to solve are solved when the drag ends. By this page's clock none is,
  // however busy the machine is.
  await page.addInitScript(() => { performance.now = () => 0; });
  await studio.open('tent');
  const area = (boundaries) => JSON.stringify(boundaries);
  await page.evaluate(() => {
    window.order = [];
    const known = new Set();
    const look = () => {
      const shown = window.studio.shown();
      if (shown && !known.has(shown.job)) {
        known.add(shown.job);
        window.order.push(JSON.parse(shown.solved).boundaries);
      }
      requestAnimationFrame(look);
    };
    look();
  });
  const [, from] = await points(page);
  const [x, y] = await onStage(page, from);
  await page.mouse.move(x, y);
  await page.mouse.down();
  const wanted = [];
  for (let step = 1; step <= 40; step += 1) {
    await page.mouse.move(x - step, y - step / 2);
    wanted.push(area((await request(page)).boundaries));
    // Every tenth film is waited for, the others are superseded or seen, as it happens.
    if (step % 10 === 0) await page.waitForFunction(() => !window.studio.shown().stale);
  }
  await page.mouse.up();
  await solved(page);
  const final = await request(page);
  const order = (await page.evaluate(() => window.order)).map(area);
  const places = order.map((each) => wanted.lastIndexOf(each)).filter((place) => place >= 0);
  assert.ok(places.length >= 2, `${places.length} films were seen`);
  assert.deepEqual(places, [...places].sort((a, b) => a - b), 'in the order of the drag');
  assert.equal(order.at(-1), area(final.boundaries), 'the last film is of the last points');
});

test('after an edit the figures and downloads are out of date until it is solved again', async () => {
  const { page } = studio;
  await studio.open('tent');
  await showPanel(page, 'setup');
  await page.uncheck('#live');
  await page.locator('#view').focus();
  await page.keyboard.press(']');
  await page.keyboard.press('PageUp');
  await showPanel(page, 'results');
  assert.equal(await page.isVisible('#stale'), true);
  assert.equal(await page.locator('#result').evaluate((box) => box.classList.contains('stale')), true);
  assert.equal(await page.isDisabled('#downloads button >> nth=0'), true);
  assert.ok(await covered(page) < 0.02, 'the film is a ghost');
  await page.click('#undo');
  assert.equal(await page.isVisible('#stale'), false, 'undo brings back the drawing that the result belongs to');
  assert.equal(await page.isDisabled('#downloads button >> nth=0'), false);
  await page.click('#redo');
  await showPanel(page, 'setup');
  await page.click('#solve');
  await solved(page);
  await showPanel(page, 'results');
  assert.equal(await page.isDisabled('#downloads button >> nth=0'), false);
});

test.quick('a long job shows charts, time and stage, is found again after a reload, and cancelled', async (t) => {
  if (lacksOwnServer(t)) return;
  const { page, hold } = studio;
  await studio.open('helicoid');
  // The charts get every report of the first half, and the second half never comes. This solver has many reports there.
  for (const stage of ['each_progress', 'half']) await hold.at(stage);
  await apply(page, { ...await request(page), solver: 'vertex_relaxation', resolution: { triangles: 500 } });
  await page.waitForFunction(() => /%.*\d+ (s|min)/.test(document.querySelector('#status').textContent));
  await page.waitForFunction(() => document.querySelector('#running-charts .chart .curve'));
  assert.ok(await page.locator('#running-charts .chart text').count() >= 4, 'the chart has axes');
  const newest = async () => (await (await fetch(`${studio.url}/v1/jobs?limit=1`)).json()).jobs[0];
  const { id } = await newest();
  await page.waitForFunction((job) => JSON.parse(sessionStorage.getItem('plateau.work'))?.job === job, id);
  await page.goto(`${studio.url}/`);
  await page.waitForFunction(() => /iteration/.test(document.querySelector('#status').textContent));
  assert.equal((await newest()).id, id, 'the same job, not another');
  await page.click('#cancel');
  await page.waitForFunction(() => document.querySelector('#status').textContent === 'Cancelled.');
  assert.equal((await (await fetch(`${studio.url}/v1/jobs/${id}`)).json()).status, 'cancelled');
  assert.equal(await page.isVisible('#cancel'), false);
});

test('a recent job opens with its drawing', async () => {
  const { page } = studio;
  await studio.open('wavy-strip');
  const strip = await request(page);
  await page.click('#open-gallery');
  await page.click('#gallery [data-example="tent"]');
  await solved(page);
  await page.click('#open-recent');
  await page.locator('#recent-list tr:has-text("wave") button').first().click();
  await solved(page);
  assert.deepEqual(await request(page), strip);
});

test('the page is busy from the press that opens something until it is shown, or has failed', async () => {
  const { page } = studio;
  await studio.open('wavy-strip');
  const strip = await request(page);
  const busy = () => page.getAttribute('body', 'aria-busy');
  /** Holds what the page asks of an address until it is let go. */
  const hold = async (address, end = (route) => route.continue()) => {
    let release;
    const gate = new Promise((resolve) => { release = resolve; });
    await page.route(address, async (route) => { await gate; await end(route); });
    return async () => { release(); await page.waitForFunction(() => document.body.getAttribute('aria-busy') === 'false'); await page.unroute(address); };
  };
  const openTent = async () => {
    await page.click('#open-gallery');
    await page.click('#gallery [data-example="tent"]');
  };

  const refused = await hold('**/v1/examples/tent', (route) => route.abort());
  await openTent();
  assert.equal(await busy(), 'true', 'an example that is being fetched');
  await refused();
  assert.match(await page.textContent('#problem'), /cannot be reached/);
  assert.deepEqual(await request(page), strip, 'a failure changes nothing');

  const [{ links: { self } }] = (await (await fetch(`${studio.url}/v1/jobs?limit=1`)).json()).jobs;
  const fetched = await hold(`**${self}`);
  await page.click('#open-recent');
  await page.locator('#recent-list button:not(:disabled)').first().click();
  assert.equal(await busy(), 'true', 'a recent job that is being fetched');
  await fetched();

  const slow = await hold('**/v1/examples/tent');
  await openTent();
  await page.click('#open-gallery');
  await page.click('#gallery [data-example="vault"]');
  await page.waitForFunction(() => 'domain' in window.studio.request());
  assert.equal(await busy(), 'true', 'the first is still under way');
  await slow();
  assert.ok('domain' in await request(page), 'of two openings the later one wins');
  await solved(page);

  // A kind whose drawing is at hand is opened at once, also while the example of a kind that was passed is on its way.
  const choose = (kind) => page.locator(`#kinds label:has([value="${kind}"])`).click();
  const shows = (kind) => page.waitForFunction((wanted) => window.studio.kind() === wanted, kind);
  for (const kind of ['minimal_surface', 'uniform_mesh']) {
    await choose(kind);
    await shows(kind);
  }
  for (const [kind, why] of [['minimal_surface', 'a kind with a drawing of its own'], ['uniform_mesh', 'the kind of the document']]) {
    await choose('uniform_mesh');
    await shows('uniform_mesh');
    const passed = await hold('**/v1/examples/four-cables');
    await choose('cable_net');
    await choose(kind);
    await passed();
    assert.equal(await page.evaluate(() => window.studio.kind()), kind, why);
    assert.ok(await page.locator(`#kinds [value="${kind}"]`).isChecked(), why);
  }
});

test('each objective of a strip is a tile with its own picture, and one is taken', async () => {
  const { page } = studio;
  await studio.open('wang-tang-v');
  const { objectives } = await (await fetch(`${studio.url}/v1/objectives`)).json();
  const names = objectives.filter(({ kind }) => kind === 'ruled_surface').map(({ name }) => name);
  await page.click('[data-mode="compare"]');
  await page.waitForFunction((count) => document.querySelectorAll('.tile dl').length === count, names.length);
  assert.deepEqual(await page.locator('.tile').evaluateAll((tiles) => tiles.map((tile) => tile.dataset.objective)), names);
  for (const label of ['Area', 'Twist', 'Bending']) {
    const rows = await page.locator(`.tile dl:has(dt:text-is("${label}"))`).evaluateAll((lists, each) => lists.map((list) => {
      const value = [...list.querySelectorAll('dt')].find((dt) => dt.textContent === each).nextElementSibling;
      return [parseFloat(value.textContent.replaceAll(',', '')), value.className];
    }), label);
    const least = Math.min(...rows.map(([value]) => value));
    assert.ok(rows.some(([value, name]) => name === 'best' && value === least), `${label}: the least is bold`);
  }
  assert.ok(await covered(page) > 0.05, 'the tiles have pictures');
  const { y, height } = await page.locator('#tiles').boundingBox();
  for (const tile of await page.locator('.tile').all()) {
    const box = await tile.boundingBox();
    assert.ok(box.y >= y && box.y + box.height <= y + height + 1, 'each tile is in view as a whole');
  }
  await page.click('.tile[data-objective="minimal_twist"] button');
  assert.equal((await request(page)).objective, 'minimal_twist');
  await solved(page);
  assert.match(await page.textContent('#statistics'), /Objectiveminimal twist/);
});

test('the flat pattern fills the stage and is zoomed about the pointer', async () => {
  const { page } = studio;
  await studio.open('wavy-strip');
  await page.click('[data-mode="flat"]');
  await page.waitForFunction(() => document.querySelector('#flat-image').naturalWidth > 0 && document.querySelector('#flat-image').offsetWidth > 0);
  const stage = await page.locator('#stage').boundingBox();
  const before = await page.locator('#flat-image').boundingBox();
  assert.ok(before.width > 0.7 * stage.width || before.height > 0.6 * stage.height, `${before.width} × ${before.height}`);
  await page.mouse.move(before.x, before.y);
  await page.mouse.wheel(0, -300);
  await page.waitForFunction((width) => document.querySelector('#flat-image').offsetWidth > 1.3 * width, before.width);
  const after = await page.locator('#flat-image').boundingBox();
  assert.ok(Math.hypot(after.x - before.x, after.y - before.y) < 5);
});

test('every format is downloaded, the flat pattern too', async () => {
  const { page } = studio;
  await studio.open('wavy-strip');
  await showPanel(page, 'results');
  const starts = { GLB: 'glTF', GLTF: '{', OBJ: '# plateau', PLY: 'ply\n', STL: 'binary STL', SVG: '<svg ', DXF: '999\n' };
  assert.equal(await page.locator('#downloads button, #pattern-downloads button').count(), Object.keys(starts).length);
  for (const [format, start] of Object.entries(starts)) {
    const waiting = page.waitForEvent('download');
    await page.click(`#results button:text-is("${format}")`);
    const download = await waiting;
    assert.match(download.suggestedFilename(), new RegExp(`^a-strip-between-a-wave-of-60-and-a-wave-of-80-points\\.${format.toLowerCase()}$`));
    const bytes = await readFile(await download.path());
    assert.equal(bytes.subarray(0, start.length).toString('latin1'), start);
  }
});

test('a server with keys is used with a key', async (t) => {
  if (lacksOwnServer(t)) return;
  const { page } = studio;
  const made = spawnSync(process.env.PLATEAU_BIN, ['key', 'new', 'tester'], { encoding: 'utf8' }).stdout;
  const [key, line] = made.trim().split('\n').map((each) => each.replace(/^.*?: */, ''));
  const folder = await mkdtemp(join(tmpdir(), 'plateau-keys-'));
  await writeFile(join(folder, 'keys'), `${line}\n`);
  const locked = await startServer({ PLATEAU_AUTH__KEYS_FILE: join(folder, 'keys') });
  studio.allowed.push(locked.url);
  try {
    await page.goto(locked.url);
    await page.locator('#settings[open]').waitFor();
    await page.fill('#api-key', key);
    await page.keyboard.press('Enter');
    await solved(page);
    await showPanel(page, 'results');
    const waiting = page.waitForEvent('download');
    await page.click('#downloads button:text-is("OBJ")');
    assert.ok(await (await waiting).path());
    await page.reload();
    await solved(page);
    await page.click('#open-share');
    await page.click('#share-forms button:text-is("Python")');
    await page.locator('#share-forms [aria-pressed="true"]:text-is("Python")').waitFor();
    const text = await page.inputValue('#share-text');
    assert.ok(text.includes('PLATEAU_KEY') && !text.includes(key), 'a copied program names the key and does not hold it');
  } finally {
    await page.goto('about:blank');
    await locked.stop();
    await rm(folder, { recursive: true });
  }
});
