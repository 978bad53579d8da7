// Every objective that the service offers can be chosen.

import assert from 'node:assert/strict';
import { apply, request, solved, test, useStudio } from './harness.mjs';

const studio = useStudio();
const FIRST = { minimal_surface: 'tent', ruled_surface: 'wang-tang-v', uniform_mesh: 'floor-fewest-nodes' };

test('the control offers each objective of each kind, and sets the request', async () => {
  const { page } = studio;
  const { objectives } = await (await fetch(`${studio.url}/v1/objectives`)).json();
  for (const kind of new Set(objectives.map((each) => each.kind))) {
    const names = objectives.filter((each) => each.kind === kind).map(({ name }) => name);
    // A tensile structure has one objective, equilibrium, so its request has no field to choose it.
    if (names.length === 1) continue;
    await studio.open(FIRST[kind]);
    await page.uncheck('#live');
    for (const name of [...names.slice(1), names[0]]) {
      await page.selectOption('#options [name="objective"]', name);
      assert.equal((await request(page)).objective, name);
      const help = await page.textContent('#options .choice:has([name="objective"]) .help');
      assert.match(help, /^The .*\.$/s, name);
    }
  }
});

test('a weighted sum of objectives is set by its weights, and solved', async () => {
  const { page } = studio;
  await studio.open('wavy-strip');
  await page.selectOption('#options [name="objective"]', { label: 'Weighted sum' });
  await page.fill('#options [name="objective.weights.minimal_twist"]', '0.5');
  await page.keyboard.press('Tab');
  const { objective } = await request(page);
  assert.deepEqual(objective, { weights: { minimal_area: 1, minimal_twist: 0.5 } });
  await solved(page);
  assert.match(await page.textContent('#statistics'), /weighted/);
});

test('nested options are set and taken back', async () => {
  const { page } = studio;
  await studio.open('tent');
  await page.uncheck('#live');
  await page.fill('#options [name="resolution.value"]', '500');
  await page.keyboard.press('Tab');
  assert.deepEqual((await request(page)).resolution, { triangles: 500 });
  await page.click('#options summary');
  await page.selectOption('#options [name="solver"]', 'newton');
  assert.equal((await request(page)).solver, 'newton');
  await page.click('#undo');
  await page.click('#undo');
  assert.notDeepEqual((await request(page)).resolution, { triangles: 500 });
  assert.equal((await request(page)).solver, undefined);
});

test('a lower bound of the area is asked for by a switch, whose options appear with it', async () => {
  const { page } = studio;
  await studio.open('four-corners');
  await page.uncheck('#live');
  await page.click('#options summary');
  assert.equal(await page.isVisible('#options [name="certify.gap"]'), false);
  await page.check('#options [name="certify"]');
  assert.deepEqual((await request(page)).certify, {});
  await page.fill('#options [name="certify.seconds"]', '1');
  await page.keyboard.press('Tab');
  assert.deepEqual((await request(page)).certify, { seconds: 1 });
  await page.check('#live');
  await solved(page);
  assert.match(await page.textContent('#figures'), /above the least area by at most/);
  assert.match(await page.textContent('#statistics'), /No oriented surface of any topology with this boundary has an area below/);
  await page.uncheck('#options [name="certify"]');
  assert.equal((await request(page)).certify, undefined);
});

test('what does not go with an objective is disabled with the reason, and goes when the objective is changed', async () => {
  const { page } = studio;
  await studio.open('wavy-strip');
  await page.uncheck('#live');
  const secondary = page.locator('#options [name="secondary_objective"]');
  const reason = page.locator('#options [data-path="secondary_objective"] > .why');
  assert.equal(await secondary.isDisabled(), true);
  assert.equal(await reason.textContent(), 'Only with the objective maximal convexity.');
  const normal = page.locator('#options [name="objective"] option[value="minimal_normal_variation"]');
  assert.equal(await normal.evaluate((option) => option.disabled), true, 'these rails have no normals');
  assert.match(await normal.textContent(), /needs normals/);

  await page.selectOption('#options [name="objective"]', 'maximal_convexity');
  assert.equal(await secondary.isDisabled(), false);
  assert.equal(await reason.count(), 0);
  await secondary.selectOption('minimal_bending_energy');
  await page.selectOption('#options [name="objective"]', 'minimal_twist');
  assert.equal((await request(page)).secondary_objective, undefined, 'the service refuses it with another objective');
  assert.equal(await secondary.inputValue(), '');
  assert.equal(await secondary.isDisabled(), true);
  await page.click('#solve');
  await solved(page);
  await page.click('#undo');
  assert.deepEqual([(await request(page)).objective, (await request(page)).secondary_objective], ['maximal_convexity', 'minimal_bending_energy'], 'both are one step');

  await page.selectOption('#options [name="objective"]', { label: 'Weighted sum' });
  assert.equal(await page.isDisabled('#options [name="objective.weights.minimal_normal_variation"]'), true);
  assert.equal(await page.isDisabled('#options [name="objective.weights.minimal_twist"]'), false);
});

test('an option that has a value stays enabled where it does not apply, so that it can be removed', async () => {
  const { page } = studio;
  await studio.open('plane-sail');
  await page.uncheck('#live');
  assert.equal(await page.isDisabled('#options [name="pressure"]'), true);
  assert.equal(await page.textContent('#options [data-path="pressure"] > .why'), 'Not with cables along a boundary.');
  await apply(page, { kind: 'tensile_structure', ...await request(page), pressure: 0.5 });
  assert.equal(await page.isDisabled('#options [name="pressure"]'), false);
});

test.quick('each kind begins with an example whose result has no warning', async () => {
  const { page } = studio;
  await studio.open();
  for (const kind of ['ruled_surface', 'uniform_mesh', 'tensile_structure', 'cable_net', 'minimal_surface']) {
    await page.locator(`#kinds label:has([value="${kind}"])`).click();
    await page.waitForFunction((wanted) => window.studio.kind() === wanted, kind);
    await solved(page);
    assert.equal(await page.locator('#warnings .warning').count(), 0, `${kind}: ${await page.textContent('#warnings')}`);
  }
});
