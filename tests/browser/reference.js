// A second player, written independently from the same description: it draws each frame with plain
// calls, keeps the state of its textures like ShaderToy, and has no page or clock.
import { bytesOf } from './browser.js';

/** Runs inside a browser page, so it must not use anything from outside. */
class Reference {
  static CUBE = 1024;

  static typeOf(pass, c) {
    const types = { cubemap: 'samplerCube', volume: 'sampler3D' };
    return types[pass.inputs.find((i) => i.channel === c)?.type] ?? 'sampler2D';
  }

  constructor(job) {
    Object.assign(this, job);
    const canvas = document.createElement('canvas');
    canvas.width = this.width;
    canvas.height = this.height;
    const gl = canvas.getContext('webgl2', { alpha: false, antialias: false, depth: false });
    this.gl = gl;
    gl.getExtension('EXT_color_buffer_float');
    gl.getExtension('OES_texture_float_linear');
    gl.disable(gl.DITHER);
    this.passes = this.shader.renderpass.filter((p) => p.type !== 'common' && p.type !== 'sound');
    this.programs = new Map(this.passes.map((p) => [p, this.compile(p)]));
    this.stores = new Map();
    this.makeStores();
    this.keyboard = gl.createTexture();
    this.keyData = new Uint8Array(768);
    for (const key of this.keys ?? []) for (const row of [0, 1, 2]) this.keyData[256 * row + key] = 255;
    this.black = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, this.black);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, 1, 1, 0, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array([0, 0, 0, 255]));
    this.setSampling(gl.TEXTURE_2D, 'nearest', 'clamp');
    this.framebuffer = gl.createFramebuffer();
  }

  sourceOf(pass) {
    const channels = [0, 1, 2, 3].map((c) => `uniform ${Reference.typeOf(pass, c)} iChannel${c};`).join(' ');
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
    const common = this.shader.renderpass.filter((p) => p.type === 'common').map((p) => `${p.code}\n`).join('');
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
  vec2 s = 2.0 * gl_FragCoord.xy / ${Reference.CUBE}.0 - 1.0;
  vec3 rd = face_ == 0 ? vec3(1, -s.y, -s.x) : face_ == 1 ? vec3(-1, -s.y, s.x)
    : face_ == 2 ? vec3(s.x, 1, s.y) : face_ == 3 ? vec3(s.x, -1, -s.y)
    : face_ == 4 ? vec3(s.x, -s.y, 1) : vec3(-s.x, -s.y, -1);
  vec4 c = vec4(0, 0, 0, 1);
  mainCubemap(c, gl_FragCoord.xy, vec3(0), normalize(rd));
  result_ = c;
}
`,
    };
    /** Lines that ShaderToy puts before the code; the code can see them. */
    const lines = { image: 53, buffer: 27, cubemap: 30 }[pass.type];
    const before = head + tail[pass.type];
    return before + '\n'.repeat(lines + 1 - before.split('\n').length) + common + pass.code;
  }

  compile(pass) {
    const { gl } = this;
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
    add(gl.FRAGMENT_SHADER, this.sourceOf(pass));
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
    return program;
  }

  setSampling(target, filter, wrap) {
    const { gl } = this;
    const MIN = { nearest: gl.NEAREST, linear: gl.LINEAR, mipmap: gl.LINEAR_MIPMAP_LINEAR };
    const known = filter in MIN ? filter : 'nearest';
    gl.texParameteri(target, gl.TEXTURE_MIN_FILTER, MIN[known]);
    gl.texParameteri(target, gl.TEXTURE_MAG_FILTER, known === 'nearest' ? gl.NEAREST : gl.LINEAR);
    const mode = wrap === 'clamp' ? gl.CLAMP_TO_EDGE : gl.REPEAT;
    gl.texParameteri(target, gl.TEXTURE_WRAP_S, mode);
    gl.texParameteri(target, gl.TEXTURE_WRAP_T, mode);
  }

  makeStores() {
    const { gl, height, passes, stores, width } = this;
    const { CUBE } = Reference;
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
  }

  uploadKeys() {
    const { gl } = this;
    gl.bindTexture(gl.TEXTURE_2D, this.keyboard);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.R8, 256, 3, 0, gl.RED, gl.UNSIGNED_BYTE, this.keyData);
    this.setSampling(gl.TEXTURE_2D, 'nearest', 'clamp');
  }

  bindChannel(pass, channel, sizes) {
    const { black, gl, height, keyboard, stores, width } = this;
    const { CUBE } = Reference;
    const input = pass.inputs.find((i) => i.channel === channel);
    gl.activeTexture(gl.TEXTURE0 + channel);
    const store = input && (input.type === 'buffer' || input.type === 'cubemap') ? stores.get(input.id) : null;
    if (store) {
      gl.bindTexture(store.target, store.textures[store.shown]);
      if (input.sampler.filter === 'mipmap') gl.generateMipmap(store.target);
      this.setSampling(store.target, input.sampler.filter, input.sampler.wrap);
      sizes.splice(3 * channel, 3, ...(store.isCube ? [CUBE, CUBE, 1] : [width, height, 1]));
    } else if (input?.type === 'keyboard') {
      gl.bindTexture(gl.TEXTURE_2D, keyboard);
      if (pass.type !== 'cubemap') sizes.splice(3 * channel, 3, 256, 3, 1);
    } else {
      gl.bindTexture(gl.TEXTURE_2D, black);
    }
  }

  draw(pass, number) {
    const { date, framebuffer, gl, height, mouse, programs, stores, width } = this;
    const { CUBE } = Reference;
    const program = programs.get(pass);
    const at = (name) => gl.getUniformLocation(program, name);
    const isCube = pass.type === 'cubemap';
    const size = isCube ? [CUBE, CUBE] : [width, height];
    gl.useProgram(program);
    const sizes = Array(12).fill(0);
    for (let c = 0; c < 4; c++) {
      this.bindChannel(pass, c, sizes);
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

  /** Draws the frames 0 to `last`; returns the pixels of the last, in base64. */
  play() {
    const { gl, height, keyData, last, passes, width } = this;
    for (let number = 0; number <= last; number++) {
      this.uploadKeys();
      for (const type of ['buffer', 'cubemap', 'image']) {
        for (const pass of passes) if (pass.type === type) this.draw(pass, number);
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
}

/**
 * Draws the frames 0 to `last` of an export in a page; resolves to the pixels of the last.
 * @param {{shader: any, width: number, height: number, last: number,
 *   mouse?: {x: number, y: number}, keys?: number[], date: number[]}} job
 */
export async function reference(page, job) {
  return bytesOf(await page.evaluate(`new (${Reference})(${JSON.stringify(job)}).play()`));
}
