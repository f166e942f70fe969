// `shaderport --watch --serve`: a page that goes on where it was when its file is saved.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';
import { pixels, put, top, work } from './browser.js';

const shader = (red, extra = '') => `#define SPEED 1.0 // how fast (0.0~4.0)
${extra}void mainImage(out vec4 O, vec2 U) { O = vec4(${red}, fract(iTime * SPEED), iMouse.x / 255.0, 1.0); }
`;

/** Serves an input; gives the address and what ends it. */
async function serve(...args) {
  const program = process.env.SHADERPORT || path.join(top, 'target/release/shaderport');
  const server = spawn(program, [...args, '--watch', '--serve=0'], { cwd: work });
  let said = '';
  const address = await new Promise((resolve, reject) => {
    server.stderr.on('data', (data) => {
      said += data;
      const found = /http:\/\/[^ ;]+/.exec(said);
      if (found) resolve(found[0]);
    });
    server.on('exit', () => reject(new Error(`it ended: ${said}`)));
  });
  return { address, end: () => server.kill(), said: () => said };
}

/** Waits until the first pixel has this red. */
function redBecomes(page, red) {
  // Not an async function: its promise would be taken for true.
  return page.waitForFunction((expected) => {
    const player = globalThis.shaderport?.player;
    if (!player?.programs.some((program) => program)) return false;
    // A canvas that was made larger is empty until it is drawn again.
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
    await page.goto(address);
    await redBecomes(page, 255);
    await page.click('#play');
    await page.evaluate(() => globalThis.shaderport.seek(12.25));
    await page.mouse.click(100, 60);
    const before = await page.evaluate(() => globalThis.shaderport.player.mouse.value());
    fs.writeFileSync(file, shader('0.0'));
    await redBecomes(page, 0);
    const state = () => page.evaluate(() => {
      const { clock, isPlaying, mouse } = globalThis.shaderport.player;
      return [clock.time, isPlaying, mouse.value()];
    });
    assert.deepEqual(await state(), [12.25, false, before]);
    assert.equal((await pixels(page))[1], 64, 'the picture is that of the time');
    // A mistake is told on the page, and the next save mends it.
    fs.writeFileSync(file, shader('1.0', 'oops;\n'));
    await page.waitForSelector('#errors:not([hidden])');
    fs.writeFileSync(file, shader('1.0'));
    await redBecomes(page, 255);
    assert.deepEqual(await state(), [12.25, false, before]);
    assert.deepEqual(asked.filter((url) => !url.startsWith(address)), []);
  } finally {
    end();
  }
}

async function lateFile(context) {
  const file = path.join(work, 'late.glsl');
  fs.rmSync(file, { force: true });
  const { address, end } = await serve(file);
  try {
    const page = await context.newPage();
    await page.goto(address);
    await page.waitForFunction(() => document.body.textContent.includes('late.glsl'));
    fs.writeFileSync(file, shader('1.0'));
    await redBecomes(page, 255);
  } finally {
    end();
  }
}

async function includedFile(context) {
  const part = put('served_part.glsl', '#define RED 1.0\n');
  const file = put('served_whole.glsl', shader('RED', '#include "served_part.glsl"\n'));
  const { address, end } = await serve(file);
  try {
    const page = await context.newPage();
    await page.goto(address);
    await redBecomes(page, 255);
    fs.writeFileSync(part, '#define RED 0.0\n');
    await redBecomes(page, 0);
  } finally {
    end();
  }
}

export const serveTests = [
  { name: 'a served page goes on where it was when its file is saved', run: savedFile },
  { name: 'a served page waits for its file', run: lateFile },
  { name: 'a served page follows what its file includes', run: includedFile },
];
