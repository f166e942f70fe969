// Helpers for WebGL2: programs, textures, samplers.

/** A compile or link error; `log` is the log of the compiler. */
class CompileError extends Error {
  /** @param {string} log */
  constructor(log) {
    super(log);
    this.log = log;
  }
}

/** @typedef {{program: WebGLProgram, shaders: WebGLShader[]}} StartedProgram */

/**
 * Starts compiling and linking a pass, without waiting for the result.
 * @param {WebGL2RenderingContext} gl
 * @param {ProjectData} project
 * @param {PassData} pass
 * @returns {StartedProgram}
 */
function startProgram(gl, project, pass) {
  const own = passSource(project, pass);
  if (pass.fragment) return startShaders(gl, own, pass.fragment);
  return startShaders(gl, pass.vertex ?? project.vertex, own);
}

/**
 * Starts compiling and linking two shaders.
 * @param {WebGL2RenderingContext} gl
 * @param {string} vertex
 * @param {string} fragment
 * @returns {StartedProgram}
 */
function startShaders(gl, vertex, fragment) {
  const program = gl.createProgram();
  const shaders = [
    addShader(gl, program, gl.VERTEX_SHADER, vertex),
    addShader(gl, program, gl.FRAGMENT_SHADER, fragment),
  ];
  // GLSL ES 1.00 has no attribute locations; other shaders have no attributes with these names.
  gl.bindAttribLocation(program, 0, 'port_pos');
  gl.bindAttribLocation(program, 1, 'vertexId');
  gl.linkProgram(program);
  return { program, shaders };
}

/**
 * @param {WebGL2RenderingContext} gl
 * @param {KHR_parallel_shader_compile} parallel
 * @param {WebGLProgram} program
 */
function isCompiled(gl, parallel, program) {
  return gl.isContextLost() || gl.getProgramParameter(program, parallel.COMPLETION_STATUS_KHR);
}

/**
 * Waits for a program. Throws {@link CompileError} with the compiler's log.
 * @param {WebGL2RenderingContext} gl
 * @param {StartedProgram} started
 */
function finishProgram(gl, { program, shaders }) {
  const isLinked = gl.getProgramParameter(program, gl.LINK_STATUS);
  const logs = shaders.map((s) => gl.getShaderInfoLog(s) || '');
  const linkLog = gl.getProgramInfoLog(program) || '';
  shaders.forEach((s) => gl.deleteShader(s));
  if (isLinked || gl.isContextLost()) return program;
  gl.deleteProgram(program);
  throw new CompileError(logs.find((log) => log.trim()) || linkLog || 'the program does not link');
}

/**
 * @param {WebGL2RenderingContext} gl
 * @param {WebGLProgram} program
 * @param {number} type
 * @param {string} source
 */
function addShader(gl, program, type, source) {
  const shader = /** @type {WebGLShader} */ (gl.createShader(type));
  gl.shaderSource(shader, source);
  gl.compileShader(shader);
  gl.attachShader(program, shader);
  return shader;
}

/**
 * Caches uniform locations.
 * @param {WebGL2RenderingContext} gl
 * @param {WebGLProgram} program
 * @returns {(name: string) => WebGLUniformLocation | null}
 */
function uniformLookup(gl, program) {
  /** @type {Map<string, WebGLUniformLocation | null>} */
  const known = new Map();
  return (name) => {
    let location = known.get(name);
    if (location === undefined) {
      location = gl.getUniformLocation(program, name);
      known.set(name, location);
    }
    return location;
  };
}

/**
 * Sampler objects, one for each filter and wrap mode: channels may sample the same texture differently.
 * @param {WebGL2RenderingContext} gl
 */
function samplerCache(gl) {
  /** @type {Map<string, WebGLSampler>} */
  const made = new Map();
  /** @param {string} filter @param {string} wrap */
  const get = (filter, wrap) => {
    const key = `${filter} ${wrap}`;
    const known = made.get(key);
    if (known) return known;
    const sampler = /** @type {WebGLSampler} */ (gl.createSampler());
    const mag = filter === 'linear' || filter === 'mipmap' ? gl.LINEAR : gl.NEAREST;
    const min = filter === 'mipmap' ? gl.LINEAR_MIPMAP_LINEAR : mag;
    const mode = wrap === 'clamp' ? gl.CLAMP_TO_EDGE : gl.REPEAT;
    gl.samplerParameteri(sampler, gl.TEXTURE_MAG_FILTER, mag);
    gl.samplerParameteri(sampler, gl.TEXTURE_MIN_FILTER, min);
    gl.samplerParameteri(sampler, gl.TEXTURE_WRAP_S, mode);
    gl.samplerParameteri(sampler, gl.TEXTURE_WRAP_T, mode);
    gl.samplerParameteri(sampler, gl.TEXTURE_WRAP_R, mode);
    made.set(key, sampler);
    return sampler;
  };
  const dispose = () => made.forEach((s) => gl.deleteSampler(s));
  return { get, dispose };
}

/** @param {WebGL2RenderingContext} gl @param {number} place @param {number} lanes @param {Float32Array} data */
function fillAttribute(gl, place, lanes, data) {
  const buffer = gl.createBuffer();
  gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
  gl.bufferData(gl.ARRAY_BUFFER, data, gl.STATIC_DRAW);
  gl.enableVertexAttribArray(place);
  gl.vertexAttribPointer(place, lanes, gl.FLOAT, false, 0, 0);
  return buffer;
}

/** Black textures for channels without an input, made when needed. @param {WebGL2RenderingContext} gl */
function blackTextures(gl) {
  /** @type {Map<string | number, WebGLTexture>} */
  const made = new Map();
  /** @template {string | number} T @param {T} key @param {(gl: WebGL2RenderingContext, key: T) => WebGLTexture} make */
  const get = (key, make) => {
    const texture = made.get(key) ?? make(gl, key);
    made.set(key, texture);
    return texture;
  };
  return {
    /** The texture for a target. @param {number} target */
    of: (target) => {
      const texture = get(target, blackTexture);
      gl.bindTexture(target, texture);
      return texture;
    },
    /** Binds the default texture for a less common sampler type. @param {string} type */
    bind: (type) => parts.plainTexture && gl.bindTexture(parts.samplerTarget?.(gl, type) ?? gl.TEXTURE_2D, get(type, parts.plainTexture)),
    dispose: () => made.forEach((texture) => gl.deleteTexture(texture)),
  };
}

/**
 * A texture of one opaque black texel, which is what an input that is not loaded gives.
 * @param {WebGL2RenderingContext} gl
 * @param {number} target
 */
function blackTexture(gl, target) {
  const texture = /** @type {WebGLTexture} */ (gl.createTexture());
  const black = new Uint8Array([0, 0, 0, 255]);
  gl.bindTexture(target, texture);
  if (target === gl.TEXTURE_3D) {
    gl.texImage3D(target, 0, gl.RGBA8, 1, 1, 1, 0, gl.RGBA, gl.UNSIGNED_BYTE, black);
  } else if (target === gl.TEXTURE_CUBE_MAP) {
    for (let face = 0; face < 6; face++) {
      const side = gl.TEXTURE_CUBE_MAP_POSITIVE_X + face;
      gl.texImage2D(side, 0, gl.RGBA8, 1, 1, 0, gl.RGBA, gl.UNSIGNED_BYTE, black);
    }
  } else {
    gl.texImage2D(target, 0, gl.RGBA8, 1, 1, 0, gl.RGBA, gl.UNSIGNED_BYTE, black);
  }
  gl.texParameteri(target, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
  gl.texParameteri(target, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
  return texture;
}

/** Telephones and tablets, which shaders may ask after. */
const isWeakDevice = /Android|iPhone|iPad|Mobile/.test(globalThis.navigator?.userAgent ?? '');

/** The text of a pass as it is compiled. @param {ProjectData} project @param {PassData} pass */
function passSource(project, pass) {
  const files = pass.files.map((f) => project.files[f]);
  return files.map((file, i) => joined(file, i === files.length - 1)).join('');
}

/**
 * A text as it is compiled: behind every text of the user but the last comes a line break.
 * @param {{text: string, hidden: boolean}} file
 * @param {boolean} isLast
 */
function joined(file, isLast) {
  if (file.hidden && isWeakDevice) return file.text.replace('HW_PERFORMANCE 1', 'HW_PERFORMANCE 0');
  return file.hidden || isLast ? file.text : `${file.text}\n`;
}
