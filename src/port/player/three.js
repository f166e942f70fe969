// What the three.js module does with the project: materials, targets, uniforms.

import {
  Box2, BufferAttribute, BufferGeometry, Camera, ClampToEdgeWrapping, DataTexture, FloatType, GLSL3,
  LinearFilter, LinearMipmapLinearFilter, Mesh, NearestFilter, RawShaderMaterial, RepeatWrapping,
  RedFormat, RGBAFormat, Scene, Vector2, Vector3, Vector4, WebGL3DRenderTarget, WebGLCubeRenderTarget,
  WebGLRenderTarget,
} from 'three';

const VERTEX = `in vec3 position;
void main() {
  gl_Position = vec4(position.xy, 0.0, 1.0);
}
`;

/** The code of a pass; three.js writes the `#version` itself. */
function fragmentOf(pass) {
  const files = pass.files.map((f) => PROJECT.files[f]);
  const isLast = (file) => file === files[files.length - 1];
  const texts = files.map((file) => (file.hidden || isLast(file) ? file.text : `${file.text}\n`));
  return texts.join('').replace(/^#version 300 es\n/, '');
}

function materialOf(pass) {
  const black = new DataTexture(new Uint8Array([0, 0, 0, 255]), 1, 1);
  black.needsUpdate = true;
  const uniforms = {
    iResolution: { value: new Vector3(1, 1, 1) },
    iTime: { value: 0 },
    iTimeDelta: { value: 1 / 60 },
    iFrameRate: { value: 60 },
    iFrame: { value: 0 },
    iMouse: { value: new Vector4() },
    iDate: { value: new Vector4() },
    iSampleRate: { value: 44100 },
    iChannelTime: { value: [0, 0, 0, 0] },
    iChannelResolution: { value: [0, 1, 2, 3].map(() => new Vector3()) },
  };
  for (let i = 0; i < 4; i++) uniforms[`iChannel${i}`] = { value: black };
  return new RawShaderMaterial({
    glslVersion: GLSL3,
    vertexShader: VERTEX,
    fragmentShader: fragmentOf(pass),
    uniforms,
    depthTest: false,
    depthWrite: false,
  });
}

/** Sets filter and wrap of a texture of the user's own, as the channel wants them. */
function setSampling(texture, input) {
  const isSmooth = input.filter === 'linear' || input.filter === 'mipmap';
  texture.magFilter = isSmooth ? LinearFilter : NearestFilter;
  texture.minFilter = input.filter === 'mipmap' ? LinearMipmapLinearFilter : texture.magFilter;
  texture.wrapS = texture.wrapT = input.wrap === 'clamp' ? ClampToEdgeWrapping : RepeatWrapping;
  texture.generateMipmaps = input.filter === 'mipmap';
}

/**
 * Sets filter and wrap of a buffer's texture. Passes may read one buffer differently, and three.js
 * sets those of a render target only once, so this speaks to WebGL itself.
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

/** The target for what stands for a file that is not at hand. */
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

/** What draws it; a film is drawn anew before each frame. */
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

/** Whether some channel reads a buffer with mipmaps. */
function hasMipmaps(pass) {
  const reads = (i) => i?.kind === 'buffer' && PROJECT.passes[i.buffer] === pass;
  return PROJECT.passes.some((p) => p.inputs.some((i) => reads(i) && i.filter === 'mipmap'));
}

/** A pair of targets of zeros. */
function makeTargets(renderer, pass, width, height) {
  const needsMipmaps = hasMipmaps(pass);
  const options = {
    format: RGBAFormat,
    type: FloatType,
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

/** Draws what stands for files with the mesh that draws the buffers. */
function standInPainter(materials, mesh, scene, camera) {
  const made = new Map();

  /** Draws what stands for an input's file, the first time and whenever it moves. */
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

  /** Draws those of all passes, and puts them onto their channels. */
  function draw(renderer, time) {
    for (const [pass, { uniforms }] of materials) {
      pass.inputs.forEach((input, channel) => {
        if (!input?.standIn || input.kind === 'music') return;
        uniforms[`iChannel${channel}`].value = textureOf(renderer, input, time);
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

/**
 * The shader for three.js: `material` paints the Image over whatever mesh it is on, in the
 * coordinates of the screen; `update` sets its uniforms and draws the buffers, before each frame.
 */
export function createShader() {
  const passes = PROJECT.passes.filter((p) => p.kind === 'image' || p.kind === 'buffer');
  const materials = new Map(passes.map((pass) => [pass, materialOf(pass)]));
  const image = passes.find((p) => p.kind === 'image');
  const buffers = passes.filter((p) => p.kind === 'buffer');
  const targets = new Map();
  const given = new Map();
  const scene = new Scene();
  const camera = new Camera();
  const triangle = new BufferGeometry();
  const corners = new Float32Array([-1, -1, 0, 3, -1, 0, -1, 3, 0]);
  triangle.setAttribute('position', new BufferAttribute(corners, 3));
  const mesh = new Mesh(triangle);
  mesh.frustumCulled = false;
  scene.add(mesh);
  const standIns = standInPainter(materials, mesh, scene, camera);
  let frame = 0;

  /** Buffers of this size; what lies in the lower left corner of both sizes stays. */
  function resize(renderer, width, height) {
    for (const pass of buffers) {
      const old = targets.get(pass);
      if (old && old[0].width === width && old[0].height === height) continue;
      const pair = makeTargets(renderer, pass, width, height);
      targets.set(pass, pair);
      if (!old) continue;
      const kept = new Vector2(Math.min(width, old[0].width), Math.min(height, old[0].height));
      const region = new Box2(new Vector2(0, 0), kept);
      old.forEach((from, i) => {
        renderer.copyTextureToTexture(from.texture, pair[i].texture, region);
        from.dispose();
      });
    }
  }

  function bind(renderer, pass, width, height) {
    const { uniforms } = materials.get(pass);
    pass.inputs.forEach((input, channel) => {
      if (!input) return;
      const size = uniforms.iChannelResolution.value[channel];
      const source = input.kind === 'buffer' ? targets.get(PROJECT.passes[input.buffer]) : null;
      if (source) {
        setBufferSampling(renderer, source[0].texture, input);
        uniforms[`iChannel${channel}`].value = source[0].texture;
        size.set(width, height, 1);
      }
      const texture = given.get(`${passes.indexOf(pass)}.${channel}`);
      if (texture) {
        uniforms[`iChannel${channel}`].value = texture;
        size.set(texture.image?.width ?? 0, texture.image?.height ?? 0, 1);
      }
    });
  }

  return {
    material: materials.get(image),
    /** Puts a texture of your own onto a channel of the Image. */
    setChannel(channel, texture) {
      given.set(`${passes.indexOf(image)}.${channel}`, texture);
      const input = image.inputs[channel] ?? { filter: 'linear', wrap: 'repeat' };
      image.inputs[channel] = input;
      setSampling(texture, input);
      texture.needsUpdate = true;
    },
    /** Call it before each frame; time and delta are seconds. */
    update(renderer, { time, delta = 1 / 60, mouse = [0, 0, 0, 0], width, height }) {
      const canvas = renderer.domElement;
      const [w, h] = [width ?? canvas.width, height ?? canvas.height];
      const now = new Date();
      const seconds = now.getHours() * 3600 + now.getMinutes() * 60 + now.getSeconds();
      for (const material of materials.values()) {
        const u = material.uniforms;
        u.iResolution.value.set(w, h, 1);
        u.iTime.value = time;
        u.iTimeDelta.value = delta;
        u.iFrameRate.value = 1 / Math.max(delta, 1e-3);
        u.iFrame.value = frame;
        u.iMouse.value.fromArray(mouse);
        u.iDate.value.set(now.getFullYear(), now.getMonth(), now.getDate(), seconds + now.getMilliseconds() / 1000);
      }
      const before = renderer.getRenderTarget();
      const { autoClear } = renderer;
      // What a shader discards stays as it was two frames ago.
      renderer.autoClear = false;
      resize(renderer, w, h);
      standIns.draw(renderer, time);
      for (const pass of buffers) {
        const pair = targets.get(pass);
        bind(renderer, pass, w, h);
        mesh.material = materials.get(pass);
        renderer.setRenderTarget(pair[1]);
        renderer.render(scene, camera);
        pair.reverse();
      }
      renderer.setRenderTarget(before);
      renderer.autoClear = autoClear;
      bind(renderer, image, w, h);
      frame++;
    },
    /** Starts again at frame 0. */
    restart() {
      targets.forEach((pair) => pair.forEach((t) => t.dispose()));
      targets.clear();
      frame = 0;
    },
    dispose() {
      materials.forEach((m) => m.dispose());
      standIns.dispose();
      targets.forEach((pair) => pair.forEach((t) => t.dispose()));
      triangle.dispose();
    },
  };
}

export default createShader;
