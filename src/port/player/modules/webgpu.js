// The project in three.js for WebGPURenderer: materials, targets, frames.

import {
  BufferAttribute, BufferGeometry, ClampToEdgeWrapping, Color, DataTexture, FloatType, HalfFloatType, LinearFilter,
  LinearMipmapLinearFilter, Mesh, MeshBasicNodeMaterial, NearestFilter, NearestMipmapNearestFilter, NoBlending, QuadMesh, RenderTarget,
  RepeatWrapping, RGBAFormat, SRGBColorSpace, UnsignedByteType, Vector2, Vector3, Vector4,
} from 'three/webgpu';
import { clamp, colorSpaceToWorking, positionLocal, sampler, screenCoordinate, screenUV, texture, uniform, vec2, vec4, wgslFn } from 'three/tsl';

/**
 * Sets the filter and wrap mode of a texture to those of a channel. three.js makes no sampler for a texture with
 * NearestFilter for both filters.
 */
function setSampling(image, input) {
  const isSmooth = input?.filter === 'linear' || input?.filter === 'mipmap';
  image.magFilter = isSmooth ? LinearFilter : NearestFilter;
  image.minFilter = isSmooth ? LinearFilter : NearestMipmapNearestFilter;
  if (input?.filter === 'mipmap') image.minFilter = LinearMipmapLinearFilter;
  image.wrapS = image.wrapT = input?.wrap === 'clamp' ? ClampToEdgeWrapping : RepeatWrapping;
}

/** The texture of an empty channel. */
function emptyTexture() {
  const image = new DataTexture(new Uint8Array([0, 0, 0, 255]), 1, 1, RGBAFormat, UnsignedByteType);
  image.magFilter = image.minFilter = LinearFilter;
  image.needsUpdate = true;
  return image;
}

/** The value of a uniform as a three.js type. */
function valueOf(numbers, isColor) {
  if (numbers.length === 1) return numbers[0];
  if (isColor && numbers.length === 3) return new Color(...numbers);
  const Vector = [Vector2, Vector3, Vector4][numbers.length - 2];
  return new Vector(...numbers);
}

/** The type of a uniform's node; booleans are integers in WGSL. */
function nodeType(type) {
  return type.replace(/^bool$/, 'uint').replace(/^bvec/, 'uvec');
}

/** A uniform node with zeros. */
function emptyUniform(type) {
  return uniform(valueOf(lanesOf(SETTERS[type][1], []), false), nodeType(type));
}

/** The uniforms that the user sets, shared by all passes. */
function userUniforms() {
  const types = new Map(PASSES.flatMap((pass) => pass.parameters.map(({ name, type }) => [name, type])));
  const entry = ({ name, kind, value }) => {
    const type = types.get(name);
    const first = valueOf(value, kind === 'color');
    if (!type) return [name, { value: first }];
    return [name, uniform(first, first instanceof Color ? 'color' : nodeType(type))];
  };
  return Object.fromEntries(CONTROLS.map(entry));
}

/** The pass that draws the buffer of an input. */
function drawnFor(input) {
  const pass = input?.kind === 'buffer' ? PASSES[input.buffer] : undefined;
  return pass && firstInto(pass);
}

/** The first pass that draws into the same target. */
function firstInto(pass) {
  return PASSES.find((p) => p === pass || (pass.into !== undefined && p.into === pass.into));
}

/** The inputs that read the output of a pass. */
function readersOf(pass) {
  return PASSES.flatMap((p) => p.inputs.filter((i) => drawnFor(i) === firstInto(pass)));
}

/** The nodes of a pass: its uniforms by name, a texture and a sampler for each channel, and its colour. */
function nodesOf(pass, users) {
  const uniforms = new Map();
  const given = { position: vec4(screenCoordinate, 0, 1) };
  for (const { name, type, count } of pass.parameters) {
    const isControl = pass.uniforms?.some((u) => u.name === name && u.source === 'control') && users[name];
    const nodes = Array.from({ length: count ?? 1 }, () => isControl || emptyUniform(type));
    uniforms.set(name, nodes);
    nodes.forEach((node, i) => {
      given[count === undefined ? `given_${name}` : `given_${name}_${i}`] = node;
    });
  }
  const channels = pass.samplers.map((name, i) => {
    const channel = pass.inputs.findIndex((input, j) => (input?.uniform ?? `iChannel${j}`) === name);
    const input = pass.inputs[channel];
    const shown = texture(emptyTexture()).setName(`port_texture${i}`);
    // Nodes of one texture would share a binding, and with it a name.
    shown.getUniformHash = () => `${shown.uuid}`;
    // Passes may sample a buffer differently, so each channel has its own sampler.
    const settings = emptyTexture();
    setSampling(settings, input);
    const sampled = texture(settings).setName(`port_sampler${i}`);
    given[`port_t${i}`] = shown;
    given[`port_s${i}`] = sampler(sampled);
    return { name, channel, input, shown, settings };
  });
  return { uniforms, channels, color: wgslFn(pass.code)(given) };
}

/** A material that covers what it is drawn on. */
function coverOf(color) {
  const material = new MeshBasicNodeMaterial({ blending: NoBlending, depthTest: false, depthWrite: false, fog: false, toneMapped: false });
  material.fragmentNode = color;
  return material;
}

/**
 * The colour as three.js expects it: it converts from its working colour space when it draws to the canvas. The
 * image is opaque, as on a page.
 */
function forCanvas(color) {
  return vec4(colorSpaceToWorking(clamp(color.rgb, 0, 1), SRGBColorSpace).rgb, 1);
}

/** A pair of targets: the first is read. */
function makeTargets(renderer, pass, width, height) {
  const isSmooth = readersOf(pass).some((i) => i.filter === 'mipmap');
  const isFloat = pass.float || !pass.uniforms;
  const float = renderer.hasFeature('float32-filterable') ? FloatType : HalfFloatType;
  const options = {
    format: RGBAFormat,
    type: isFloat ? float : UnsignedByteType,
    depthBuffer: false,
    generateMipmaps: isSmooth,
    minFilter: isSmooth ? LinearMipmapLinearFilter : LinearFilter,
    magFilter: LinearFilter,
  };
  return [0, 1].map(() => new RenderTarget(width, height, options));
}

/** Sets the uniforms of a pass for a frame. */
function setFrame({ uniforms, channels }, pass, frame, width, height) {
  const set = (name, numbers) => {
    const [node] = uniforms.get(name) ?? [];
    if (!node) return;
    if (numbers.length === 1) [node.value] = numbers;
    else node.value.fromArray(numbers);
  };
  for (const { name, type, source } of pass.uniforms ?? []) {
    if (SOURCES[source] && SETTERS[type]) set(name, lanesOf(SETTERS[type][1], SOURCES[source](frame, width, height)));
  }
  set('port_size', [width, height]);
  set(pass.height, [height]);
  if (!pass.uniforms) {
    set('iResolution', [width, height, 1]);
    set('iTime', [frame.time]);
    set('iTimeDelta', [frame.delta]);
    set('iFrameRate', [frame.rate]);
    set('iFrame', [frame.number]);
    set('iMouse', frame.mouse);
    set('iDate', frame.date);
    set('iSampleRate', [SOUND_RATE]);
  }
  for (const { channel, shown } of channels) {
    const { width: w = 0, height: h = 0 } = shown.value.image ?? {};
    uniforms.get('iChannelResolution')?.[channel]?.value.set(w, h, 1);
    const own = pass.uniforms?.find((u) => u.source === 'textureSize' && u.of === pass.inputs[channel]?.uniform);
    if (own && SETTERS[own.type]) set(own.name, lanesOf(SETTERS[own.type][1], [w, h, 1]));
  }
}

/** Pairs of targets by the first pass that draws into them. */
function targetStore(users, kept) {
  const targets = new Map();

  /** Width and height of the target of a pass. */
  function sizeOfPass(pass, width, height) {
    const canvas = { $WIDTH: width, $HEIGHT: height };
    const term = (name) => canvas[name] ?? Number(users[name]?.value ?? 0);
    return pass.size ? pass.size.map((t) => pixels(sizeOf(t, term))) : [width, height];
  }

  /** Makes the targets, and new ones if the size changes. */
  function resize(renderer, width, height) {
    for (const pass of kept) {
      const [w, h] = sizeOfPass(pass, width, height);
      const first = firstInto(pass);
      const old = targets.get(first);
      if (old && old[0].width === w && old[0].height === h) continue;
      old?.forEach((target) => target.dispose());
      targets.set(first, makeTargets(renderer, pass, w, h));
    }
  }

  function clear() {
    targets.forEach((pair) => pair.forEach((target) => target.dispose()));
    targets.clear();
  }

  return { targets, sizeOfPass, resize, clear };
}

/** Sets the texture of a channel of the Image, or of all samplers with a name. */
function setChannel(channel, image2d, image, nodes, given) {
  for (const pass of typeof channel === 'number' ? [image] : PASSES) {
    for (const own of nodes.get(pass).channels) {
      if (own.channel !== channel && own.name !== channel && own.name !== `iChannel${channel}`) continue;
      own.input ??= { filter: 'linear', wrap: 'repeat' };
      setSampling(own.settings, own.input);
      given.set(own.input, image2d);
    }
  }
  // The sampler is that of the channel.
  image2d.magFilter = image2d.minFilter = LinearFilter;
  image2d.needsUpdate = true;
}

/** A function that binds the channels of a pass and sets its uniforms. */
const binder = (nodes, { targets, sizeOfPass }, given) => (pass, tick, width, height) => {
  const own = nodes.get(pass);
  for (const { input, shown } of own.channels) {
    const read = targets.get(drawnFor(input))?.[0].texture ?? given.get(input);
    if (read) shown.value = read;
  }
  setFrame(own, pass, tick, ...sizeOfPass(pass, width, height));
};

/**
 * The shader for three.js with WebGPURenderer. `material` draws the Image on any mesh, in screen coordinates.
 * Call `update` before each frame: it sets the uniforms and draws the buffers.
 */
export function createShader() {
  const users = userUniforms();
  const image = PASSES.find((p) => p.kind === 'image');
  const buffers = PASSES.filter((p) => p.kind === 'buffer');
  const nodes = new Map(PASSES.map((pass) => [pass, nodesOf(pass, users)]));
  // If a pass reads the previous Image, it is drawn into a target, and shown from there, upside down.
  const isImageRead = readersOf(image).length > 0;
  const kept = isImageRead ? [...buffers, image] : buffers;
  const shownImage = texture(emptyTexture(), vec2(screenUV.x, screenUV.y.oneMinus()));
  const color = forCanvas(isImageRead ? shownImage : nodes.get(image).color);
  const material = coverOf(color);
  const flat = coverOf(color);
  flat.vertexNode = vec4(positionLocal.xy, 0, 1);
  const triangle = new BufferGeometry();
  triangle.setAttribute('position', new BufferAttribute(new Float32Array([-1, -1, 0, 3, -1, 0, -1, 3, 0]), 3));
  const object = new Mesh(triangle, flat);
  object.frustumCulled = false;
  const inner = new Map(kept.map((pass) => [pass, coverOf(nodes.get(pass).color)]));
  const quad = new QuadMesh();
  const store = targetStore(users, kept);
  const { targets, resize, clear } = store;
  const given = new Map();
  const prepare = binder(nodes, store, given);
  let frame = 0;

  function draw(renderer, pass, tick, width, height) {
    prepare(pass, tick, width, height);
    const pair = targets.get(firstInto(pass));
    quad.material = inner.get(pass);
    renderer.setRenderTarget(pair[1]);
    quad.render(renderer);
  }

  return {
    material,
    /** Draws the image in any scene, on a triangle that covers it. */
    object,
    /** The uniforms that you can set. */
    uniforms: users,
    /** Labels, widgets and ranges of these uniforms. */
    controls: CONTROLS,
    /** Sets the texture of a channel of the Image, or of all samplers with a name. */
    setChannel: (channel, image2d) => setChannel(channel, image2d, image, nodes, given),
    /** Call this before each frame, after `renderer.init()`; time and delta are in seconds. */
    update(renderer, { time, delta = 1 / 60, mouse, width, height }) {
      if (!renderer.backend?.isWebGPUBackend) throw new Error('this shader is WGSL and requires WebGPU');
      const canvas = renderer.domElement;
      const [w, h] = [width ?? canvas.width, height ?? canvas.height];
      const tick = tickOf(frame, time, delta, mouse);
      drawTargets(renderer, () => {
        // From here on, the Image of the previous frame is read.
        if (isImageRead) targets.get(image)?.reverse();
        resize(renderer, w, h);
        for (const pass of buffers) {
          draw(renderer, pass, tick, w, h);
          targets.get(firstInto(pass)).reverse();
        }
        if (!isImageRead) return prepare(image, tick, w, h);
        draw(renderer, image, tick, w, h);
        [, shownImage.value] = targets.get(image).map((target) => target.texture);
        return undefined;
      });
      frame++;
    },
    /** Restarts at frame 0. */
    restart() {
      clear();
      frame = 0;
    },
    dispose() {
      for (const each of [material, flat, ...inner.values()]) each.dispose();
      clear();
      nodes.forEach(({ channels }) => channels.forEach(({ settings }) => settings.dispose()));
      triangle.dispose();
    },
  };
}

export default createShader;
