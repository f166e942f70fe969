// The module for three.js' WebGPURenderer draws what the module for WebGL draws.
import assert from 'node:assert/strict';
import path from 'node:path';
import { bytesOf, colors, put, run, shaderport, top } from './browser.js';
import { CASES } from './cases.js';
import { host } from './modules.js';
import { CONVERTER, unequal } from './webgpu.js';

/** The output of both modules for a shader file: `frames` frames, each after a script has run. */
async function drawBoth(context, file, frames, change = '') {
  const made = await run(CONVERTER, file, '-t', 'three-webgpu', '-o', 'gpu_three.js', '--force');
  assert.equal(made.code, 0, made.stderr);
  await shaderport(file, '-o', 'gpu_module.js', '--force');
  const { page, until } = await host(context, `
    import { createShader } from './gpu_three.js';
    import { mount } from './gpu_module.js';
    import { Mesh, OrthographicCamera, PlaneGeometry, RenderTarget, Scene, UnsignedByteType, WebGPURenderer } from 'three/webgpu';
    const canvas = document.querySelector('canvas');
    const renderer = new WebGPURenderer({ canvas, antialias: false });
    await renderer.init();
    renderer.setPixelRatio(1);
    renderer.setSize(64, 36, false);
    const other = document.createElement('canvas');
    const plain = mount(other, { size: [64, 36], paused: true, hidden: true });
    await plain.ready;
    const shader = createShader();
    const scene = new Scene();
    scene.add(shader.object);
    ${change}
    // What the canvas would show: SwiftShader cannot present WebGPU.
    const screen = new RenderTarget(64, 36, { type: UnsignedByteType });
    renderer.setOutputRenderTarget(screen);
    const opaque = (bytes) => new Uint8Array(bytes).map((v, i) => (i % 4 === 3 ? 255 : v)).toBase64();
    const read = async () => opaque(await renderer.readRenderTargetPixelsAsync(screen, 0, 0, 64, 36));
    for (let i = 0; i < ${frames}; i++) {
      shader.update(renderer, { time: i / 60 });
      renderer.render(scene, new OrthographicCamera(-1, 1, 1, -1, 0, 1));
    }
    const drawn = await read();
    // The material draws the same on a mesh of the user.
    const mesh = new Mesh(new PlaneGeometry(2, 2), shader.material);
    mesh.frustumCulled = false;
    const own = new Scene();
    own.add(mesh);
    renderer.render(own, new OrthographicCamera(-1, 1, 1, -1, 0, 1));
    const onMesh = await read();
    await plain.renderFrame(${frames} - 1);
    const gl = other.getContext('webgl2');
    const bytes = new Uint8Array(64 * 36 * 4);
    for (let y = 0; y < 36; y++) gl.readPixels(0, 35 - y, 64, 1, gl.RGBA, gl.UNSIGNED_BYTE, bytes, y * 64 * 4);
    const expected = opaque(bytes);
    shader.dispose();
    globalThis.both = [drawn, onMesh, expected, plain.errors];`);
  await until(() => globalThis.both);
  const [drawn, onMesh, expected, errors] = await page.evaluate(() => globalThis.both);
  assert.deepEqual(errors, []);
  await page.close();
  return { drawn: bytesOf(drawn), onMesh: bytesOf(onMesh), expected: bytesOf(expected) };
}

async function same(context, file, frames, change) {
  const { drawn, onMesh, expected } = await drawBoth(context, file, frames, change);
  assert.ok(colors(expected) > 1, 'one colour');
  const most = 0.001 * 64 * 36;
  const counts = [drawn, onMesh].map((pixels) => unequal(pixels, expected));
  assert.ok(counts.every((count) => count <= most), `${counts} pixels differ`);
}

/** Buffers that read themselves and each other, with different samplers for one buffer. */
const buffer = (channel, id, filter, wrap) => ({ id, type: 'buffer', channel, sampler: { filter, wrap } });
const BUFFERS = { renderpass: [
  { type: 'common', code: 'float wave(float x) { return 0.5 + 0.5 * sin(x); }', inputs: [], outputs: [] },
  { type: 'buffer', name: 'Buffer A', outputs: [{ id: '4dXGR8' }], inputs: [buffer(0, '4dXGR8', 'nearest', 'clamp')],
    code: `void mainImage(out vec4 c, in vec2 p) {
      c = 0.9 * texelFetch(iChannel0, ivec2(p), 0) + vec4(wave(p.x * 0.1 + iTime * 9.0), p / iResolution.xy, float(iFrame)) * 0.1; }` },
  { type: 'buffer', name: 'Buffer B', outputs: [{ id: 'XsXGR8' }], inputs: [buffer(0, '4dXGR8', 'linear', 'repeat'), buffer(1, '4dXGR8', 'nearest', 'clamp')],
    code: 'void mainImage(out vec4 c, in vec2 p) { vec2 u = 1.3 * p / iResolution.xy; c = mix(texture(iChannel0, u), texture(iChannel1, u), 0.5) + 0.0001 * iChannelResolution[1].x; }' },
  { type: 'image', name: 'Image', outputs: [{ id: '4dfGRr' }], inputs: [buffer(2, 'XsXGR8', 'linear', 'clamp')],
    code: 'void mainImage(out vec4 c, in vec2 p) { c = vec4(texture(iChannel2, p / iResolution.xy).xyz, 1); c.b += step(p.y, 3.0); }' },
] };

/** Functions and variables whose names three.js or WGSL use, and every type of uniform. */
const NAMES = `
float main2(float object) { return object * 0.5; }
struct Varyings { vec3 main; float object; };
vec3 render(Varyings v) { return v.main * v.object; }
float nodeVar0 = 0.25;
void mainImage(out vec4 color, in vec2 position) {
  vec2 uv = position / iResolution.xy;
  color = vec4(render(Varyings(vec3(uv, main2(iTime)), nodeVar0 * 3.0)), 1.0) + 0.001 * float(iFrame) + iMouse * 0.01;
}`;

const CONTROLS = `precision highp float;
uniform float gain; // (0.0~2.0)
uniform bool on;
uniform int steps; // (1~8)
uniform vec3 tint;
uniform vec2 resolution;
uniform float time;
void main() { gl_FragColor = vec4(on ? tint * gain : vec3(gl_FragCoord.xy / resolution, time), 1.0) * float(steps) / 8.0; }`;

async function controls(context) {
  const file = put('gpu_own.frag', CONTROLS);
  await same(context, file, 2);
  const { drawn, expected } = await drawBoth(context, file, 1, `
    Object.assign(plain.uniforms, { gain: 0.5, on: true, tint: [1, 0.5, 0], steps: 6 });
    const { gain, on, steps, tint } = shader.uniforms;
    gain.value = 0.5;
    on.value = 1;
    steps.value = 6;
    tint.value.setRGB(1, 0.5, 0);
    if (shader.controls.length !== 4) throw new Error('no controls');`);
  assert.equal(unequal(drawn, expected), 0);
  assert.deepEqual([...expected.slice(0, 3)], [96, 48, 0]);
}

async function refused(context) {
  void context;
  const cube = { renderpass: [
    { type: 'cubemap', name: 'Cube A', code: 'void mainCubemap(out vec4 c, in vec2 p, in vec3 o, in vec3 d) { c = vec4(d, 1); }', inputs: [], outputs: [{ id: '4dX3Rr' }] },
    { type: 'image', name: 'Image', code: 'void mainImage(out vec4 c, in vec2 p) { c = vec4(1); }', inputs: [], outputs: [] },
  ] };
  const failed = run(CONVERTER, put('gpu_cube.json', JSON.stringify(cube)), '-t', 'three-webgpu', '-o', 'gpu_cube.js', '--force');
  await assert.rejects(failed, /do not support cube map passes \(`Cube A`\); use `--target three` instead/);
}

const DIALECTS = path.join(top, 'tests/fixtures/dialects');
const toy = (name, shader) => put(name, typeof shader === 'string' ? shader : JSON.stringify(shader));

export const threeWebgpuTests = [
  { name: 'three-webgpu: names of three.js may be used by the shader', run: (context) => same(context, toy('gpu_names.glsl', NAMES), 3) },
  { name: 'three-webgpu: buffers draw the same', run: (context) => same(context, toy('gpu_buffers.json', BUFFERS), 4) },
  { name: 'three-webgpu: passes draw in the same order', run: (context) => same(context, toy('gpu_order.json', CASES.find((c) => c.name.includes('order of the export')).shader), 6) },
  { name: 'three-webgpu: user-defined uniforms are properties', run: controls },
  { name: 'three-webgpu: unsupported features are refused', run: refused },
  ...['three/gradient.glsl', 'glsl-sandbox/feedback.glsl', 'book-of-shaders/buffers.frag', 'isf/trails.fs'].map((file) => ({
    name: `three-webgpu: ${file}`,
    run: (context) => same(context, path.join(DIALECTS, file), 4),
  })),
];
