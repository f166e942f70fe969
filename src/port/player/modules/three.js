// The project in three.js: targets, channels, frames.

/** Sets the filter and wrap mode of a user's texture to those of the channel. */
function setSampling(texture, input) {
  const isSmooth = input.filter === 'linear' || input.filter === 'mipmap';
  texture.magFilter = isSmooth ? LinearFilter : NearestFilter;
  texture.minFilter = input.filter === 'mipmap' ? LinearMipmapLinearFilter : texture.magFilter;
  texture.wrapS = texture.wrapT = input.wrap === 'clamp' ? ClampToEdgeWrapping : RepeatWrapping;
  texture.generateMipmaps = input.filter === 'mipmap';
}

/**
 * Sets the filter and wrap mode of a buffer's texture. Passes may sample the same buffer differently, but
 * three.js sets those of a render target only once, so this calls WebGL directly.
 */
function setBufferSampling(renderer, texture, input) {
  const gl = renderer.getContext();
  const mag = input.filter === 'linear' || input.filter === 'mipmap' ? gl.LINEAR : gl.NEAREST;
  const min = input.filter === 'mipmap' ? gl.LINEAR_MIPMAP_LINEAR : mag;
  const wrap = input.wrap === 'clamp' ? gl.CLAMP_TO_EDGE : gl.REPEAT;
  renderer.state.bindTexture(gl.TEXTURE_2D, renderer.properties.get(texture).__webglTexture);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, mag);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, min);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, wrap);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, wrap);
}

/** The render target of a stand-in. */
function standInTarget(input) {
  const [width, height, depth] = input.size;
  const options = { depthBuffer: false, format: input.gray ? RedFormat : RGBAFormat };
  let target = null;
  if (input.kind === 'cubemap') target = new WebGLCubeRenderTarget(width, options);
  else if (input.kind === 'volume') target = new WebGL3DRenderTarget(width, height, depth, options);
  else target = new WebGLRenderTarget(width, height, options);
  setSampling(target.texture, input);
  target.texture.wrapR = target.texture.wrapS;
  return target;
}

/** The material of a stand-in; a video is redrawn before each frame. */
function standInMaterial(input) {
  const { text } = PROJECT.media.find((m) => m.name === input.standIn);
  return new RawShaderMaterial({
    glslVersion: GLSL3,
    vertexShader: VERTEX,
    fragmentShader: text.replace(/^#version 300 es\n/, ''),
    uniforms: {
      size: { value: new Vector2(input.size[0], input.size[1]) },
      flip: { value: input.vflip },
      layer: { value: 0 },
      time: { value: 0 },
    },
    depthTest: false,
    depthWrite: false,
  });
}

/** The first pass that draws into the same target. */
function firstInto(pass) {
  return PROJECT.passes.find((p) => p === pass || (pass.into !== undefined && p.into === pass.into));
}

/** The pass that draws the buffer of an input. */
function drawnFor(input) {
  const pass = input?.kind === 'buffer' ? PROJECT.passes[input.buffer] : undefined;
  return pass && firstInto(pass);
}

/** The inputs that read the output of a pass. */
function readersOf(pass) {
  return PROJECT.passes.flatMap((p) => p.inputs.filter((i) => drawnFor(i) === firstInto(pass)));
}

/** A pair of targets, cleared to zero. */
function makeTargets(renderer, pass, width, height) {
  const needsMipmaps = readersOf(pass).some((i) => i.filter === 'mipmap');
  const options = {
    format: RGBAFormat,
    type: pass.float || !pass.uniforms ? FloatType : UnsignedByteType,
    depthBuffer: false,
    generateMipmaps: needsMipmaps,
    minFilter: needsMipmaps ? LinearMipmapLinearFilter : NearestFilter,
    magFilter: NearestFilter,
  };
  const gl = renderer.getContext();
  return [0, 1].map(() => {
    const target = new WebGLRenderTarget(width, height, options);
    renderer.setRenderTarget(target);
    gl.clearBufferfv(gl.COLOR, 0, [0, 0, 0, 0]);
    return target;
  });
}

/** Draws stand-ins with the mesh of the buffers. */
function standInPainter(materials, mesh, scene, camera) {
  const made = new Map();

  /** Draws the stand-in of an input, once or, for a video, for each frame. */
  function textureOf(renderer, input, time) {
    const known = made.get(input);
    const own = known ?? { target: standInTarget(input), material: standInMaterial(input) };
    made.set(input, own);
    if (known && input.kind !== 'video') return own.target.texture;
    const { uniforms } = own.material;
    const layers = input.kind === 'cubemap' ? 6 : input.size[2];
    uniforms.time.value = time;
    mesh.material = own.material;
    for (let layer = 0; layer < layers; layer++) {
      uniforms.layer.value = layer;
      renderer.setRenderTarget(own.target, layer);
      renderer.render(scene, camera);
    }
    return own.target.texture;
  }

  /** Draws the stand-ins of all passes and sets their channels. */
  function draw(renderer, time) {
    for (const [pass, { uniforms }] of materials) {
      pass.inputs.forEach((input, channel) => {
        if (!input?.standIn || input.sampler || input.kind === 'music') return;
        setTexture({ uniforms }, pass, channel, textureOf(renderer, input, time));
        if (input.kind !== 'cubemap') uniforms.iChannelResolution.value[channel].fromArray(input.size);
        if (input.kind === 'video') uniforms.iChannelTime.value[channel] = time;
      });
    }
  }

  function dispose() {
    made.forEach(({ target, material }) => {
      target.dispose();
      material.dispose();
    });
  }

  return { draw, dispose };
}

/** The texture of synthetic sound, in the form that a channel requires. */
function signalTexture(input) {
  const texels = signalTexels(input.form);
  const type = texels instanceof Float32Array ? FloatType : UnsignedByteType;
  const texture = new DataTexture(texels, SIGNAL_WIDTH, texels.length / (4 * SIGNAL_WIDTH), RGBAFormat, type);
  setSampling(texture, input);
  return texture;
}

/** Advances it to a time, with the seconds since the last call. */
function advanceSignal(texture, input, time, seconds) {
  const [spectrum, wave] = [new Uint8Array(1024), new Uint8Array(1024)];
  makeUpSignal(time, spectrum, wave);
  addSignal(texture.image.data, input.form === 'wave' ? wave : spectrum, seconds);
  texture.needsUpdate = true;
}

/** Render targets by pass: pairs of which the first is read. */
function targetStore(users, kept) {
  const pairs = new Map();

  /** Width and height of the target of a pass. */
  function sizeOfPass(pass, width, height) {
    const canvas = { $WIDTH: width, $HEIGHT: height };
    const term = (name) => canvas[name] ?? Number(users[name]?.value ?? 0);
    return pass.size ? pass.size.map((t) => pixels(sizeOf(t, term))) : [width, height];
  }

  /** Resizes the targets. The common lower left part keeps its content. */
  function resize(renderer, width, height) {
    for (const pass of kept) {
      const [w, h] = sizeOfPass(pass, width, height);
      const shared = pairs.get(firstInto(pass));
      pairs.set(pass, shared ?? []);
      const old = shared?.length ? shared : null;
      if (old && old[0].width === w && old[0].height === h) continue;
      const pair = makeTargets(renderer, pass, w, h);
      if (!old) {
        pairs.get(pass).push(...pair);
        continue;
      }
      const common = new Vector2(Math.min(w, old[0].width), Math.min(h, old[0].height));
      const region = new Box2(new Vector2(0, 0), common);
      old.splice(0).forEach((from, i) => {
        renderer.copyTextureToTexture(from.texture, pair[i].texture, region);
        from.dispose();
      });
      old.push(...pair);
    }
  }

  /** Discards all targets. */
  function clear() {
    pairs.forEach((pair) => pair.forEach((t) => t.dispose()));
    pairs.clear();
  }

  return { sizeOfPass, resize, clear, of: (pass) => pairs.get(pass) };
}

/** Binds the inputs of channels. `given` and `signals` are textures by input. */
function channelBinder(materials, targets, given, signals) {
  /** Sets the uniforms with the sizes of textures. */
  function setSizes(pass) {
    const { uniforms } = materials.get(pass);
    for (const { name, type, source, of } of pass.uniforms ?? []) {
      const channel = source === 'textureSize' ? pass.inputs.findIndex((i) => i?.uniform === of) : -1;
      if (channel < 0) continue;
      const size = uniforms.iChannelResolution.value[channel].toArray();
      uniforms[name].value = valueOf(lanesOf(SETTERS[type][1], size), false);
    }
  }

  return function bind(renderer, pass) {
    const material = materials.get(pass);
    pass.inputs.forEach((input, channel) => {
      if (!input) return;
      const size = material.uniforms.iChannelResolution.value[channel];
      const source = targets.of(drawnFor(input));
      if (source) {
        setBufferSampling(renderer, source[0].texture, input);
        setTexture(material, pass, channel, source[0].texture);
        size.set(source[0].width, source[0].height, 1);
      }
      const texture = given.get(input) ?? signals.get(input);
      if (texture) {
        setTexture(material, pass, channel, texture);
        size.set(texture.image?.width ?? 0, texture.image?.height ?? 0, 1);
      }
    });
    setSizes(pass);
  };
}

/** Sets the uniforms of all passes for a frame. */
function setFrame(materials, targets, tick, width, height) {
  for (const [pass, material] of materials) {
    if (pass.uniforms) {
      setOwnUniforms(material, pass, tick, ...targets.sizeOfPass(pass, width, height));
      continue;
    }
    const u = material.uniforms;
    u.iResolution.value.set(width, height, 1);
    u.iTime.value = tick.time;
    u.iTimeDelta.value = tick.delta;
    u.iFrameRate.value = tick.rate;
    u.iFrame.value = tick.number;
    u.iMouse.value.fromArray(tick.mouse);
    u.iDate.value.fromArray(tick.date);
  }
}

/** Draws the first vertices of a geometry. */
function setVertexCount(geometry, count) {
  geometry.setDrawRange(0, geometry.index ? 3 * Math.max(0, count - 2) : count);
}

/** Sets the texture of a channel of the Image, or of all samplers with a name. */
function setChannel(channel, texture, passes, image, given) {
  for (const pass of typeof channel === 'number' ? [image] : passes) {
    const found = (i) => (typeof channel === 'number' ? i === channel : pass.inputs[i]?.uniform === channel);
    const index = Array.from({ length: Math.max(4, pass.inputs.length) }, (_, i) => i).find(found);
    if (index === undefined) continue;
    pass.inputs[index] ??= { filter: 'linear', wrap: 'repeat' };
    given.set(pass.inputs[index], texture);
    setSampling(texture, pass.inputs[index]);
  }
  texture.needsUpdate = true;
}

/**
 * The shader for three.js. `material` draws the Image on any mesh, in screen coordinates. Call `update`
 * before each frame: it sets the uniforms and draws the buffers.
 */
export function createShader() {
  const passes = PROJECT.passes.filter((p) => p.kind === 'image' || p.kind === 'buffer');
  const users = userUniforms();
  const materials = new Map(passes.map((pass) => [pass, materialOf(pass, users)]));
  const image = passes.find((p) => p.kind === 'image');
  const buffers = passes.filter((p) => p.kind === 'buffer');
  // If a pass reads the previous Image, it is also drawn into a target.
  const isImageRead = readersOf(image).length > 0;
  const kept = isImageRead ? [...buffers, image] : buffers;
  const targets = targetStore(users, kept);
  const given = new Map();
  const signals = new Map(passes.flatMap((p) => p.inputs.filter((i) => i?.form).map((i) => [i, signalTexture(i)])));
  const scene = new Scene();
  const camera = new Camera();
  const triangle = flatGeometry([[-1, -1], [3, -1], [-1, 3]]);
  // Vertex shaders in the file may require the corners of the image.
  const square = flatGeometry([[-1, -1], [1, -1], [1, 1], [-1, 1], [-1, -1], [1, 1]]);
  const coverOf = (pass) => (pass.quad ? square : triangle);
  const mesh = new Mesh(triangle);
  mesh.frustumCulled = false;
  scene.add(mesh);
  const object = objectOf(image, materials.get(image), coverOf(image));
  const standIns = standInPainter(materials, mesh, scene, camera);
  const bind = channelBinder(materials, targets, given, signals);
  let frame = 0;

  /** Draws a pass into the write target, while others read the previous output. */
  function draw(renderer, pass) {
    bind(renderer, pass);
    mesh.material = materials.get(pass);
    mesh.geometry = coverOf(pass);
    renderer.setRenderTarget(targets.of(pass)[1]);
    renderer.render(scene, camera);
  }

  return {
    material: materials.get(image),
    /** Draws the image in any scene: the material on a triangle, or on numbered vertices. */
    object,
    /** The uniforms that you can set. */
    uniforms: users,
    /** Labels, widgets and ranges of these uniforms. */
    controls: PROJECT.controls,
    /** Sets the texture of a channel of the Image, or of all samplers with a name. */
    setChannel: (channel, texture) => setChannel(channel, texture, passes, image, given),
    /** Call this before each frame; time and delta are in seconds. */
    update(renderer, { time, delta = 1 / 60, mouse, width, height }) {
      const canvas = renderer.domElement;
      const [w, h] = [width ?? canvas.width, height ?? canvas.height];
      const tick = tickOf(frame, time, delta, mouse);
      setFrame(materials, targets, tick, w, h);
      signals.forEach((texture, input) => advanceSignal(texture, input, time, frame > 0 ? delta : 0));
      drawTargets(renderer, () => {
        // From here on, the Image of the previous frame is read.
        targets.of(isImageRead ? image : null)?.reverse();
        targets.resize(renderer, w, h);
        standIns.draw(renderer, time);
        for (const pass of buffers) {
          draw(renderer, pass);
          targets.of(pass).reverse();
        }
        if (isImageRead) draw(renderer, image);
      });
      bind(renderer, image);
      if (image.fragment) setVertexCount(object.geometry, Math.floor(users.vertexCount.value));
      frame++;
    },
    /** Restarts at frame 0. */
    restart() {
      targets.clear();
      signals.forEach((texture) => texture.image.data.fill(0));
      frame = 0;
    },
    dispose() {
      for (const each of [...materials.values(), standIns, ...signals.values(), object.geometry, triangle, square]) each.dispose();
      targets.clear();
    },
  };
}

export default createShader;
