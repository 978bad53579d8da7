// What a person sees first.

import assert from 'node:assert/strict';
import { covered, request, solved, test, useStudio } from './harness.mjs';

const studio = useStudio();
/** Examples that the page has and the service does not. */
const OWN = ['vault-equal-members'];

test.quick('the page opens with a solved film, without a click', async () => {
  const { page } = studio;
  await page.goto(`${studio.url}/`);
  await solved(page);
  assert.ok(await covered(page) >= 0.15, `the film covers ${await covered(page)} of the stage`);
  assert.match(await page.textContent('#intro'), /Draw a boundary and Plateau finds its shape/);
  assert.equal(await page.isVisible('#intro'), true);
});

test('the gallery shows every example once, by purpose, with a picture', async () => {
  const { page } = studio;
  await studio.open();
  const { examples } = await (await fetch(`${studio.url}/v1/examples`)).json();
  await page.click('#intro-gallery');
  const cards = page.locator('#gallery [data-example]');
  assert.deepEqual((await cards.evaluateAll((all) => all.map((card) => card.dataset.example))).sort(), [...examples.map(({ name }) => name), ...OWN].sort());
  assert.equal(await page.locator('#gallery .thumbnail.missing').count(), 0, 'no example lacks its picture: run scripts/studio/pictures.mjs');
  const cut = await cards.locator('> span:last-child').evaluateAll((titles) => titles.filter((title) => title.scrollHeight > title.clientHeight + 1).map((title) => title.textContent));
  assert.deepEqual(cut, [], 'every title is there as a whole');
  await page.click('#gallery [data-example="vault"]');
  await solved(page);
  assert.equal(await page.isChecked('#kinds input[value="uniform_mesh"]'), true);
});

test('the first lattice of the gallery opens without a warning, beside the roof of the paper', async () => {
  const { page } = studio;
  await studio.open();
  await page.click('#intro-gallery');
  const lattices = page.locator('#gallery section', { hasText: 'Gridshells and floors' }).locator('[data-example]');
  const [first, second] = await lattices.evaluateAll((all) => all.map((card) => card.dataset.example));
  assert.deepEqual([first, second], ['vault-equal-members', 'latticed-roof']);
  await lattices.first().click();
  await solved(page);
  assert.equal(await page.isChecked('#kinds input[value="uniform_mesh"]'), true);
  assert.equal(await page.locator('#warnings .warning').count(), 0);
});

test('draw your own begins with an empty stage and says what to do', async () => {
  const { page } = studio;
  await studio.open();
  await page.click('#intro-draw');
  assert.deepEqual((await request(page)).boundaries, []);
  assert.match(await page.textContent('#drawing-hint'), /Click on the ground/);
});

test.quick('every page has a strict policy', async () => {
  for (const path of ['/', '/studio/embed.html', '/docs/']) {
    const response = await fetch(studio.url + path);
    const policy = response.headers.get('content-security-policy') ?? '';
    assert.match(policy, /default-src '(self|none)'/, path);
    // WebAssembly is compiled, and nothing else is made of text.
    assert.doesNotMatch(policy, /script-src[^;]*'unsafe|default-src[^;]*unsafe/, path);
    assert.equal(response.headers.get('x-content-type-options'), 'nosniff', path);
  }
});

test('the API page works under its policy', async () => {
  const { page } = studio;
  await page.goto(`${studio.url}/docs/`);
  await page.getByText('/v1/minimal-surfaces').first().waitFor();
});
