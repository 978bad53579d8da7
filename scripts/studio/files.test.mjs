// Drawings come in by file, by drop and by paste, in every format alike; garbage gets one sentence with its line.

import assert from 'node:assert/strict';
import { request, solved, test, useStudio } from './harness.mjs';

const studio = useStudio();
const SQUARE = [[0, 0, 0], [6, 0, 1], [6, 6, 0], [0, 6, 1]];

const dxfLine = (points) => ['0', 'SECTION', '2', 'ENTITIES', '0', 'POLYLINE', '8', '0', '66', '1', '70', '9',
  ...points.flatMap(([x, y, z]) => ['0', 'VERTEX', '8', '0', '10', x, '20', y, '30', z, '70', '32']), '0', 'SEQEND', '0', 'ENDSEC', '0', 'EOF', ''].join('\n');
const FILES = {
  csv: `x,y,z\n${SQUARE.map((point) => point.join(',')).join('\n')}\n`,
  obj: `# a square\n${SQUARE.map((point) => `v ${point.join(' ')}`).join('\n')}\nl 1 2 3 4 1\n`,
  dxf: dxfLine(SQUARE),
  geojson: JSON.stringify({ type: 'FeatureCollection', features: [{ type: 'Feature', properties: {}, geometry: { type: 'Polygon', coordinates: [[...SQUARE, SQUARE[0]]] } }] }, null, 1),
};
const glTF = () => {
  const metres = SQUARE.map(([x, y, z]) => [x, z, -y]);
  const buffer = Buffer.from(new Float32Array(metres.flat()).buffer);
  return JSON.stringify({
    asset: { version: '2.0' }, scene: 0, scenes: [{ nodes: [0] }], nodes: [{ mesh: 0 }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0 }, mode: 2 }] }],
    accessors: [{ bufferView: 0, componentType: 5126, count: 4, type: 'VEC3', min: [0, 0, -6], max: [6, 1, 0] }],
    bufferViews: [{ buffer: 0, byteLength: buffer.length }], buffers: [{ byteLength: buffer.length, uri: `data:application/octet-stream;base64,${buffer.toString('base64')}` }],
  });
};

const handOver = {
  file: (page, name, text) => page.setInputFiles('#file', { name, mimeType: 'text/plain', buffer: Buffer.from(text) }),
  drop: (page, name, text) => page.evaluate(([file, content]) => {
    const dataTransfer = new DataTransfer();
    dataTransfer.items.add(new File([content], file));
    document.querySelector('#stage').dispatchEvent(new DragEvent('drop', { dataTransfer, bubbles: true, cancelable: true }));
  }, [name, text]),
  paste: (page, name, text) => page.evaluate((content) => {
    const clipboardData = new DataTransfer();
    clipboardData.setData('text/plain', content);
    document.querySelector('#view').dispatchEvent(new ClipboardEvent('paste', { clipboardData, bubbles: true, cancelable: true }));
  }, text),
};

test('the same square by file, drop and paste, in each format', async () => {
  const { page } = studio;
  await studio.open('tent');
  const before = await request(page);
  for (const [format, text] of Object.entries({ ...FILES, gltf: glTF() })) {
    for (const [way, give] of Object.entries(handOver)) {
      await give(page, `square.${format}`, text);
      await page.waitForFunction(() => window.studio.request().boundaries[0].length === 4 && window.studio.request().boundaries[0][1][0] === 6);
      assert.deepEqual((await request(page)).boundaries, [SQUARE], `${format} by ${way}`);
      await page.click('#undo');
      assert.deepEqual(await request(page), before, 'one step of undo brings back what was there');
    }
  }
});

test.quick('a strip takes both of its rails from a file', async () => {
  const { page } = studio;
  await studio.open('two-rails');
  await handOver.file(page, 'rails.csv', '0;0;0\n5;0;2\n10;0;0\n\n0;5;0\n10;5;1\n');
  await page.waitForFunction(() => window.studio.request().directrices[0].length === 3 && window.studio.request().directrices[1][1][0] === 10);
  assert.deepEqual((await request(page)).directrices, [[[0, 0, 0], [5, 0, 2], [10, 0, 0]], [[0, 5, 0], [10, 5, 1]]]);
  await solved(page);
});

test('survey coordinates keep every digit', async () => {
  const { page } = studio;
  await studio.open('tent');
  await handOver.file(page, 'survey.obj', 'v 3500123.456789 5700987.125 12.5\nv 3500129.456789 5700987.125 12.5\nv 3500129.456789 5700993.125 14.25\nl 1 2 3 1\n');
  await page.waitForFunction(() => window.studio.request().boundaries[0][0][0] > 3e6);
  assert.deepEqual((await request(page)).boundaries[0][0], [3500123.456789, 5700987.125, 12.5]);
});

test.quick('garbage gets one sentence with its line, and the drawing stays', async () => {
  const { page } = studio;
  await studio.open('tent');
  const before = await request(page);
  const cases = {
    'points.csv': ['x,y,z\n0,0,0\n1,two,0\n', /Line 3: “two” is not a number/],
    'lines.obj': ['v 0 0 0\nv 1 0\n', /Line 2: a vertex needs x, y and z/],
    'faces.obj': ['v 0 0 0\nf 1 2 7\n', /Line 2: there is no vertex “2”/],
    'bad.dxf': ['0\nSECTION\nhello\nENTITIES\n', /Line 3: “hello” is not a DXF group code/],
    'empty.geojson': ['{"type":"FeatureCollection","features":[]}', /no lines or polygons/],
    'bad.geojson': ['{\n"type":"LineString",\n"coordinates":[[0,0],\n[1,"x"]]}', /Line 4: \[1,"x"\] is not a position/],
    'cut.json': ['{\n"boundaries": [[\n', /Line 3: this is not JSON/],
    'other.json': ['{"a":1}', /neither a request .* nor GeoJSON nor glTF/],
    'nothing.csv': ['', /nothing in it/],
  };
  for (const [name, [text, sentence]] of Object.entries(cases)) {
    await handOver.file(page, name, text);
    await page.locator(`#problem:has-text("${name} cannot be opened")`).waitFor();
    assert.match(await page.textContent('#problem'), sentence, name);
    assert.deepEqual(await request(page), before, name);
  }
});

test('a saved request opens again, as the kind that it is', async () => {
  const { page } = studio;
  await studio.open('wavy-strip');
  const before = await request(page);
  await page.click('#request-box summary');
  const waiting = page.waitForEvent('download');
  await page.click('#save-request');
  const file = await (await waiting).path();
  await studio.open('tent');
  await page.setInputFiles('#file', file);
  await page.waitForFunction(() => 'directrices' in window.studio.request());
  assert.deepEqual(await request(page), before);
  assert.equal(await page.isChecked('#kinds input[value="ruled_surface"]'), true);
  await solved(page);
});
