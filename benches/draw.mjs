// node draw.mjs WIDTH HEIGHT TIME FILE...: prints, as a JSON list, what Chromium's software renderer
// takes for each shader that `shaderport --target glsl` wrote: milliseconds from its text to the bytes
// of the first frame, and of one frame more. BROWSER_MODULES names the folder whose node_modules holds
// playwright-core, CHROMIUM the program.
import { createRequire } from 'node:module';
import fs from 'node:fs';
import path from 'node:path';

const require = createRequire(path.resolve(process.env.BROWSER_MODULES, 'package.json'));
const { chromium } = require('playwright-core');

const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM || '/usr/bin/chromium',
  args: ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--disable-gpu-watchdog'],
});
const page = await browser.newPage();
await page.setContent('<canvas></canvas>');

const [width, height, time] = process.argv.slice(2, 5).map(Number);
const shaders = process.argv.slice(5).map((file) => ({
  fragment: fs.readFileSync(file, 'utf8'),
  vertex: fs.readFileSync(file.replace(/\.frag$/, '.vert'), 'utf8'),
}));

const told = await page.evaluate(([width, height, time, shaders]) => {
  const canvas = document.querySelector('canvas');
  Object.assign(canvas, { width, height });
  const gl = canvas.getContext('webgl2');
  gl.viewport(0, 0, width, height);
  gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
  gl.bufferData(gl.ARRAY_BUFFER, new Float32Array([-1, -1, 3, -1, -1, 3]), gl.STATIC_DRAW);
  const bytes = new Uint8Array(width * height * 4);
  const ready = ({ fragment, vertex }) => {
    const program = gl.createProgram();
    for (const [type, source] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
      const shader = gl.createShader(type);
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    gl.useProgram(program);
    const at = gl.getAttribLocation(program, 'pos');
    gl.enableVertexAttribArray(at);
    gl.vertexAttribPointer(at, 2, gl.FLOAT, false, 0, 0);
    gl.uniform3f(gl.getUniformLocation(program, 'iResolution'), width, height, 1);
    gl.uniform1f(gl.getUniformLocation(program, 'iTime'), time);
  };
  const draw = () => {
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
  };
  return shaders.map((shader) => {
    let start = performance.now();
    ready(shader);
    draw();
    const first = performance.now() - start;
    let frame = Infinity;
    const begin = performance.now();
    // The best of ten, or of as many as fit into some seconds.
    for (let i = 0; i < 10 && performance.now() - begin < 5000; i += 1) {
      start = performance.now();
      draw();
      frame = Math.min(frame, performance.now() - start);
    }
    const colors = new Set(new Uint32Array(bytes.buffer)).size;
    return { first, frame, colors };
  });
}, [width, height, time, shaders]);

if (told.some(({ colors }) => colors < 2)) throw new Error('a shader has drawn one colour only');
console.log(JSON.stringify(told));
await browser.close();
