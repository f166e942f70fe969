// `shaderport --watch --serve`: a page continues where it was when its file is saved.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';
import { folder, frames, pixels, program, put } from './browser.js';

const shader = (red, extra = '') => `#define SPEED 1.0 // how fast (0.0~4.0)
${extra}void mainImage(out vec4 O, vec2 U) { O = vec4(${red}, fract(iTime * SPEED), iMouse.x / 255.0, 1.0); }
`;

/** Serves an input; resolves to the address and a function that stops the server. */
async function serve(...args) {
  const port = args.some((a) => a.startsWith('--serve')) ? [] : ['--serve=0'];
  const server = spawn(program('shaderport'), [...args, '--watch', ...port], { cwd: folder() });
  const ended = new Promise((resolve) => { server.once('exit', resolve); });
  let said = '';
  const address = await new Promise((resolve, reject) => {
    server.stderr.on('data', (data) => {
      said += data;
      const found = /http:\/\/[^ ;]+/.exec(said);
      if (found) resolve(found[0]);
    });
    server.on('exit', () => reject(new Error(`the server exited: ${said}`)));
  });
  const end = () => {
    server.kill();
    return ended;
  };
  return { address, end, said: () => said };
}

/** Opens a served page; it is small, so that playing it is cheap. */
async function visit(context, address, hash = '#size=32x18&paused') {
  const page = await context.newPage();
  await page.goto(address + hash);
  return page;
}

/** Waits until the first pixel has this red value. */
function redBecomes(page, red) {
  // Not an async function: its promise would count as true.
  return page.waitForFunction((expected) => {
    const player = globalThis.shaderport?.player;
    if (!player?.programs.some((program) => program)) return false;
    // A resized canvas is empty until it is drawn again.
    player.paint(player.clock.frozen());
    const { gl } = player;
    const pixel = new Uint8Array(4);
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
    return pixel[0] === expected;
  }, red);
}

async function savedFile(context) {
  const file = put('served.glsl', shader('1.0'));
  const { address, end } = await serve(file);
  try {
    const page = await context.newPage();
    const asked = [];
    page.on('request', (r) => asked.push(r.url()));
    await page.goto(`${address}#size=32x18`);
    await redBecomes(page, 255);
    await page.click('#play');
    await page.evaluate(() => globalThis.shaderport.seek(12.25));
    await page.mouse.click(10, 8);
    const before = await page.evaluate(() => globalThis.shaderport.player.mouse.value());
    fs.writeFileSync(file, shader('0.0'));
    await redBecomes(page, 0);
    const state = () => page.evaluate(() => {
      const { clock, isPlaying, mouse } = globalThis.shaderport.player;
      return [clock.time, isPlaying, mouse.value()];
    });
    assert.deepEqual(await state(), [12.25, false, before]);
    assert.equal((await pixels(page))[1], 64, 'the image matches the time');
    // An error is shown on the page, and the next save fixes it.
    fs.writeFileSync(file, shader('1.0', 'oops;\n'));
    await page.waitForSelector('#errors:not([hidden])');
    fs.writeFileSync(file, shader('1.0'));
    await redBecomes(page, 255);
    assert.deepEqual(await state(), [12.25, false, before]);
    assert.deepEqual(asked.filter((url) => !url.startsWith(address)), []);
  } finally {
    await end();
  }
}

async function lateFile(context) {
  const file = path.join(folder(), 'late.glsl');
  fs.rmSync(file, { force: true });
  const { address, end } = await serve(file);
  try {
    const page = await visit(context, address);
    await page.waitForFunction(() => document.body.textContent.includes('late.glsl'));
    fs.writeFileSync(file, shader('1.0'));
    await redBecomes(page, 255);
  } finally {
    await end();
  }
}

async function includedFile(context) {
  const part = put('served_part.glsl', '#define RED 1.0\n');
  const file = put('served_whole.glsl', shader('RED', '#include "served_part.glsl"\n'));
  const { address, end } = await serve(file);
  try {
    const page = await visit(context, address);
    await redBecomes(page, 255);
    fs.writeFileSync(part, '#define RED 0.0\n');
    await redBecomes(page, 0);
  } finally {
    await end();
  }
}

async function waysOfSaving(context) {
  const file = put('saved.glsl', shader('1.0'));
  const { address, end } = await serve(file);
  const other = await context.browser().newContext();
  other.setDefaultTimeout(0);
  try {
    const pages = [await visit(context, address), await visit(other, address)];
    const both = (red) => Promise.all(pages.map((page) => redBecomes(page, red)));
    await both(255);
    // Like an editor that renames the old file.
    fs.renameSync(file, `${file}~`);
    fs.writeFileSync(file, shader('0.0'));
    fs.rmSync(`${file}~`);
    await both(0);
    // Like an editor that writes a new file and renames it to the old name.
    fs.writeFileSync(`${file}.new`, shader('1.0'));
    fs.renameSync(`${file}.new`, file);
    await both(255);
    // Like an editor that truncates the file and writes slowly: a page may or may not show that.
    fs.writeFileSync(file, '');
    await Promise.all(pages.map((page) => frames(page)));
    fs.writeFileSync(file, shader('0.0'));
    await both(0);
    // A deleted file is reported on the page, which stays; the message disappears when the file is
    // back.
    fs.rmSync(file);
    await Promise.all(pages.map((page) => page.waitForSelector('.notice:has-text("saved.glsl")')));
    await both(0);
    fs.writeFileSync(file, shader('0.0'));
    await Promise.all(pages.map((page) => page.waitForSelector('.notice', { state: 'detached' })));
    fs.writeFileSync(file, shader('1.0'));
    await both(255);
  } finally {
    await other.close();
    await end();
  }
}

async function growingFolder(context) {
  const code = (red) => `void mainImage(out vec4 O, vec2 U) { O = vec4(${red}, 0.0, 0.0, 1.0); }\n`;
  put('grows/image.glsl', code('texture(iChannel0, U / iResolution.xy).r'));
  const { address, end } = await serve(path.join(folder(), 'grows'), '--no-stand-ins');
  try {
    const page = await visit(context, address);
    await redBecomes(page, 0);
    put('grows/buffer_a.glsl', code('1.0'));
    put('grows/channels.toml', '0 = "buffer_a"\n');
    await redBecomes(page, 255);
    put('grows/channels.toml', '0 = "buffer_q"\n');
    await page.waitForSelector('.notice:has-text("channels.toml")');
    put('grows/channels.toml', '# nothing\n');
    await redBecomes(page, 0);
  } finally {
    await end();
  }
}

/** Another process may take the port between two servers: retries with another port until it works. */
async function serverComesBack(context) {
  for (let number = 0; ; number++) {
    if (await comesBack(context, put(`again${number}.glsl`, shader('1.0')))) return;
  }
}

/** Whether the second server got the port of the first. */
async function comesBack(context, file) {
  const first = await serve(file);
  const { port } = new URL(first.address);
  const page = await visit(context, first.address);
  await redBecomes(page, 255);
  await page.evaluate(() => globalThis.shaderport.player.pause());
  await page.click('#more');
  await page.fill('input[aria-label="SPEED, number"]', '2.5');
  await page.press('input[aria-label="SPEED, number"]', 'Enter');
  await page.evaluate(() => globalThis.shaderport.seek(7.5));
  await first.end();
  fs.writeFileSync(file, shader('0.0'));
  const second = await serve(file, `--serve=${port}`);
  try {
    if (second.address !== first.address) return false;
    await redBecomes(page, 0);
    await page.waitForFunction(() => globalThis.shaderport.player.clock.time === 7.5);
    assert.equal(await page.inputValue('input[aria-label="SPEED, number"]'), '2.5');
    assert.ok(await page.isVisible('#tune'), 'the panel is unchanged');
    // No other process may have the port meanwhile; requesting it gives another one.
    const third = await serve(file, `--serve=${port}`);
    await third.end();
    assert.notEqual(third.address, first.address);
    assert.match(third.said(), new RegExp(`cannot use port ${port}`));
    return true;
  } finally {
    await second.end();
  }
}

async function hiddenTabs(context) {
  const file = put('tabs.glsl', shader('1.0'));
  const { address, end } = await serve(file);
  try {
    // More pages than a browser has connections for one host.
    const pages = [];
    for (let i = 0; i < 7; i++) {
      const page = await visit(context, address);
      await redBecomes(page, 255);
      await page.evaluate(() => {
        Object.defineProperty(document, 'hidden', { configurable: true, get: () => true });
        document.dispatchEvent(new Event('visibilitychange'));
      });
      pages.push(page);
    }
    fs.writeFileSync(file, shader('0.0'));
    const [page] = pages;
    await page.evaluate(() => {
      Object.defineProperty(document, 'hidden', { configurable: true, get: () => false });
      document.dispatchEvent(new Event('visibilitychange'));
    });
    await redBecomes(page, 0);
  } finally {
    await end();
  }
}

export const serveTests = [
  { name: 'a served page follows in-place and atomic saves', run: waysOfSaving },
  { name: 'a served page follows a folder that grows', run: growingFolder },
  { name: 'a served page reconnects to a restarted server', run: serverComesBack },
  { name: 'a hidden served page closes its connection', run: hiddenTabs },
  { name: 'a served page continues when its file is saved', run: savedFile },
  { name: 'a served page waits for its file', run: lateFile },
  { name: 'a served page follows included files', run: includedFile },
];
