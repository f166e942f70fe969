// node browser.mjs FILE...: prints a JSON list with the milliseconds that Chromium needs to compile
// each shader.
import fs from 'node:fs';
import { launch } from '../tests/browser/browser.js';

const { browser, kill } = await launch();
const page = await browser.newPage();
await page.setContent('<canvas></canvas>');

// Querying the status forces the compilation to finish, so the time covers all of it. One warm-up run
// first.
const times = await page.evaluate((sources) => {
  const gl = document.querySelector('canvas').getContext('webgl2');
  const compile = (source) => {
    const shader = gl.createShader(gl.FRAGMENT_SHADER);
    const start = performance.now();
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    gl.getShaderParameter(shader, gl.COMPILE_STATUS);
    const time = performance.now() - start;
    gl.deleteShader(shader);
    return time;
  };
  compile('#version 300 es\nprecision highp float;out vec4 o;void main(){o=vec4(1.0);}');
  return sources.map(compile);
}, process.argv.slice(2).map((file) => fs.readFileSync(file, 'utf8')));

await kill();
console.log(JSON.stringify(times));
