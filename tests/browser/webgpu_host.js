// A host for WGSL that draws every frame in parallel with the WebGL player. It runs inside a page that
// the program made, and knows only the `--interface` output of the shaders; the player provides just
// the clock and the textures of media.

// A single function, because it is sent to the page as text.
/* eslint max-lines-per-function: off */

/**
 * Draws the frames 0 to `last` in both ways; resolves to the pixels of the last, the lowest row first, in base64.
 * @param {{passes: {code: string, told: any}[], last: number}} job
 * @returns {Promise<{error?: string, ours?: string, theirs?: string}>}
 */
export async function beside({ passes, last }) {
  const { player } = globalThis.shaderport;
  const adapter = await navigator.gpu?.requestAdapter();
  if (!adapter) return { error: 'WebGPU is not available' };
  const wanted = ['float32-filterable'].filter((name) => adapter.features.has(name));
  const device = await adapter.requestDevice({ requiredFeatures: wanted });
  device.pushErrorScope('validation');
  const gl = player.gl;
  const { width, height } = player.canvas;
  const sampled = GPUTextureUsage.TEXTURE_BINDING | GPUTextureUsage.COPY_DST;
  const drawn = sampled | GPUTextureUsage.RENDER_ATTACHMENT | GPUTextureUsage.COPY_SRC;

  const corners = 'vec4f(f32(i % 2u) * 4.0 - 1.0, f32(i / 2u) * 4.0 - 1.0, 0.0, 1.0)';
  const vertex = device.createShaderModule({
    code: `@vertex fn main(@builtin(vertex_index) i: u32) -> @builtin(position) vec4f { return ${corners}; }`,
  });

  /** The texture dimension of each sampler type. */
  const shapes = { sampler2D: ['2d', '2d', 1], sampler3D: ['3d', '3d', 1], samplerCube: ['2d', 'cube', 6] };

  /** The content of an empty channel. */
  function black(type) {
    const [dimension, viewDimension, layers] = shapes[type];
    const texture = device.createTexture({ size: [1, 1, layers], dimension, format: 'rgba8unorm', usage: sampled });
    for (let z = 0; z < layers; z++) {
      device.queue.writeTexture({ texture, origin: [0, 0, z] }, new Uint8Array([0, 0, 0, 255]), {}, [1, 1, 1]);
    }
    return texture.createView({ dimension: viewDimension });
  }
  const blacks = Object.fromEntries(Object.keys(shapes).map((type) => [type, black(type)]));

  /** The number of levels of a WebGL texture, given the size of the first. */
  function levelsOf(target, texture, sizes) {
    const all = Math.floor(Math.log2(Math.max(...sizes))) + 1;
    gl.bindTexture(target, texture);
    const isMipmapped = gl.getTexParameter(target, gl.TEXTURE_IMMUTABLE_FORMAT);
    return isMipmapped ? Math.min(all, gl.getTexParameter(target, gl.TEXTURE_IMMUTABLE_LEVELS)) : all;
  }

  /** The content of a level of a WebGL texture, layer by layer; null if the level does not exist. */
  function readLevel(target, texture, level, [w, h, layers]) {
    const face = target === gl.TEXTURE_CUBE_MAP;
    const found = [];
    for (let layer = 0; layer < layers; layer++) {
      const at = gl.COLOR_ATTACHMENT0;
      if (target === gl.TEXTURE_3D) gl.framebufferTextureLayer(gl.FRAMEBUFFER, at, texture, level, layer);
      else gl.framebufferTexture2D(gl.FRAMEBUFFER, at, face ? gl.TEXTURE_CUBE_MAP_POSITIVE_X + layer : target, texture, level);
      if (gl.checkFramebufferStatus(gl.FRAMEBUFFER) !== gl.FRAMEBUFFER_COMPLETE) return null;
      const bytes = new Uint8Array(w * h * 4);
      gl.readPixels(0, 0, w, h, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
      found.push(bytes);
    }
    return found;
  }

  /** Copies a WebGL texture with all its levels; reuses `copied` if it exists. */
  function copy(type, texture, sizes, copied) {
    const [dimension, viewDimension, faces] = shapes[type];
    const target = type === 'sampler2D' ? gl.TEXTURE_2D : type === 'sampler3D' ? gl.TEXTURE_3D : gl.TEXTURE_CUBE_MAP;
    const depth = (level) => (type === 'sampler3D' ? Math.max(1, sizes[2] >> level) : faces);
    const sizeAt = (level) => [Math.max(1, sizes[0] >> level), Math.max(1, sizes[1] >> level), depth(level)];
    const framebuffer = gl.createFramebuffer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
    const most = levelsOf(target, texture, sizes);
    const levels = [];
    for (let level = 0; level < most; level++) {
      const layers = readLevel(target, texture, level, sizeAt(level));
      if (!layers) break;
      levels.push(layers);
    }
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.deleteFramebuffer(framebuffer);
    while (gl.getError() !== gl.NO_ERROR);
    const made =
      copied?.made ??
      device.createTexture({ size: sizeAt(0), dimension, format: 'rgba8unorm', mipLevelCount: levels.length, usage: sampled });
    levels.forEach((layers, level) => {
      const [w, h] = sizeAt(level);
      layers.forEach((bytes, z) => {
        device.queue.writeTexture({ texture: made, mipLevel: level, origin: [0, 0, z] }, bytes, { bytesPerRow: w * 4 }, [w, h, 1]);
      });
    });
    return { made, view: made.createView({ dimension: viewDimension }) };
  }

  const halving = device.createShaderModule({
    code: `@group(0) @binding(0) var above: texture_2d<f32>;
@group(0) @binding(1) var smooth_: sampler;
@vertex fn corner(@builtin(vertex_index) i: u32) -> @builtin(position) vec4f { return ${corners}; }
@fragment fn half(@builtin(position) p: vec4f) -> @location(0) vec4f {
  let size = max(textureDimensions(above) / 2u, vec2u(1u));
  return textureSampleLevel(above, smooth_, p.xy / vec2f(size), 0.0);
}`,
  });
  const smooth = device.createSampler({ magFilter: 'linear', minFilter: 'linear' });
  const halves = new Map();

  /** Generates the smaller levels of a texture, each from the previous one. */
  function makeLevels(texture) {
    const { format, mipLevelCount } = texture;
    const stages = { vertex: { module: halving }, fragment: { module: halving, targets: [{ format }] } };
    if (!halves.has(format)) halves.set(format, device.createRenderPipeline({ layout: 'auto', ...stages }));
    const pipeline = halves.get(format);
    const encoder = device.createCommandEncoder();
    const level = (baseMipLevel) => texture.createView({ baseMipLevel, mipLevelCount: 1 });
    for (let i = 1; i < mipLevelCount; i++) {
      const entries = [{ binding: 0, resource: level(i - 1) }, { binding: 1, resource: smooth }];
      const drawing = encoder.beginRenderPass({ colorAttachments: [{ view: level(i), loadOp: 'clear', storeOp: 'store' }] });
      drawing.setPipeline(pipeline);
      drawing.setBindGroup(0, device.createBindGroup({ layout: pipeline.getBindGroupLayout(0), entries }));
      drawing.draw(3);
      drawing.end();
    }
    device.queue.submit([encoder.finish()]);
  }

  /** A buffer: one texture to read and one to draw into, both empty. */
  function pair(format, mipLevelCount) {
    const one = () => {
      const texture = device.createTexture({ size: [width, height], format, usage: drawn, mipLevelCount });
      const bytes = width * height * (format === 'rgba32float' ? 16 : 4);
      const layout = { bytesPerRow: bytes / height };
      device.queue.writeTexture({ texture }, new Uint8Array(bytes), layout, [width, height]);
      return texture;
    };
    return { read: one(), write: one() };
  }

  function samplerOf(source) {
    const filter = source && source.filter !== 'nearest' ? 'linear' : 'nearest';
    const wrap = source && source.wrap !== 'clamp' ? 'repeat' : 'clamp-to-edge';
    return device.createSampler({
      addressModeU: wrap,
      addressModeV: wrap,
      addressModeW: wrap,
      magFilter: filter,
      minFilter: filter,
      mipmapFilter: source?.filter === 'mipmap' ? 'linear' : 'nearest',
      // Without mipmaps only the first level is sampled.
      lodMaxClamp: source?.filter === 'mipmap' ? 32 : 0,
    });
  }

  const buffers = new Map();
  const everyPass = passes.map((p) => p.told);
  const readers = (name) => everyPass.flatMap((p) => p.textures.filter((t) => t.source?.kind === 'buffer' && t.source.pass === name));
  for (const told of everyPass) {
    const { name, kind, format } = told.pass;
    const hasLevels = readers(name).some((t) => t.source.filter === 'mipmap');
    const levels = hasLevels ? Math.floor(Math.log2(Math.max(width, height))) + 1 : 1;
    if (kind === 'buffer' || kind === 'image') buffers.set(name, pair(format, levels));
  }

  /** Prepares a pass for drawing. */
  async function prepare({ code, told }) {
    const module = device.createShaderModule({ code });
    const { messages } = await module.getCompilationInfo();
    const wrong = messages.filter((m) => m.type === 'error').map((m) => `${told.pass.name}:${m.lineNum}: ${m.message}`);
    if (wrong.length > 0) throw new Error(wrong.join('\n'));
    const visibility = GPUShaderStage.FRAGMENT;
    const layouts = [];
    const uniforms = told.buffers.map((buffer) => {
      const memory = device.createBuffer({ size: buffer.size, usage: GPUBufferUsage.UNIFORM | GPUBufferUsage.COPY_DST });
      layouts.push({ binding: buffer.slot.binding, visibility, buffer: {} });
      return { buffer, memory, data: new DataView(new ArrayBuffer(buffer.size)) };
    });
    for (const { type, texture, sampler } of told.textures) {
      layouts.push({ binding: texture.binding, visibility, texture: { viewDimension: shapes[type][1] } });
      layouts.push({ binding: sampler.binding, visibility, sampler: {} });
    }
    const layout = device.createBindGroupLayout({ entries: layouts });
    const pipeline = await device.createRenderPipelineAsync({
      layout: device.createPipelineLayout({ bindGroupLayouts: [layout] }),
      vertex: { module: vertex },
      fragment: { module, entryPoint: told.entry, targets: [{ format: told.pass.format }] },
    });
    const index = player.project.passes.findIndex((p) => p.name === told.pass.name);
    const samplers = told.textures.map((t) => samplerOf(t.source));
    return { told, layout, pipeline, uniforms, samplers, index, copies: new Map() };
  }

  /** The current texture of a channel of a pass, and its uniforms. */
  function shown(pass, { name, type, source }) {
    const none = { view: blacks[type], size: [0, 0, 0], time: 0, isLoaded: false };
    if (!source) return none;
    if (source.kind === 'buffer') {
      const buffer = buffers.get(source.pass);
      return buffer ? { view: buffer.read.createView(), size: [width, height, 1], time: 0, isLoaded: true } : none;
    }
    const channel = player.project.passes[pass.index].inputs.findIndex((input, i) => input && (input.uniform ?? `iChannel${i}`) === name);
    const isKeyboard = source.kind === 'keyboard';
    const input = isKeyboard
      ? { texture: player.renderer.keys.texture, size: [256, 3, 1], time: 0, isLoaded: true }
      : player.inputs[pass.index][channel];
    if (!input?.texture) return { ...none, size: input?.size ?? none.size };
    const known = pass.copies.get(name);
    const isMoving = ['keyboard', 'video', 'webcam', 'music', 'mic'].includes(source.kind);
    if (!known || isMoving) {
      const cubeSize = pass.index >= 0 && type === 'samplerCube' ? player.project.passes[pass.index].inputs[channel].size : null;
      pass.copies.set(name, copy(type, input.texture, cubeSize ?? input.size, known));
    }
    return { ...input, view: pass.copies.get(name).view };
  }

  /** Writes the ShaderToy uniforms at their offsets. */
  function fill({ buffer, memory, data }, values) {
    for (const { name, type, offset, array } of buffer.members) {
      const lanes = Number(/^[bi]?vec(\d)/.exec(type)?.[1] ?? 1);
      (values[name] ?? [0]).forEach((value, i) => {
        const at = offset + (array?.stride ?? 0) * Math.floor(i / lanes) + 4 * (i % lanes);
        if (/^i|^bool/.test(type)) data.setInt32(at, value, true);
        else data.setFloat32(at, value, true);
      });
    }
    device.queue.writeBuffer(memory, 0, data);
  }

  function values(frame, channels) {
    const now = new Date();
    const midnight = new Date(now.getFullYear(), now.getMonth(), now.getDate());
    const found = {
      iResolution: [width, height, 1],
      iTime: [frame.time],
      iTimeDelta: [frame.delta],
      iFrame: [frame.number],
      iFrameRate: [frame.rate],
      iSampleRate: [44100],
      iMouse: player.mouse.value(),
      iDate: [now.getFullYear(), now.getMonth(), now.getDate(), (now - midnight) / 1000],
      iChannelTime: channels.map((c) => c.time),
      iChannelResolution: channels.flatMap((c) => c.size),
    };
    channels.forEach((channel, i) => {
      found[`iCh${i}.size`] = channel.size;
      found[`iCh${i}.time`] = [channel.time];
      found[`iCh${i}.loaded`] = [channel.isLoaded ? 1 : 0];
    });
    return found;
  }

  /** Draws a pass, which can then be read. */
  function draw(pass, frame) {
    const { told, layout, pipeline, uniforms, samplers } = pass;
    const looks = told.textures.map((t) => shown(pass, t));
    const channels = [0, 1, 2, 3].map((i) => {
      const at = told.textures.findIndex((t) => t.name === `iChannel${i}`);
      return looks[at] ?? { size: [0, 0, 0], time: 0, isLoaded: false };
    });
    uniforms.forEach((u) => fill(u, values(frame, channels)));
    const entries = uniforms.map((u) => ({ binding: u.buffer.slot.binding, resource: { buffer: u.memory } }));
    told.textures.forEach((t, i) => {
      entries.push({ binding: t.texture.binding, resource: looks[i].view });
      entries.push({ binding: t.sampler.binding, resource: samplers[i] });
    });
    const buffer = buffers.get(told.pass.name);
    const encoder = device.createCommandEncoder();
    const drawing = encoder.beginRenderPass({
      // Discarded pixels keep their colour, as in ShaderToy.
      colorAttachments: [{ view: buffer.write.createView({ mipLevelCount: 1 }), loadOp: 'load', storeOp: 'store' }],
    });
    drawing.setPipeline(pipeline);
    drawing.setBindGroup(0, device.createBindGroup({ layout, entries }));
    drawing.draw(3);
    drawing.end();
    device.queue.submit([encoder.finish()]);
    if (buffer.write.mipLevelCount > 1) makeLevels(buffer.write);
    [buffer.read, buffer.write] = [buffer.write, buffer.read];
  }

  /** The pixels of the image. */
  async function picture(told) {
    const bytesPerRow = Math.ceil((width * 4) / 256) * 256;
    const read = device.createBuffer({ size: bytesPerRow * height, usage: GPUBufferUsage.COPY_DST | GPUBufferUsage.MAP_READ });
    const encoder = device.createCommandEncoder();
    encoder.copyTextureToBuffer({ texture: buffers.get(told.pass.name).read }, { buffer: read, bytesPerRow }, [width, height]);
    device.queue.submit([encoder.finish()]);
    await read.mapAsync(GPUMapMode.READ);
    const bytes = new Uint8Array(read.getMappedRange());
    const rows = Array.from({ length: height }, (_, y) => bytes.subarray(y * bytesPerRow, y * bytesPerRow + width * 4));
    if (told.first_row === 'top') rows.reverse();
    const all = new Uint8Array(width * height * 4);
    rows.forEach((row, y) => all.set(row, y * width * 4));
    return all.toBase64();
  }

  const drawable = passes.filter((p) => p.told.pass.order !== undefined);
  drawable.sort((a, b) => a.told.pass.order - b.told.pass.order);
  const prepared = await Promise.all(drawable.map(prepare));
  player.pause();
  player.clock.reset();
  player.inputs.flat().forEach((input) => input.rewind());
  for (let number = 0; number <= last; number++) {
    const frame = player.clock.step();
    player.paint(frame);
    prepared.forEach((pass) => draw(pass, frame));
  }
  const theirs = new Uint8Array(width * height * 4);
  gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, theirs);
  const ours = await picture(prepared[prepared.length - 1].told);
  const error = await device.popErrorScope();
  device.destroy();
  return error ? { error: error.message } : { ours, theirs: theirs.toBase64() };
}
