// Draws the gallery's pictures, one of each example, into web/static/thumbnails.webp, and their order into
// web/src/thumbnails.json: CHROMIUM=… PLATEAU_BIN=… node scripts/studio/pictures.mjs, then npm run build in web/. With
// `stage` as argument it draws docs/studio.png instead.

import { writeFile } from 'node:fs/promises';
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

await (process.argv[2] === 'stage' ? readme() : gallery());
await browser.close();
await server.stop();
