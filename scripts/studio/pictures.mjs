// Draws the gallery's pictures, one of each example, into web/static/thumbnails.webp, and their order into
// web/src/thumbnails.json: CHROMIUM=… PLATEAU_BIN=… node scripts/studio/pictures.mjs, then npm run build in web/. With
// `stage` as argument it draws docs/studio.png instead. With `files SHEET.png` it draws a sheet with a picture of each
// drawing in scripts/studio/files, to be looked at.

import { readFile, writeFile } from 'node:fs/promises';
import { fileURLToPath } from 'node:url';
import { launch, solved, startServer } from './harness.mjs';

const WIDTH = 264, HEIGHT = 176, COLUMNS = 6;
const root = fileURLToPath(new URL('../../', import.meta.url));
const server = process.env.PLATEAU_URL ? { url: process.env.PLATEAU_URL, stop() {} } : await startServer();
const browser = await launch();

async function gallery() {
  const { examples } = await (await fetch(`${server.url}/v1/examples`)).json();
  // An example of the studio's own.
  examples.push({ name: 'vault-equal-members' });
  const page = await browser.newPage({ viewport: { width: 2 * WIDTH, height: 2 * HEIGHT } });
  await page.goto(`${server.url}/studio/embed.html?example=tent&ground=none`);
  await solved(page);
  await page.evaluate(([width, height]) => {
    window.sheet = Object.assign(document.createElement('canvas'), { width, height }).getContext('2d');
  }, [COLUMNS * WIDTH, Math.ceil(examples.length / COLUMNS) * HEIGHT]);
  for (const [i, { name }] of examples.entries()) {
    await page.evaluate((each) => window.studio.openExample(each), name);
    await solved(page);
    await page.evaluate(([x, y, width, height]) => {
      window.studio.fit();
      window.studio.draw();
      window.sheet.imageSmoothingQuality = 'high';
      window.sheet.drawImage(document.querySelector('#view'), x, y, width, height);
    }, [(i % COLUMNS) * WIDTH, Math.floor(i / COLUMNS) * HEIGHT, WIDTH, HEIGHT]);
    console.log(name);
  }
  const data = await page.evaluate(() => window.sheet.canvas.toDataURL('image/webp', 0.86));
  await writeFile(`${root}web/static/thumbnails.webp`, Buffer.from(data.split(',')[1], 'base64'));
  await writeFile(`${root}web/src/thumbnails.json`, `${JSON.stringify({ columns: COLUMNS, names: examples.map(({ name }) => name) }, null, 1)}\n`);
}

async function readme() {
  const page = await browser.newPage({ viewport: { width: 1440, height: 860 } });
  await page.goto(`${server.url}/?example=catenoid`);
  await solved(page);
  await page.screenshot({ path: `${root}docs/studio.png` });
}

async function drawings(sheet) {
  const folder = fileURLToPath(new URL('files/', import.meta.url));
  const names = JSON.parse(await readFile(`${folder}files.json`, 'utf8')).map(({ file }) => file);
  const page = await browser.newPage({ viewport: { width: 1280, height: 720 } });
  await page.goto(`${server.url}/?example=tent`);
  await solved(page);
  await page.evaluate(([width, height]) => {
    window.sheet = Object.assign(document.createElement('canvas'), { width, height }).getContext('2d');
    Object.assign(window.sheet, { font: '12px sans-serif', fillStyle: 'white', imageSmoothingQuality: 'high' });
    window.sheet.fillRect(0, 0, width, height);
    window.sheet.fillStyle = 'black';
  }, [COLUMNS * WIDTH, Math.ceil(names.length / COLUMNS) * (HEIGHT + 36)]);
  for (const [i, name] of names.entries()) {
    await page.evaluate(() => document.querySelector('#card')?.remove());
    await page.setInputFiles('#file', `${folder}${name}`);
    await page.locator('#card:not([hidden])').waitFor();
    await page.waitForFunction(() => document.body.getAttribute('aria-busy') === 'false' && /^(Solved|Not solved)/.test(document.querySelector('#status').textContent) && window.studio.isAtRest());
    await page.evaluate(([x, y, width, height, file]) => {
      window.studio.draw();
      const [view, card] = [document.querySelector('#view'), document.querySelector('#card')];
      const said = `${card.querySelector('.size').textContent}, ${card.querySelector('[data-field="unit"]').value}${card.querySelector('.asks') ? ', asked' : ''}`;
      window.sheet.drawImage(view, x, y, width, height);
      window.sheet.fillText(file, x + 6, y + height + 13);
      window.sheet.fillText(said, x + 6, y + height + 28);
    }, [(i % COLUMNS) * WIDTH, Math.floor(i / COLUMNS) * (HEIGHT + 36), WIDTH, HEIGHT, name]);
    console.log(name);
  }
  const data = await page.evaluate(() => window.sheet.canvas.toDataURL('image/png'));
  await writeFile(sheet, Buffer.from(data.split(',')[1], 'base64'));
}

const [what, sheet] = process.argv.slice(2);
await (what === 'stage' ? readme() : what === 'files' ? drawings(sheet) : gallery());
await browser.close();
await server.stop();
