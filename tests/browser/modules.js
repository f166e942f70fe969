// The modules in other pages.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { pathToFileURL } from 'node:url';
import { Linter } from 'eslint';
import { bytesOf, colors, differences, folder, listen, put, shaderport, top } from './browser.js';
import { CASES } from './cases.js';
import { reference } from './reference.js';

/** WebGPU requires a secure context. */
const HOST = 'http://page.localhost/';
const packages = path.join(top, 'tests/browser/node_modules');

/** The files for bare imports; React's own files are CommonJS and need a wrapper. */
const IMPORTS = {
  three: '/packages/three/build/three.module.js',
  'three/webgpu': '/packages/three/build/three.webgpu.js',
  'three/tsl': '/packages/three/build/three.tsl.js',
  react: '/react.js',
  'react-dom/client': '/react-dom.js',
};

/** React as ES modules: its CommonJS files are wrapped one by one, with `require` for the others. */
function commonjs(entry) {
  const parts = {
    react: 'react/cjs/react.production.js',
    'react-dom': 'react-dom/cjs/react-dom.production.js',
    'react-dom/client': 'react-dom/cjs/react-dom-client.production.js',
    scheduler: 'scheduler/cjs/scheduler.production.js',
  };
  const bodies = Object.entries(parts).map(([name, file]) => {
    const code = fs.readFileSync(path.join(packages, file), 'utf8');
    return `${JSON.stringify(name)}: (module, exports, require) => {\n${code}\n}`;
  });
  const names = entry === 'react' ? ['createElement', 'useEffect', 'useRef'] : ['createRoot'];
  return `globalThis.parts ??= {};
const bodies = { ${bodies.join(',\n')} };
const require = (name) => {
  if (!globalThis.parts[name]) {
    const module = { exports: {} };
    globalThis.parts[name] = module;
    bodies[name](module, module.exports, require);
  }
  return globalThis.parts[name].exports;
};
const all = require(${JSON.stringify(entry)});
export const { ${names.join(', ')} } = all;
`;
}

/** A page that can import the files in the folder of the tests. */
export async function host(context, body) {
  const page = await context.newPage();
  listen(page);
  // Routes are answered outside the test.
  const written = folder();
  await page.route(`${HOST}**`, (route) => {
    const { pathname } = new URL(route.request().url());
    const js = (text) => route.fulfill({ contentType: 'text/javascript', body: text });
    if (pathname === '/') {
      return route.fulfill({
        contentType: 'text/html',
        body: `<!doctype html><script type="importmap">${JSON.stringify({ imports: IMPORTS })}</script>
<style>canvas { width: 64px; height: 36px }</style><div id="root"><canvas id="canvas"></canvas></div>
<script type="module">${body}</script>`,
      });
    }
    if (pathname === '/react.js') return js(commonjs('react'));
    if (pathname === '/react-dom.js') return js(commonjs('react-dom/client'));
    if (pathname === '/favicon.ico') return route.fulfill({ status: 204 });
    const inside = pathname.startsWith('/packages/') ? path.join(packages, pathname.slice(10)) : path.join(written, pathname);
    return js(fs.readFileSync(inside, 'utf8'));
  });
  // A wait fails with the first uncaught error of the page.
  const failed = new Promise((_, reject) => { page.on('pageerror', reject); });
  failed.catch(() => {});
  await page.goto(HOST);
  /** Waits until the page reports it. */
  const until = (ask) => Promise.race([page.waitForFunction(ask), failed]);
  return { page, until };
}

const named = (word) => CASES.find((c) => c.name.includes(word));

async function mount(context) {
  const test = named('order of the export');
  await shaderport(put('module.json', JSON.stringify(test.shader)), '-o', 'module.js', '--force');
  const { page, until } = await host(context, `
    import { mount } from './module.js';
    const canvas = document.querySelector('canvas');
    globalThis.shader = mount(canvas, { size: [64, 36], paused: true });
    globalThis.second = mount(document.createElement('canvas'), { size: [8, 8] });`);
  await until(() => globalThis.shader);
  const drawn = bytesOf(await page.evaluate(async () => {
    await globalThis.shader.renderFrame(5);
    const gl = document.querySelector('canvas').getContext('webgl2');
    const bytes = new Uint8Array(64 * 36 * 4);
    gl.readPixels(0, 0, 64, 36, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
    return bytes.toBase64();
  }));
  const expected = await reference(page, { shader: test.shader, width: 64, height: 36, last: 5, date: [0, 0, 0, 0] });
  assert.equal(differences(drawn, expected), 0, 'same pixels as the reference player');
  const after = await page.evaluate(async () => {
    const { second } = globalThis;
    await second.ready;
    while (second.time === 0) await new Promise((resolve) => { requestAnimationFrame(resolve); });
    second.dispose();
    return [second.playing, globalThis.shader.errors];
  });
  assert.deepEqual(after, [false, []]);
}

/** Pages and modules have only the parts that a project uses; these use nothing of the others. */
async function complete(context) {
  const input = (channel, type, id) => ({ id, type, channel, sampler: { filter: 'nearest', wrap: 'repeat', vflip: 'true' } });
  const image = (code, ...inputs) => ({ type: 'image', code, inputs, outputs: [{ id: '37', channel: 0 }] });
  const plain = 'void mainImage(out vec4 O, vec2 U) { O = vec4(1); }';
  const read = 'void mainImage(out vec4 O, vec2 U) { O = texture(iChannel0, U); }';
  const projects = {
    plain: [image(plain)],
    tuned: [image(`#define A 1.0 // Tunable: a (0.0~2.0)\n${plain.replace('1)', 'A)')}`)],
    keyboard: [image(read, input(0, 'keyboard', '4dXGRr'))],
    picture: [image(read, input(0, 'texture', 'Xsf3zn'))],
    music: [image(read, input(0, 'music', '4sXGzn'))],
    film: [image(read, input(0, 'video', '4sf3zn'))],
    buffer: [image(read, input(0, 'buffer', '4dXGR8')), { type: 'buffer', code: plain, inputs: [], outputs: [{ id: '4dXGR8', channel: 0 }] }],
    sound: [image(plain), { type: 'sound', code: 'vec2 mainSound(int s, float t) { return vec2(0); }', inputs: [], outputs: [] }],
  };
  const texts = [];
  for (const [name, renderpass] of Object.entries(projects)) {
    const file = put(`${name}.json`, JSON.stringify({ info: {}, renderpass }));
    for (const [out, ...more] of [[`${name}.js`], [`${name}.html`], [`${name}.html`, '--embed']]) {
      const { code, stderr } = await shaderport(file, '-o', out, '--force', ...more);
      assert.equal(code, 0, stderr);
      texts.push({ name: `${name} ${out} ${more}`, text: fs.readFileSync(path.join(folder(), out), 'utf8') });
    }
  }
  const page = await context.newPage();
  await page.goto(pathToFileURL(put('empty.html', '<!doctype html>')).href);
  for (const { name, text } of texts) {
    const code = text.startsWith('<') ? text.slice(text.lastIndexOf('<script>') + 8, text.lastIndexOf('</script>')) : text;
    const found = new Linter().verify(code, [{ languageOptions: { sourceType: 'module', ecmaVersion: 2023 }, rules: { 'no-undef': 'error' } }]);
    assert.deepEqual(found.filter((f) => f.fatal), [], name);
    const names = [...new Set(found.map((f) => /'(.*?)'/.exec(f.message)[1]))];
    assert.deepEqual(await page.evaluate((all) => all.filter((n) => !(n in globalThis)), names), [], name);
  }
}

async function three(context) {
  const test = named('order of the export');
  await shaderport(put('three.json', JSON.stringify(test.shader)), '-t', 'three', '-o', 'three.js', '--force');
  const { page, until } = await host(context, `
    import { createShader } from './three.js';
    import { Camera, Mesh, PlaneGeometry, Scene, WebGLRenderer } from 'three';
    const canvas = document.querySelector('canvas');
    const renderer = new WebGLRenderer({ canvas, antialias: false, preserveDrawingBuffer: true });
    renderer.setPixelRatio(1);
    renderer.setSize(64, 36, false);
    const shader = createShader();
    const scene = new Scene();
    const mesh = new Mesh(new PlaneGeometry(2, 2), shader.material);
    mesh.frustumCulled = false;
    scene.add(mesh);
    const camera = new Camera();
    for (let i = 0; i <= 5; i++) {
      shader.update(renderer, { time: i / 60 });
      renderer.render(scene, camera);
    }
    const bytes = new Uint8Array(64 * 36 * 4);
    const gl = renderer.getContext();
    gl.readPixels(0, 0, 64, 36, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
    globalThis.drawn = bytes.toBase64();
    shader.dispose();`);
  await until(() => globalThis.drawn);
  const drawn = bytesOf(await page.evaluate(() => globalThis.drawn));
  const expected = await reference(page, { shader: test.shader, width: 64, height: 36, last: 5, date: [0, 0, 0, 0] });
  assert.equal(differences(drawn, expected), 0, 'same pixels as the reference player');
}

/** Media stand-ins are the same in three.js as on a page: a texture, a volume and a cube map. */
async function threeStandIns(context) {
  const input = (channel, type, id) => ({ id, type, channel, sampler: { filter: 'nearest', wrap: 'repeat', vflip: 'true' } });
  const code = `void mainImage(out vec4 O, vec2 U) {
  O = texelFetch(iChannel0, ivec2(U), 0);
  if (U.x > 20.0) O = vec4(texelFetch(iChannel1, ivec3(U, 3), 0).r);
  if (U.x > 40.0) O = texture(iChannel2, vec3(U / iResolution.xy - 0.5, 0.3));
  O.b = iChannelResolution[0].x / 256.0 * O.b;
}`;
  const inputs = [input(0, 'texture', 'Xsf3zn'), input(1, 'volume', '4sfGRr'), input(2, 'cubemap', 'XsX3zn')];
  const toy = { info: {}, renderpass: [{ type: 'image', code, inputs, outputs: [] }] };
  const file = put('three_media.json', JSON.stringify(toy));
  await shaderport(file, '-t', 'three', '-o', 'three_media.js', '--force');
  await shaderport(file, '-o', 'media_module.js', '--force');
  const { page, until } = await host(context, `
    import { createShader } from './three_media.js';
    import { mount } from './media_module.js';
    import { Camera, Mesh, PlaneGeometry, Scene, WebGLRenderer } from 'three';
    const canvas = document.querySelector('canvas');
    const renderer = new WebGLRenderer({ canvas, antialias: false, preserveDrawingBuffer: true });
    renderer.setPixelRatio(1);
    renderer.setSize(64, 36, false);
    const shader = createShader();
    const scene = new Scene();
    const mesh = new Mesh(new PlaneGeometry(2, 2), shader.material);
    mesh.frustumCulled = false;
    scene.add(mesh);
    shader.update(renderer, { time: 0 });
    renderer.render(scene, new Camera());
    const read = (gl) => {
      const bytes = new Uint8Array(64 * 36 * 4);
      gl.readPixels(0, 0, 64, 36, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
      return bytes.map((v, i) => (i % 4 === 3 ? 255 : v)).toBase64();
    };
    const drawn = read(renderer.getContext());
    const other = document.createElement('canvas');
    await mount(other, { size: [64, 36], paused: true }).renderFrame(0);
    globalThis.both = [drawn, read(other.getContext('webgl2'))];`);
  await until(() => globalThis.both);
  const [drawn, expected] = (await page.evaluate(() => globalThis.both)).map(bytesOf);
  assert.equal(differences(drawn, expected), 0);
}

/** The output of both modules for a shader file: `frames` frames, each after a script has run. */
async function drawBoth(context, file, frames, change = '') {
  const name = 'both';
  await shaderport(file, '-t', 'three', '-o', `${name}_three.js`, '--force');
  await shaderport(file, '-o', `${name}_module.js`, '--force');
  const { page, until } = await host(context, `
    import { createShader } from './${name}_three.js';
    import { mount } from './${name}_module.js';
    import { Camera, Color, Scene, SRGBColorSpace, WebGLRenderer } from 'three';
    const canvas = document.querySelector('canvas');
    const other = document.createElement('canvas');
    const player = mount(other, { size: [64, 36], paused: true });
    await player.ready;
    const hasVertices = createShader().object.geometry.hasAttribute('vertexId');
    const renderer = new WebGLRenderer({ canvas, antialias: hasVertices, preserveDrawingBuffer: true });
    renderer.setPixelRatio(1);
    renderer.setSize(64, 36, false);
    const shader = createShader();
    const scene = new Scene();
    scene.add(shader.object);
    // A page draws vertex shaders on the background that the shader requests.
    const { x, y, z } = shader.uniforms.background?.value ?? { x: 0, y: 0, z: 0 };
    renderer.setClearColor(new Color().setRGB(x, y, z, SRGBColorSpace), 1);
    ${change}
    for (let i = 0; i < ${frames}; i++) {
      shader.update(renderer, { time: i / 60 });
      renderer.render(scene, new Camera());
    }
    const read = (gl) => {
      const bytes = new Uint8Array(64 * 36 * 4);
      gl.readPixels(0, 0, 64, 36, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
      return bytes.map((v, i) => (i % 4 === 3 ? 255 : v)).toBase64();
    };
    const drawn = read(renderer.getContext());
    await player.renderFrame(${frames} - 1);
    globalThis.both = [drawn, read(other.getContext('webgl2')), player.errors];`);
  await until(() => globalThis.both);
  const [drawn, module, errors] = await page.evaluate(() => globalThis.both);
  await page.close();
  return { three: bytesOf(drawn), module: bytesOf(module), errors };
}

const DIALECTS = path.join(top, 'tests/fixtures/dialects');

/** Shaders with their own uniforms, of each kind that three.js handles differently. */
const OWN = [
  'three/terrain.glsl', 'glsl-sandbox/feedback.glsl', 'webgl/samplers.frag', 'isf/wipe.fs', 'twigl/mrt.glsl', 'vertexshaderart/strip.vert',
];
/** More of the same kinds. */
const SIMILAR = [
  'three/gradient.glsl', 'glsl-sandbox/surface.glsl', 'book-of-shaders/buffers.frag', 'isf/trails.fs', 'isf/edges.fs', 'vertexshaderart/rings.vert',
];

async function threeOwn(context, file) {
  const { three: drawn, module, errors } = await drawBoth(context, path.join(DIALECTS, file), 4);
  assert.deepEqual(errors, []);
  assert.ok(file.includes('samplers') || colors(drawn) > 1, 'one colour');
  const worst = drawn.reduce((most, value, i) => Math.max(most, Math.abs(value - module[i])), 0);
  assert.ok(drawn.length === module.length && worst <= 1, `${worst}`);
}

/** Uniforms of a shader are properties in both modules, and setting them changes the image. */
async function ownProperties(context) {
  const code = `precision highp float;
uniform float gain; // (0.0~2.0)
uniform bool on;
uniform vec3 tint;
uniform vec2 shift;
void main() { gl_FragColor = vec4(on ? tint * gain : vec3(shift, 0.5), 1.0); }`;
  const { three: drawn, module } = await drawBoth(context, put('own.frag', code), 1, `
    const given = player.uniforms;
    if (given.gain !== 1 || given.on !== false || given.tint.length !== 3) throw new Error('first values');
    for (const wrong of [{ gain: NaN }, { tint: [1, 2] }, { other: 1 }]) {
      let name = 'nothing';
      try { Object.assign(given, wrong); } catch (error) { ({ name } = error); }
      if (name !== 'TypeError') throw new Error(JSON.stringify(wrong));
    }
    Object.assign(given, { gain: 0.5, on: true, tint: [1, 0.5, 0] });
    const own = shader.uniforms;
    if (own.gain !== shader.material.uniforms.gain) throw new Error('not the same');
    own.gain.value = 0.5;
    own.on.value = true;
    own.tint.value.setRGB(1, 0.5, 0);
    for (const all of [shader.controls, player.controls]) {
      if (all[0].max[0] !== 2 || all.length !== 4) throw new Error('no range');
    }`);
  assert.deepEqual(module.slice(0, 4), [128, 64, 0, 255]);
  assert.equal(differences(drawn, module), 0);
}

async function react(context) {
  const test = named('time, resolution');
  await shaderport(put('react.json', JSON.stringify(test.shader)), '-t', 'react', '-o', 'Shader.js', '--force');
  const { page, until } = await host(context, `
    import { createElement } from 'react';
    import { createRoot } from 'react-dom/client';
    import { Shader } from './Shader.js';
    const root = createRoot(document.querySelector('#root'));
    const show = (props) => root.render(createElement(Shader, { options: { size: [64, 36] }, onMount: (m) => { globalThis.mounted = m; }, ...props }));
    globalThis.show = show;
    globalThis.unmount = () => root.unmount();
    show({ paused: false });`);
  await until(() => globalThis.mounted?.time > 0.05);
  assert.ok(await page.evaluate(() => globalThis.mounted.playing));
  await page.evaluate(() => globalThis.show({ paused: true }));
  await until(() => !globalThis.mounted.playing);
  await page.evaluate(() => globalThis.unmount());
  await until(() => document.querySelectorAll('canvas').length === 0);
}

async function misuse(context) {
  const code = '#define N 2.0 // Tunable: n (1.0~3.0)\nvoid mainImage(out vec4 O, vec2 U) { O = vec4(N / 4.0); }';
  await shaderport(put('misuse.glsl', code), '-o', 'misuse.js', '--force');
  const { page, until } = await host(context, `
    import { mount } from './misuse.js';
    globalThis.shader = mount(document.querySelector('canvas'), { size: [8, 8], paused: true });`);
  await until(() => globalThis.shader);
  const seen = await page.evaluate(async () => {
    const { shader } = globalThis;
    await shader.ready;
    const failure = async (run) => {
      try {
        return String(await run());
      } catch (error) {
        return error.name;
      }
    };
    const red = () => {
      const gl = document.querySelector('canvas').getContext('webgl2');
      const bytes = new Uint8Array(4);
      gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
      return bytes[0];
    };
    const said = [await failure(() => shader.seek(NaN)), await failure(() => shader.setTunable('M', 1)), await failure(() => shader.setTunable('N', NaN))];
    shader.seek(1e308);
    await shader.setTunable('N', 1e6);
    const before = [shader.time, red()];
    shader.dispose();
    shader.play();
    shader.restart();
    shader.setSound(true);
    await shader.setInput(0, 0, 'data:image/png,');
    await shader.setTunable('N', 1);
    return [said, before, shader.playing];
  });
  assert.deepEqual(seen, [['TypeError', 'RangeError', 'TypeError'], [3e7, 191], false]);
}

export const moduleTests = [
  { name: 'module: all used parts are included', run: complete },
  { name: 'module: mount draws the same pixels, twice on one page', run: mount },
  { name: 'module: misuse reports an error or does nothing', run: misuse },
  { name: 'module: three.js draws the same pixels', run: three },
  { name: 'module: three.js draws the same stand-ins', run: threeStandIns },
  ...[...OWN, ...SIMILAR].map((file) => ({
    name: `module: three.js draws ${file}`,
    only: OWN.includes(file) ? undefined : 'a sweep',
    run: (context) => threeOwn(context, file),
  })),
  { name: 'module: user-defined uniforms are properties', run: ownProperties },
  { name: 'module: a React component plays, pauses and unmounts', run: react },
];
