// A second player, written independently from the same description: it draws each frame with plain
// calls, keeps the state of its textures like ShaderToy, and has no page or clock. It runs inside a
// browser page, so it must not use anything from outside.

// A single function, because it is sent to the page as text.
/* eslint max-lines-per-function: off */

/**
 * Draws the frames 0 to `last` of an export; returns the pixels of the last, in base64.
 * @param {{shader: any, width: number, height: number, last: number,
 *   mouse?: {x: number, y: number}, keys?: number[], date: number[]}} job
 */
export function reference({ shader, width, height, last, mouse, keys, date }) {
  const canvas = document.createElement('canvas');
  canvas.width = width;
  canvas.height = height;
  const gl = canvas.getContext('webgl2', { alpha: false, antialias: false, depth: false });
  gl.getExtension('EXT_color_buffer_float');
  gl.getExtension('OES_texture_float_linear');
  gl.disable(gl.DITHER);
  const CUBE = 1024;
  const types = { cubemap: 'samplerCube', volume: 'sampler3D' };
  const typeOf = (pass, c) => types[pass.inputs.find((i) => i.channel === c)?.type] ?? 'sampler2D';

  /** Lines that ShaderToy puts before the code; the code can see them. */
  const LINES = { image: 53, buffer: 27, cubemap: 30 };
  const padded = (text, count) => text + '\n'.repeat(count + 1 - text.split('\n').length);

  function sourceOf(pass) {
    const channels = [0, 1, 2, 3].map((c) => `uniform ${typeOf(pass, c)} iChannel${c};`).join(' ');
    const head = `#version 300 es
precision highp float;
precision highp int;
precision mediump sampler3D;
uniform vec3 iResolution;
uniform float iTime;
uniform float iChannelTime[4];
uniform vec4 iMouse;
uniform vec4 iDate;
uniform float iSampleRate;
uniform vec3 iChannelResolution[4];
uniform int iFrame;
uniform float iTimeDelta;
uniform float iFrameRate;
${channels}
`;
    const common = shader.renderpass.filter((p) => p.type === 'common').map((p) => `${p.code}\n`).join('');
    const tail = {
      image: `void mainImage(out vec4 c, in vec2 p);
out vec4 result_;
void main() { vec4 c = vec4(0, 0, 0, 1); mainImage(c, gl_FragCoord.xy); result_ = vec4(c.rgb, 1.0); }
`,
      buffer: `void mainImage(out vec4 c, in vec2 p);
out vec4 result_;
void main() { vec4 c = vec4(0, 0, 0, 1); mainImage(c, gl_FragCoord.xy); result_ = c; }
`,
      cubemap: `void mainCubemap(out vec4 c, in vec2 p, in vec3 ro, in vec3 rd);
out vec4 result_;
uniform int face_;
void main() {
  vec2 s = 2.0 * gl_FragCoord.xy / ${CUBE}.0 - 1.0;
  vec3 rd = face_ == 0 ? vec3(1, -s.y, -s.x) : face_ == 1 ? vec3(-1, -s.y, s.x)
    : face_ == 2 ? vec3(s.x, 1, s.y) : face_ == 3 ? vec3(s.x, -1, -s.y)
    : face_ == 4 ? vec3(s.x, -s.y, 1) : vec3(-s.x, -s.y, -1);
  vec4 c = vec4(0, 0, 0, 1);
  mainCubemap(c, gl_FragCoord.xy, vec3(0), normalize(rd));
  result_ = c;
}
`,
    };
    return padded(head + tail[pass.type], LINES[pass.type]) + common + pass.code;
  }

  function compile(pass) {
    const program = gl.createProgram();
    const add = (type, text) => {
      const s = gl.createShader(type);
      gl.shaderSource(s, text);
      gl.compileShader(s);
      if (!gl.getShaderParameter(s, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(s));
      gl.attachShader(program, s);
    };
    const corners = 'vec2[3](vec2(-1,-1), vec2(3,-1), vec2(-1,3))';
    add(gl.VERTEX_SHADER, `#version 300 es
void main() { gl_Position = vec4(${corners}[gl_VertexID], 0, 1); }`);
    add(gl.FRAGMENT_SHADER, sourceOf(pass));
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
    return program;
  }

  const MIN = { nearest: gl.NEAREST, linear: gl.LINEAR, mipmap: gl.LINEAR_MIPMAP_LINEAR };
  const setSampling = (target, sampler, filter, wrap) => {
    const known = filter in MIN ? filter : 'nearest';
    gl.texParameteri(target, gl.TEXTURE_MIN_FILTER, MIN[known]);
    gl.texParameteri(target, gl.TEXTURE_MAG_FILTER, known === 'nearest' ? gl.NEAREST : gl.LINEAR);
    const mode = wrap === 'clamp' ? gl.CLAMP_TO_EDGE : gl.REPEAT;
    gl.texParameteri(target, gl.TEXTURE_WRAP_S, mode);
    gl.texParameteri(target, gl.TEXTURE_WRAP_T, mode);
  };

  const passes = shader.renderpass.filter((p) => p.type !== 'common' && p.type !== 'sound');
  const programs = new Map(passes.map((p) => [p, compile(p)]));
  const stores = new Map();
  // A buffer exists if something reads it, whether it is drawn or not.
  const reads = passes.flatMap((p) => p.inputs).filter((i) => i.type === 'buffer');
  const read = reads.map((i) => ({ type: 'buffer', outputs: [{ id: i.id }] }));
  for (const pass of [...read, ...passes.filter((p) => p.type !== 'image')]) {
    const isCube = pass.type === 'cubemap';
    const target = isCube ? gl.TEXTURE_CUBE_MAP : gl.TEXTURE_2D;
    const textures = [0, 1].map(() => {
      const texture = gl.createTexture();
      gl.bindTexture(target, texture);
      const faces = isCube ? [0, 1, 2, 3, 4, 5].map((f) => gl.TEXTURE_CUBE_MAP_POSITIVE_X + f) : [gl.TEXTURE_2D];
      for (const face of faces) {
        if (isCube) gl.texImage2D(face, 0, gl.RGBA16F, CUBE, CUBE, 0, gl.RGBA, gl.HALF_FLOAT, null);
        else gl.texImage2D(face, 0, gl.RGBA32F, width, height, 0, gl.RGBA, gl.FLOAT, new Float32Array(width * height * 4));
      }
      gl.texParameteri(target, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
      return texture;
    });
    stores.set(pass.outputs[0].id, { target, textures, shown: 0, isCube });
  }

  const keyboard = gl.createTexture();
  const keyData = new Uint8Array(768);
  for (const key of keys ?? []) {
    keyData[key] = 255;
    keyData[256 + key] = 255;
    keyData[512 + key] = 255;
  }
  const uploadKeys = () => {
    gl.bindTexture(gl.TEXTURE_2D, keyboard);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.R8, 256, 3, 0, gl.RED, gl.UNSIGNED_BYTE, keyData);
    setSampling(gl.TEXTURE_2D, null, 'nearest', 'clamp');
  };
  const black = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, black);
  gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, 1, 1, 0, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array([0, 0, 0, 255]));
  setSampling(gl.TEXTURE_2D, null, 'nearest', 'clamp');

  function bindChannel(pass, channel, sizes) {
    const input = pass.inputs.find((i) => i.channel === channel);
    gl.activeTexture(gl.TEXTURE0 + channel);
    const store = input && (input.type === 'buffer' || input.type === 'cubemap') ? stores.get(input.id) : null;
    if (store) {
      gl.bindTexture(store.target, store.textures[store.shown]);
      if (input.sampler.filter === 'mipmap') gl.generateMipmap(store.target);
      setSampling(store.target, null, input.sampler.filter, input.sampler.wrap);
      sizes.splice(3 * channel, 3, ...(store.isCube ? [CUBE, CUBE, 1] : [width, height, 1]));
    } else if (input?.type === 'keyboard') {
      gl.bindTexture(gl.TEXTURE_2D, keyboard);
      if (pass.type !== 'cubemap') sizes.splice(3 * channel, 3, 256, 3, 1);
    } else {
      gl.bindTexture(gl.TEXTURE_2D, black);
    }
  }

  const framebuffer = gl.createFramebuffer();
  function draw(pass, number) {
    const program = programs.get(pass);
    const at = (name) => gl.getUniformLocation(program, name);
    const isCube = pass.type === 'cubemap';
    const size = isCube ? [CUBE, CUBE] : [width, height];
    gl.useProgram(program);
    const sizes = Array(12).fill(0);
    for (let c = 0; c < 4; c++) {
      bindChannel(pass, c, sizes);
      gl.uniform1i(at(`iChannel${c}`), c);
    }
    gl.activeTexture(gl.TEXTURE7);
    gl.uniform3f(at('iResolution'), ...size, 1);
    gl.uniform1f(at('iTime'), number / 60);
    gl.uniform1f(at('iTimeDelta'), 1 / 60);
    gl.uniform1f(at('iFrameRate'), 60);
    gl.uniform1f(at('iSampleRate'), 44100);
    gl.uniform1i(at('iFrame'), number);
    gl.uniform4f(at('iDate'), ...date);
    gl.uniform3fv(at('iChannelResolution'), sizes);
    const [x, y] = mouse ? [Math.floor(mouse.x), Math.floor(mouse.y)] : [0, 0];
    gl.uniform4f(at('iMouse'), x, y, mouse ? x : -0, mouse && number === 0 ? y : -y);
    const store = pass.type === 'image' ? null : stores.get(pass.outputs[0].id);
    gl.viewport(0, 0, ...size);
    gl.bindFramebuffer(gl.FRAMEBUFFER, store ? framebuffer : null);
    for (let face = 0; face < (isCube ? 6 : 1); face++) {
      if (store) {
        const side = isCube ? gl.TEXTURE_CUBE_MAP_POSITIVE_X + face : gl.TEXTURE_2D;
        gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, side, store.textures[1 - store.shown], 0);
      }
      gl.uniform1i(at('face_'), face);
      gl.drawArrays(gl.TRIANGLES, 0, 3);
    }
    if (store) store.shown = 1 - store.shown;
  }

  for (let number = 0; number <= last; number++) {
    uploadKeys();
    for (const type of ['buffer', 'cubemap', 'image']) {
      for (const pass of passes) if (pass.type === type) draw(pass, number);
    }
    keyData.fill(0, 256, 512);
  }
  const bytes = new Uint8Array(width * height * 4);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
  const error = gl.getError();
  gl.getExtension('WEBGL_lose_context')?.loseContext();
  if (error) throw new Error(`the reference player: WebGL error ${error}`);
  return bytes.toBase64();
}
