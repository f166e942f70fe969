// node draw.mjs WIDTH HEIGHT TIME FILE...: prints a JSON list with the times of Chromium's software
// renderer for each shader written by `shaderport --target glsl`: milliseconds from the source text to
// the bytes of the first frame, and for one more frame.
import fs from 'node:fs';
import { launch } from '../tests/browser/browser.js';

const { browser, kill } = await launch();
const page = await browser.newPage();
await page.setContent('<canvas></canvas>');

const [width, height, time] = process.argv.slice(2, 5).map(Number);
const shaders = process.argv.slice(5).map((file) => ({
  fragment: fs.readFileSync(file, 'utf8'),
  vertex: fs.readFileSync(file.replace(/\.frag$/, '.vert'), 'utf8'),
}));

const measured = await page.evaluate(([width, height, time, shaders]) => {
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
    // Best of ten runs, or of as many as fit into a few seconds.
    for (let i = 0; i < 10 && performance.now() - begin < 5000; i += 1) {
      start = performance.now();
      draw();
      frame = Math.min(frame, performance.now() - start);
    }
    const colors = new Set(new Uint32Array(bytes.buffer)).size;
    return { first, frame, colors };
  });
}, [width, height, time, shaders]);

if (measured.some(({ colors }) => colors < 2)) throw new Error('a shader drew a single colour');
console.log(JSON.stringify(measured));
await kill();
