// Makes the screenshot of a page that the README shows: node picture.js
import path from 'node:path';
import { launch, port, top } from './browser.js';

const running = await launch();
const context = await running.browser.newContext({ viewport: { width: 960, height: 520 }, colorScheme: 'dark' });
const page = await context.newPage();
page.setDefaultTimeout(300000);
await page.goto(`${await port(path.join(top, 'corpus/templates/terrain.glsl'), 'terrain')}#t=9&paused`);
await page.evaluate(() => globalThis.shaderport.ready);
await page.click('#more');
await page.screenshot({ path: path.join(top, 'tests/browser/page.png'), timeout: 300000 });
await running.kill();
