// WGSL that WebGPU draws beside the page in WebGL, pixel by pixel. The host knows nothing of a shader
// but what `--interface` says.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { frame, open, port, put, shaderport, top, work } from './browser.js';

const SIZE = { width: 64, height: 36 };
const templates = path.join(top, 'corpus/templates');

/** Draws a fragment shader over a canvas; runs in the page. Gives its pixels, the lowest row first. */
async function draw({ code, told, uniforms, width, height }) {
  const adapter = await navigator.gpu?.requestAdapter();
  if (!adapter) return { error: 'there is no WebGPU' };
  const device = await adapter.requestDevice();
  device.pushErrorScope('validation');
  const module = device.createShaderModule({ code });
  const { messages } = await module.getCompilationInfo();
  const wrong = messages.filter((m) => m.type === 'error').map((m) => `${m.lineNum}: ${m.message}`);
  if (wrong.length > 0) return { error: wrong.join('\n') };
  const corners = 'vec4f(f32(i % 2u) * 4.0 - 1.0, f32(i / 2u) * 4.0 - 1.0, 0.0, 1.0)';
  const vertex = device.createShaderModule({
    code: `@vertex fn main(@builtin(vertex_index) i: u32) -> @builtin(position) vec4f { return ${corners}; }`,
  });
  const format = 'rgba8unorm';
  const visibility = GPUShaderStage.FRAGMENT;
  const layouts = [];
  const entries = [];
  for (const buffer of told.buffers) {
    const data = new DataView(new ArrayBuffer(buffer.size));
    for (const member of buffer.members) {
      const values = uniforms[member.name] ?? [0];
      values.forEach((value, i) => {
        const at = member.offset + 4 * i;
        if (/^i|^bool/.test(member.type)) data.setInt32(at, value, true);
        else data.setFloat32(at, value, true);
      });
    }
    const memory = device.createBuffer({ size: buffer.size, usage: GPUBufferUsage.UNIFORM | GPUBufferUsage.COPY_DST });
    device.queue.writeBuffer(memory, 0, data);
    layouts.push({ binding: buffer.slot.binding, visibility, buffer: {} });
    entries.push({ binding: buffer.slot.binding, resource: { buffer: memory } });
  }
  for (const { type, texture, sampler } of told.textures) {
    const [dimension, viewDimension, layers] =
      type === 'sampler3D' ? ['3d', '3d', 1] : type === 'samplerCube' ? ['2d', 'cube', 6] : ['2d', '2d', 1];
    const black = device.createTexture({
      size: [1, 1, layers],
      dimension,
      format,
      usage: GPUTextureUsage.TEXTURE_BINDING | GPUTextureUsage.COPY_DST,
    });
    for (let z = 0; z < layers; z++) {
      device.queue.writeTexture({ texture: black, origin: [0, 0, z] }, new Uint8Array([0, 0, 0, 255]), {}, [1, 1, 1]);
    }
    layouts.push({ binding: texture.binding, visibility, texture: { viewDimension } });
    layouts.push({ binding: sampler.binding, visibility, sampler: {} });
    entries.push({ binding: texture.binding, resource: black.createView({ dimension: viewDimension }) });
    entries.push({ binding: sampler.binding, resource: device.createSampler() });
  }
  const layout = device.createBindGroupLayout({ entries: layouts });
  const pipeline = await device.createRenderPipelineAsync({
    layout: device.createPipelineLayout({ bindGroupLayouts: [layout] }),
    vertex: { module: vertex },
    fragment: { module, entryPoint: told.entry, targets: [{ format }] },
  });
  const target = device.createTexture({
    size: [width, height],
    format,
    usage: GPUTextureUsage.RENDER_ATTACHMENT | GPUTextureUsage.COPY_SRC,
  });
  const encoder = device.createCommandEncoder();
  const pass = encoder.beginRenderPass({
    colorAttachments: [{ view: target.createView(), loadOp: 'clear', storeOp: 'store' }],
  });
  pass.setPipeline(pipeline);
  pass.setBindGroup(0, device.createBindGroup({ layout, entries }));
  pass.draw(3);
  pass.end();
  const bytesPerRow = Math.ceil((width * 4) / 256) * 256;
  const read = device.createBuffer({ size: bytesPerRow * height, usage: GPUBufferUsage.COPY_DST | GPUBufferUsage.MAP_READ });
  encoder.copyTextureToBuffer({ texture: target }, { buffer: read, bytesPerRow }, [width, height]);
  device.queue.submit([encoder.finish()]);
  await read.mapAsync(GPUMapMode.READ);
  const error = await device.popErrorScope();
  if (error) return { error: error.message };
  const bytes = new Uint8Array(read.getMappedRange());
  const pixels = [];
  for (let y = height - 1; y >= 0; y--) pixels.push(...bytes.subarray(y * bytesPerRow, y * bytesPerRow + width * 4));
  device.destroy();
  return { pixels };
}

/** What the player sets in frame `n`. */
function playersUniforms(n) {
  const { width, height } = SIZE;
  const now = n / 60;
  return {
    iResolution: [width, height, 1],
    iTime: [now],
    iTimeDelta: [1 / 60],
    iFrame: [n],
    iFrameRate: [60],
    iSampleRate: [44100],
    iDate: null,
  };
}

/** How many pixels differ by more than two steps of a colour, which two compilers may round apart. */
export function unequal(a, b) {
  let count = 0;
  for (let i = 0; i < a.length; i += 4) {
    if ([0, 1, 2].some((c) => Math.abs(a[i + c] - b[i + c]) > 2)) count++;
  }
  return count;
}

/** Draws a shader of one pass in both ways; gives how many pixels differ. */
async function compare(context, file, name) {
  const out = path.join(work, `${name}.wgsl`);
  shaderport(file, '-o', out, '--interface', '--force');
  const address = port(file, name, '--no-stand-ins');
  const { page } = await open(context, address, `#size=${SIZE.width}x${SIZE.height}&paused`);
  await page.evaluate(() => globalThis.shaderport.ready);
  const expected = await frame(page, 6);
  // A page made by the program forbids nothing that WebGPU needs, but has the canvas of WebGL.
  const host = await context.newPage();
  await host.goto(`file://${put('host.html', '<!doctype html>')}`);
  const drawn = await host.evaluate(draw, {
    code: fs.readFileSync(out, 'utf8'),
    told: JSON.parse(fs.readFileSync(`${out}.json`, 'utf8')),
    uniforms: playersUniforms(6),
    ...SIZE,
  });
  assert.equal(drawn.error, undefined);
  return { count: unequal(drawn.pixels, expected), total: SIZE.width * SIZE.height };
}

const equal = { asked: 0, differing: [] };

/** Most exports look the same; those that do not are told by name. */
function mostAreEqual() {
  const { asked, differing } = equal;
  assert.ok(differing.length <= Math.max(1, 0.06 * asked), `${differing.length} of ${asked} differ: ${differing.join(' ')}`);
}

async function exported(context, file, name) {
  const { count, total } = await compare(context, file, name);
  equal.asked++;
  if (count > 0.001 * total) equal.differing.push(`${name} (${count})`);
}

/** Whether the program was built with the languages of naga. */
function hasWgsl() {
  try {
    const probe = put('probe.glsl', 'void mainImage(out vec4 c, in vec2 f) { c = vec4(1); }\n');
    return shaderport(probe, '-o', path.join(work, 'probe.wgsl'), '--force') === 0;
  } catch {
    return false;
  }
}

/** Exports of one pass, whose channels are empty. */
function singles(folder) {
  const all = fs.readdirSync(folder).filter((f) => f.endsWith('.json')).map((f) => path.join(folder, f));
  return all.filter((file) => {
    const { renderpass } = [JSON.parse(fs.readFileSync(file, 'utf8'))].flat()[0];
    return renderpass.length === 1 && !/\biDate\b|\biMouse\b/.test(renderpass[0].code);
  });
}

/** The tests, where the program writes WGSL. */
export function webgpuTests() {
  if (!hasWgsl()) return [];
  const shaders = fs.readdirSync(templates).filter((f) => f.endsWith('.glsl')).map((f) => path.join(templates, f));
  const tests = shaders.map((file) => ({
    name: `webgpu: ${path.basename(file)}`,
    run: async (context) => {
      const { count, total } = await compare(context, file, `gpu_${path.basename(file, '.glsl')}`);
      assert.ok(count <= 0.001 * total, `${count} of ${total} pixels differ`);
    },
  }));
  const cases = process.env.SHADERLINT_CASES && path.join(process.env.SHADERLINT_CASES, 'shadertoy');
  if (cases && fs.existsSync(cases)) {
    const every = Number(process.env.EVERY ?? 1);
    for (const file of singles(cases).filter((_, i) => i % every === 0)) {
      const name = path.basename(file, '.json');
      tests.push({ name: `webgpu export: ${name}`, run: (context) => exported(context, file, name), onLate: () => {} });
    }
    tests.push({ name: 'webgpu: most exports look the same', run: mostAreEqual, isLast: true });
  }
  return tests;
}
