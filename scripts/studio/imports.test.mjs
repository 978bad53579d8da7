// Drawings of other programs open right: files/files.json says the unit and the size of each, and whether the file
// leaves its unit open.

import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { fileURLToPath } from 'node:url';
import { covered, onStage, points, request, showPanel, solved, test, useStudio } from './harness.mjs';

const studio = useStudio();
const folder = fileURLToPath(new URL('files/', import.meta.url));
const table = JSON.parse(await readFile(`${folder}files.json`, 'utf8'));

const open = async (page, name) => {
  await page.evaluate(() => document.querySelector('#card')?.remove());
  await page.setInputFiles('#file', `${folder}${name}`);
  await page.locator('#card:not([hidden]), #problem:not([hidden])').first().waitFor();
  await page.waitForFunction(() => document.body.getAttribute('aria-busy') === 'false');
};
const found = (page) => page.evaluate(() => {
  const card = document.querySelector('#card');
  if (!card) return { problem: document.querySelector('#problem').textContent };
  return {
    asks: card.querySelector('.asks') !== null, unit: card.querySelector('[data-field="unit"]').value, size: card.querySelector('.size').textContent,
    lines: window.studio.request().boundaries.length, points: window.studio.request().boundaries.reduce((sum, line) => sum + line.length, 0),
    layers: [...card.querySelectorAll('.layers label')].map((label) => label.textContent), notes: [...card.querySelectorAll('p.small')].slice(1).map((note) => note.textContent),
  };
});

/** Opens a text as a file of this name. */
const give = async (page, name, content) => {
  await page.setInputFiles('#file', { name, mimeType: 'application/octet-stream', buffer: Buffer.from(content) });
  await page.waitForFunction(() => document.body.getAttribute('aria-busy') === 'false');
};
const size = (page) => page.textContent('#card .size');
const SURVEY = 'v 3500123.25 5700987.125 12.5\nv 3500129.25 5700987.125 12.5\nv 3500129.25 5700993.125 14.25\nv 3500123.25 5700993.125 12.5\nl 1 2 3 4 1\n';

test.quick('a file far from the model before it is solved in the middle of the stage, and undo comes back to the model', async () => {
  const { page } = studio;
  await studio.open('tent');
  const before = { request: await request(page), points: await points(page) };
  await give(page, 'survey.obj', SURVEY);
  await solved(page);
  const seen = await points(page);
  assert.ok(Math.max(...seen.map(({ x }) => x)) - Math.min(...seen.map(({ x }) => x)) > 300, 'the points span the stage');
  assert.ok(await covered(page) > 0.05, 'the film is seen');
  assert.equal(await size(page), '6 by 6 m, 1.75 m high');
  await page.click('#card button:text-is("Undo")');
  await solved(page);
  assert.deepEqual(await request(page), before.request);
  const [a, b] = [before.points[0], (await points(page))[0]];
  assert.ok(Math.hypot(a.x - b.x, a.y - b.y) < 40, 'the model is seen where it was');
  assert.equal(await page.isVisible('#card'), false);
});

test('the card changes unit, layers, axis and origin as one step of undo', async () => {
  const { page } = studio;
  await studio.open('tent');
  await page.uncheck('#live');
  const before = await request(page);
  await open(page, 'ezdxf-sail-unitless.dxf');
  assert.match(await page.textContent('#card .asks'), /does not say its unit/);
  await page.selectOption('#card [data-field="unit"]', 'ft');
  assert.equal(await size(page), '3,780 by 1,860 m, 762 m high');
  await page.selectOption('#card [data-field="up"]', 'y');
  assert.equal(await size(page), '3,780 by 762 m, 1,860 m high', 'the second axis of the file points up');
  await page.click('#undo');
  assert.deepEqual(await request(page), before, 'one step takes all of it back');

  await open(page, 'ezdxf-layers.dxf');
  assert.equal((await request(page)).boundaries.length, 2);
  await page.uncheck('#card [data-field="layer SITE"]');
  assert.equal(await size(page), '12.4 by 6.1 m');
  assert.equal((await request(page)).boundaries.length, 1);
  await page.click('#card [data-field="layer SAIL"]');
  assert.match(await page.textContent('#problem'), /at least one layer/);
  assert.equal(await page.isChecked('#card [data-field="layer SAIL"]'), true, 'the last layer stays');

  await open(page, 'ezdxf-survey-mm.dxf');
  assert.deepEqual((await request(page)).boundaries[0][0], [2683120.956, 1247321.123, 410.25]);
  await page.check('#card [data-field="local"]');
  const [[x, y]] = (await request(page)).boundaries[0];
  assert.ok(Math.abs(x) < 100 && Math.abs(y) < 100, 'near zero');
  await page.click('#card button:text-is("Done")');
  assert.equal(await page.isVisible('#card'), false);
});

test('arcs, splines and weights of DXF are the curves that they stand for', async () => {
  const { page } = studio;
  await studio.open('tent');
  await page.uncheck('#live');
  const ring = async (name) => {
    await open(page, name);
    return (await request(page)).boundaries[0];
  };
  const area = (points) => points.reduce((sum, [x, y], i) => sum + (x * points[(i + 1) % points.length][1] - y * points[(i + 1) % points.length][0]) / 2, 0);
  const stadium = 48 + 9 * Math.PI;
  assert.ok(Math.abs(area(await ring('ezdxf-bulges.dxf')) / stadium - 1) < 5e-3);
  assert.ok(Math.abs(Math.abs(area(await ring('ezdxf-mirrored.dxf'))) / (48 - 9 * Math.PI) - 1) < 5e-3, 'with the extrusion -z the arcs bend inwards');
  for (const [x, y] of await ring('ezdxf-rational-spline.dxf')) assert.ok(Math.abs(Math.hypot(x, y) - 10) < 1e-9, 'a quarter of a circle');
  // The uniform cubic spline of a rectangle passes a sixth of the way from each corner to its neighbours.
  assert.ok((await ring('ezdxf-spline.dxf')).some(([x, y]) => Math.hypot(x - 10 / 6, y - 1) < 1e-9));
  // A spline without control points passes the points that it was fitted to. Where the last one is the first, it is
  // closed.
  const through = [[0, 0], [5, -1], [10, 0], [10, 6], [0, 6]];
  const fitted = await ring('ezdxf-spline-through.dxf');
  for (const [x, y] of through) assert.ok(fitted.some((point) => Math.hypot(point[0] - x, point[1] - y) < 1e-9), `through ${x}, ${y}`);
  const fits = [...through, through[0]];
  const spline = (z) => `0\nSPLINE\n8\n0\n70\n0\n71\n3\n74\n6\n${fits.map(([x, y]) => `11\n${x}\n21\n${y}\n31\n${z}\n`).join('')}`;
  await studio.open('wavy-strip');
  await give(page, 'rails.dxf', `0\nSECTION\n2\nENTITIES\n${spline(0)}${spline(2)}0\nENDSEC\n0\nEOF\n`);
  const strip = await request(page);
  assert.equal(strip.closed, true);
  assert.deepEqual(strip.directrices.map((rail) => rail.length), [40, 40], 'eight points from each to the next, also from the last to the first');
});

test.quick('the two rails of an own strip come back from its OBJ, whatever is drawn before', async () => {
  const { page } = studio;
  await studio.open('wavy-strip');
  const { directrices } = await request(page);
  const job = await page.evaluate(() => window.studio.shown().job);
  const obj = await (await fetch(`${studio.url}/v1/jobs/${job}/mesh?format=obj`)).text();
  await studio.open('tent');
  await give(page, 'strip.obj', obj);
  assert.equal(await page.evaluate(() => window.studio.kind()), 'ruled_surface');
  assert.deepEqual((await request(page)).directrices.map((rail) => rail.length), directrices.map((rail) => rail.length));
  await solved(page);
});

test('short edges in survey coordinates stay apart, and lines with arcs and splines form one loop', async () => {
  const { page } = studio;
  await studio.open('tent');
  await page.uncheck('#live');
  const corners = [[0, 0], [8, 0], [8, 5.8], [7.8, 6], [0, 6]].map(([x, y]) => [465000 + x, 5247300 + y]);
  const edges = corners.map(([x, y], i) => {
    const [u, v] = corners[(i + 1) % corners.length];
    return `0\nLINE\n8\n0\n10\n${x}\n20\n${y}\n30\n0\n11\n${u}\n21\n${v}\n31\n0\n`;
  });
  await give(page, 'plot.dxf', `0\nSECTION\n2\nENTITIES\n${edges.join('')}0\nENDSEC\n0\nEOF\n`);
  assert.deepEqual((await request(page)).boundaries.map((boundary) => boundary.length), [5]);
  const area = (points) => Math.abs(points.reduce((sum, [x, y], i) => sum + (x * points[(i + 1) % points.length][1] - y * points[(i + 1) % points.length][0]) / 2, 0));
  for (const [file, square] of [['freecad-stadium.dxf', 48 + 9 * Math.PI], ['librecad-arch.dxf', 48 + 25 * Math.asin(0.8) - 12]]) {
    await open(page, file);
    const largest = Math.max(...(await request(page)).boundaries.map((boundary) => area(boundary)));
    assert.ok(Math.abs(largest / square - 1) < 5e-3, `${file}: ${largest} m² of ${square}`);
  }
  await open(page, 'freecad-leaf.dxf');
  assert.deepEqual((await request(page)).boundaries.map((boundary) => boundary.length), [9]);
});

test('what was done to a file stays in view beside the error of its film', async () => {
  const { page } = studio;
  await studio.open('tent');
  await open(page, 'geopandas-degrees.geojson');
  await page.locator('#problem:not([hidden])').waitFor();
  const note = await page.locator('#card p:has-text("projected to a plane")').boundingBox();
  const sheet = await page.locator('#sheet').boundingBox();
  assert.ok(note.y >= sheet.y && note.y + note.height <= sheet.y + sheet.height, JSON.stringify({ note, sheet }));
});

test('a file that is no drawing is named, and the numbers of tables are read as people write them', async () => {
  const { page } = studio;
  await studio.open('tent');
  await page.uncheck('#live');
  const before = await request(page);
  const wrong = { 'photo.jpg': ['\xff\xd8\xff\xe0JFIF', /picture, which has no lines/], 'plan.pdf': ['%PDF-1.7', /PDF\. Save the drawing as DXF/], 'plan.dwg': ['AC1032', /DWG/], 'points.xlsx': ['PK\x03\x04', /Save the points as CSV/] };
  for (const [name, [content, sentence]] of Object.entries(wrong)) {
    await give(page, name, Buffer.from(content, 'latin1'));
    assert.match(await page.textContent('#problem'), sentence);
    assert.deepEqual(await request(page), before);
  }
  const tables = {
    'comma.csv': '0,5;0;0\n4,5;0;1,25\n4,5;3;0\n', 'spaced.txt': '0,5 0 0\n4,5 0 1,25\n4,5 3 0\n', 'quoted.csv': '"0,5","0","0"\n"4,5","0","1,25"\n"4,5","3","0"\n',
    'wide.txt': Buffer.from('\ufeffx\ty\tz\n0,5\t0\t0\n4,5\t0\t1,25\n4,5\t3\t0\n', 'utf16le'), 'numbered.csv': 'P1;0.5;0;0\nP2;4.5;0;1.25\nP3;4.5;3;0\n',
  };
  for (const [name, content] of Object.entries(tables)) {
    await give(page, name, content);
    assert.deepEqual((await request(page)).boundaries, [[[0.5, 0, 0], [4.5, 0, 1.25], [4.5, 3, 0]]], name);
  }
  await give(page, 'thousands.csv', "2'683'120.5;1'247'321.25;1.234,5\n2'683'124.5;1'247'321.25;1.234,5\n2'683'124.5;1'247'325.25;1.234,5\n");
  assert.deepEqual((await request(page)).boundaries[0][2], [2683124.5, 1247325.25, 1234.5]);
});

test('another unit asks whether the drawing keeps its size or its numbers', async () => {
  const { page } = studio;
  await studio.open('tent');
  await page.uncheck('#live');
  await give(page, 'sail.csv', 'x (m),y (m),z (m)\n0,0,0\n6,0,1\n6,6,0\n0,6,1\n');
  await page.click('#card button:text-is("Done")');
  await page.selectOption('#options [name="units"]', 'mm');
  assert.match(await page.textContent('#card'), /The drawing is 6 by 6 m, 1 m high. Convert it to mm, or keep its numbers\?/);
  await page.click('#card button:has-text("Convert: 6,000 by 6,000 mm, 1,000 mm high")');
  assert.deepEqual((await request(page)).boundaries, [[[0, 0, 0], [6000, 0, 1000], [6000, 6000, 0], [0, 6000, 1000]]]);
  await page.click('#undo');
  assert.deepEqual((await request(page)).boundaries[0][1], [6, 0, 1]);
  assert.notEqual((await request(page)).units, 'mm', 'unit and numbers are one step');
  await page.selectOption('#options [name="units"]', 'mm');
  await page.click('#card button:has-text("Keep the numbers: 6 by 6 mm")');
  assert.deepEqual([(await request(page)).units, (await request(page)).boundaries[0][1]], ['mm', [6, 0, 1]]);
});

test('no digit of a survey coordinate is cut off in its field', async () => {
  const { page } = studio;
  await studio.open('tent');
  await page.uncheck('#live');
  for (const width of [1440, 1280, 390]) {
    await page.setViewportSize({ width, height: 844 });
    await give(page, 'survey.csv', 'x (mm);y (mm);z (mm)\n2683120956.125;1247321123.5;410250\n2683133356;1247321123;412750\n2683133356;1247327223;410250\n');
    await page.evaluate(() => document.querySelector('#card button.primary').click());
    await page.selectOption('#options [name="units"]', 'mm');
    await page.click('#card button.primary');
    await page.mouse.click(...await onStage(page, (await points(page))[0]));
    const fields = await page.locator('#point [data-axis]').evaluateAll((inputs) => inputs.map((input) => [input.value, input.scrollWidth <= input.clientWidth + 1, input.getBoundingClientRect().right <= innerWidth]));
    assert.deepEqual(fields, [['2683120956.125', true, true], ['1247321123.5', true, true], ['410250', true, true]], `at ${width}`);
    await page.selectOption('#options [name="units"]', 'm');
    await page.click('#card button.primary');
  }
});

test('drawings of other programs open in their unit and size, and ask exactly where they name no unit', async () => {
  const { page } = studio;
  await studio.open('tent');
  await page.uncheck('#live');
  const wrong = [];
  for (const { file, ...expected } of table) {
    await open(page, file);
    const given = await found(page);
    if (process.env.PRINT) console.log(JSON.stringify({ file, ...given }));
    for (const [name, value] of Object.entries(expected)) {
      if (JSON.stringify(given[name]) !== JSON.stringify(value)) wrong.push(`${file}: ${name} is ${JSON.stringify(given[name])}, not ${JSON.stringify(value)}`);
    }
    // The drawing fills the stage: its points do not lie on one pixel.
    const seen = await points(page);
    const spread = Math.max(...seen.map(({ x }) => x)) - Math.min(...seen.map(({ x }) => x));
    if (!(spread > 200) || !seen.every(({ x, y }) => x > 0 && y > 0 && x < 960 && y < 720)) wrong.push(`${file}: its points span ${Math.round(spread)} pixels of the stage`);
  }
  assert.deepEqual(wrong, []);
});
