// The page says things in its own words: for each warning, failure and objective of the service, counted from 1.

import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { fileURLToPath } from 'node:url';
import { apply, showPanel, solved, test, useStudio } from './harness.mjs';

const studio = useStudio();
const openapi = JSON.parse(await readFile(new URL('../../api/openapi.json', import.meta.url), 'utf8'));
/** The codes of warnings with the names of their values, as the service documents them. */
const CODES = Object.fromEntries([...openapi.components.schemas.JobWarning.properties.code.description.matchAll(/^- `(\w+)`: (.*)$/gm)]
  .map(([, code, text]) => [code, [...(/: ([^:]*)$/.exec(text)?.[1] ?? '').matchAll(/`(\w+)`/g)].map(([, name]) => name)]));

async function words(name = 'words') {
  const { build } = createRequire(new URL('../../web/package.json', import.meta.url))('esbuild');
  const entry = fileURLToPath(new URL(`../../web/src/${name}.ts`, import.meta.url));
  const { outputFiles: [{ text }] } = await build({ entryPoints: [entry], bundle: true, format: 'esm', write: false });
  return import(`data:text/javascript;base64,${Buffer.from(text).toString('base64')}`);
}

test.quick('each warning of the service has a sentence of the page, made of its values', async () => {
  const { WARNINGS, sayWarning } = await words();
  assert.ok(Object.keys(CODES).length > 30, 'the codes were found');
  assert.deepEqual(Object.keys(WARNINGS).sort(), Object.keys(CODES).sort());
  const places = ['directrix', 'strip', 'boundary', 'point', 'layer', 'cable', 'mast', 'support', 'from', 'to'];
  for (const [code, names] of Object.entries(CODES)) {
    // Every place is the first one, which people call 1.
    const values = Object.fromEntries(names.map((name, i) => [name, places.includes(name) ? 0 : 2.5 + i]));
    const { sentence } = sayWarning(code, values, 'text of the service', 'm');
    assert.match(sentence, /^[A-Z0-9].*[.]$/s, code);
    assert.doesNotMatch(sentence, /\?|undefined|NaN|_|\b0\b|text of the service/, `${code}: ${sentence}`);
    for (const name of names.filter((each) => !places.includes(each))) {
      const other = sayWarning(code, { ...values, [name]: 7777 }, '', 'm').sentence;
      // The mesh's own faults are counted in the statistics. A structure has one slack cable, a net has several edges.
      if (!['flipped_triangles', 'degenerate_triangles'].includes(name) && !(code === 'slack_cable' && name === 'count')) assert.notEqual(other, sentence, `${code} says its ${name}`);
    }
  }
  assert.deepEqual(sayWarning('code_of_tomorrow', {}, 'what the service says', 'm'), { sentence: 'what the service says', detail: null });
  assert.match(sayWarning('film', { residual: 0.5 }, 'not_converged: it stopped', 'm').sentence, /^The film under the lattice: The solver stopped at a residual of 0\.5/);
});

test.quick('each objective that the service offers, and each failure that the page knows, has its sentence', async () => {
  const { OBJECTIVES, FAILURES } = { ...await words('failures'), ...await words('objectives') };
  const { objectives } = await (await fetch(`${studio.url}/v1/objectives`)).json();
  // A program that is built for tests has a kind more.
  const offered = objectives.filter(({ kind }) => kind !== 'enlargement');
  assert.ok(offered.length > 10);
  for (const { kind, name } of offered) assert.match(OBJECTIVES[kind]?.[name] ?? '', /^[A-Z][^_[\]]*\.$/, `${kind}, ${name}`);
  for (const name of Object.keys(FAILURES)) assert.equal((await fetch(`${studio.url}/problems/${name}`)).status, 200, `the service has the failure ${name}`);
});

test.quick('places in the texts of the service count from 1, and numbers that are no places stay', async () => {
  const { fromOne } = await words('failures');
  const texts = {
    'point 3 of boundary 0 lies on edge 0': 'point 4 of boundary 1 lies on edge 1',
    'edges 1 and 3 of the boundary meet': 'edges 2 and 4 of the boundary meet', 'points 0, 1 and 2 of /boundaries/0 lie on a line': 'points 1, 2 and 3 of boundaries 1 lie on a line',
    'vertices 4 to 6': 'vertices 5 to 7', 'needs at least 3 points': 'needs at least 3 points', 'is 0.5 beside vertex 0.25': 'is 0.5 beside vertex 0.25', 'more than 20000 triangles': 'more than 20000 triangles',
  };
  for (const [text, expected] of Object.entries(texts)) assert.equal(fromOne(text), expected);
});

test('warnings name edges, points and strips by their numbers from 1 and by no pointer', async () => {
  const { page } = studio;
  await studio.open('cable-net-by-targets');
  await showPanel(page, 'results');
  assert.equal(await page.textContent('#warnings [data-code="slack_cable"]'), 'Slack cable44 edges carry no force by the targets alone. The least force density keeps a force there.');
  await apply(page, { kind: 'cable_net', vertices: [[0, 0, 0], [1, 0, 0], [2, 0, 0]], edges: [[0, 1], [1, 5]], supports: [0, 2], cables: [{ force_density: 1 }] });
  await page.locator('#problem').waitFor();
  const text = await page.textContent('#problem');
  assert.match(text, /Edge 2, 2/);
  assert.doesNotMatch(text, /\/edges/);
});

test('a failure is said in the page\'s words, and the text of the service is there to be opened', async () => {
  const { page } = studio;
  await studio.open('plane-sail');
  const cables = [0, 1, 2, 3].map((from) => ({ along: { from, to: (from + 1) % 4 }, value: 1 }));
  await apply(page, { kind: 'tensile_structure', boundaries: [[[0, 0, 0], [10, 0, 3], [10, 10, 0], [0, 10, 3]]], film: { tension: 1 }, cables, resolution: { triangles: 300 } });
  await page.locator('#problem').waitFor();
  assert.match(await page.textContent('#problem'), /Give the cables larger forces/);
  assert.match(await page.textContent('#problem ul'), /Cable 1, value/);
  const details = page.locator('#problem details');
  assert.equal(await details.evaluate((box) => box.open), false);
  assert.match(await details.textContent(), /counts from 0.*no shape in equilibrium/s);
});

test('the page has no stray notation', async () => {
  const { page } = studio;
  await studio.open('wang-tang-v');
  await page.uncheck('#live');
  for (const { value } of await page.locator('#options [name="objective"] option:not(:disabled)').evaluateAll((options) => options.map(({ value: name }) => ({ value: name })))) {
    if (value === '(object)') continue;
    await page.selectOption('#options [name="objective"]', value);
    assert.doesNotMatch(await page.textContent('#options .choice:has([name="objective"]) .help'), /_|\[|\{/);
  }
  await studio.open('tent');
  await showPanel(page, 'results');
  const statistics = await page.textContent('#numbers');
  assert.doesNotMatch(statistics, /Stability stable/);
  assert.match(statistics, /StabilityStableyes/);
  await page.click('#open-gallery');
  assert.deepEqual(await page.locator('#blank-starts button').allTextContents(), ['Draw a film', 'Draw a strip', 'Draw a lattice', 'Draw a tensile structure']);
});

test('no label of a chart is cut off', async () => {
  const { page } = studio;
  for (const [width, height] of [[1500, 950], [1280, 720], [390, 844]]) {
    await page.setViewportSize({ width, height });
    await studio.open();
    await showPanel(page, 'results');
    await page.click('#numerics summary');
    const outside = await page.locator('#charts svg').evaluateAll((charts) => charts.flatMap((chart) => {
      const box = chart.getBoundingClientRect();
      return [...chart.querySelectorAll('text')].filter((text) => {
        const { left, right, top, bottom } = text.getBoundingClientRect();
        return left < box.left || right > box.right || top < box.top || bottom > box.bottom + 1;
      }).map((text) => text.textContent);
    }));
    assert.ok(await page.locator('#charts svg').count() > 0, 'the first screen has a chart');
    assert.deepEqual(outside, [], `${width} × ${height}`);
  }
});
