// Passes in three.js: shaders, uniforms, materials and objects.

import {
  Box2, BufferAttribute, BufferGeometry, ByteType, Camera, ClampToEdgeWrapping, Color, CustomBlending, DataTexture,
  DoubleSide, FloatType, GLSL3, LessDepth, Line, LinearFilter, LinearMipmapLinearFilter, LineLoop, LineSegments, Mesh,
  NearestFilter, NoBlending, OneFactor, OneMinusSrcAlphaFactor, Points, RawShaderMaterial, RedFormat, RepeatWrapping,
  RGBAFormat, RGBAIntegerFormat, Scene, UnsignedByteType, Vector2, Vector3, Vector4, WebGL3DRenderTarget,
  WebGLCubeRenderTarget, WebGLRenderTarget,
} from 'three';

const VERTEX = `in vec3 position;
void main() {
  gl_Position = vec4(position.xy, 0.0, 1.0);
}
`;

/** Macros that three.js itself defines, or replaces by numbers. */
const OWN_NAMES = /^#define (SHADER_TYPE|SHADER_NAME|NUM_[A-Z_]+|UNION_CLIPPING_PLANES|UNROLLED_LOOP_INDEX)\b.*$/gm;

/** The source of a pass. */
function textOf(pass) {
  const files = pass.files.map((f) => PROJECT.files[f]);
  const textIn = (file, i) => {
    if (file.hidden) return file.text.replace(OWN_NAMES, '');
    return i < files.length - 1 ? `${file.text}\n` : file.text;
  };
  return files.map(textIn).join('');
}

/** The `#version` line of a shader, which only comments may precede: three.js adds its own. */
const VERSION = /^((?:\s|\/\/.*|\/\*[^]*?\*\/)*)#[ \t]*version[ \t]+(?:100|(300[ \t]+es))\b/;

/** The shaders of a pass without their `#version`, and the version of the fragment shader for three.js. */
function shadersOf(pass) {
  const own = textOf(pass);
  const bare = (text) => text.replace(VERSION, '$1').replace(/\bport_pos\b/g, 'position');
  return {
    glslVersion: VERSION.exec(own)?.[2] ? GLSL3 : null,
    vertexShader: pass.fragment ? bare(own) : pass.vertex ? bare(pass.vertex) : VERTEX,
    fragmentShader: bare(pass.fragment ?? own),
  };
}

/** The texture of an empty channel; three.js has defaults for less common samplers, except integer ones. */
function emptyTexture(input) {
  const [, sign] = /^([iu])sampler2D$/.exec(input?.sampler ?? '') ?? [];
  if (!sign && (input?.sampler || ['cubemap', 'volume'].includes(input?.kind))) return null;
  let texture = new DataTexture(new Uint8Array([0, 0, 0, 255]), 1, 1);
  if (sign === 'u') texture = new DataTexture(new Uint8Array(4), 1, 1, RGBAIntegerFormat, UnsignedByteType);
  if (sign === 'i') texture = new DataTexture(new Int8Array(4), 1, 1, RGBAIntegerFormat, ByteType);
  texture.needsUpdate = true;
  return texture;
}

/** The value of a uniform as a three.js type. */
function valueOf(numbers, isColor) {
  if (numbers.length === 1) return numbers[0];
  if (isColor && numbers.length === 3) return new Color(...numbers);
  const Vector = [Vector2, Vector3, Vector4][numbers.length - 2];
  return new Vector(...numbers);
}

/** The uniforms set by the user, shared by all passes. Two of them only control how vertices are drawn. */
function userUniforms() {
  const controls = PROJECT.controls.filter((c) => c.name !== 'port_mode');
  const entry = ({ name, kind, value }) => [name, { value: kind === 'bool' && value.length === 1 ? value[0] !== 0 : valueOf(value, kind === 'color') }];
  return Object.fromEntries(controls.map(entry));
}

/** The uniforms of a pass that declares its own; most are set for each frame. */
function ownUniforms(pass, users) {
  const uniforms = { port_size: { value: new Vector2(1, 1) } };
  for (const { name, type, source } of pass.uniforms) {
    const isMatrix = source === 'identity';
    const first = () => (isMatrix ? identityOf(type) : valueOf(lanesOf(SETTERS[type]?.[1] ?? 1, [])));
    uniforms[name] = (source === 'control' && users[name]) || { value: first() };
  }
  return uniforms;
}

/** The uniforms of ShaderToy's player. */
function playerUniforms() {
  return {
    iResolution: { value: new Vector3(1, 1, 1) },
    iTime: { value: 0 },
    iTimeDelta: { value: 1 / 60 },
    iFrameRate: { value: 60 },
    iFrame: { value: 0 },
    iMouse: { value: new Vector4() },
    iDate: { value: new Vector4() },
    iSampleRate: { value: 44100 },
  };
}

/** The sampler of a channel, and the index in it if it is an array. */
function samplerOf(pass, channel) {
  const name = pass.inputs[channel]?.uniform ?? `iChannel${channel}`;
  const [word, index] = name.split(/[[\]]/);
  return { word, index };
}

/** Sets the texture of a channel. */
function setTexture({ uniforms }, pass, channel, texture) {
  const { word, index } = samplerOf(pass, channel);
  if (index === undefined) uniforms[word] = Object.assign(uniforms[word] ?? {}, { value: texture });
  else (uniforms[word] ??= { value: [] }).value[index] = texture;
}

function materialOf(pass, users) {
  const count = Math.max(4, pass.inputs.length);
  const all = Array.from({ length: count }, (_, i) => i);
  const uniforms = {
    ...(pass.uniforms ? ownUniforms(pass, users) : playerUniforms()),
    iChannelTime: { value: all.map(() => 0) },
    iChannelResolution: { value: all.map(() => new Vector3()) },
  };
  for (const channel of all) setTexture({ uniforms }, pass, channel, emptyTexture(pass.inputs[channel]));
  const over = { blending: CustomBlending, blendSrc: OneFactor, blendDst: OneMinusSrcAlphaFactor };
  const vertices = { ...over, transparent: true, side: DoubleSide, depthFunc: LessDepth };
  const picture = { blending: NoBlending, depthTest: false, depthWrite: false };
  return new RawShaderMaterial({ ...shadersOf(pass), uniforms, ...(pass.fragment ? vertices : picture) });
}

/** Sets the uniforms of a pass that declares its own, for a frame. */
function setOwnUniforms({ uniforms }, pass, frame, width, height) {
  uniforms.port_size.value.set(width, height);
  for (const { name, type, source } of pass.uniforms) {
    if (!SOURCES[source] || !SETTERS[type]) continue;
    uniforms[name].value = valueOf(lanesOf(SETTERS[type][1], SOURCES[source](frame, width, height)), false);
  }
}

/** Object classes for numbered vertices, by WebGL primitive type. */
const VERTEX_OBJECTS = [Points, LineSegments, LineLoop, Line, Mesh, Mesh, Mesh];

/** Indexes for the triangles of a strip (5) or a fan (6). */
function triangleIndex(mode, count) {
  const index = [];
  for (let i = 0; i + 2 < count; i++) {
    if (mode === 6) index.push(0, i + 1, i + 2);
    else index.push(i, ...(i % 2 ? [i + 2, i + 1] : [i + 1, i + 2]));
  }
  return index;
}

/** A geometry of triangles with these corners. */
function flatGeometry(corners) {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(new Float32Array(corners.flatMap((c) => [...c, 0])), 3));
  return geometry;
}

/** The object that draws the image with a material: a full-screen cover, or the vertices of the shader. */
function objectOf(pass, material, cover) {
  const value = (name) => PROJECT.controls.find((c) => c.name === name)?.value[0];
  const mode = value('port_mode') ?? 1;
  let geometry = cover;
  if (pass.fragment) {
    const count = Math.max(0, Math.floor(value('vertexCount') ?? 0));
    geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(new Float32Array(3 * count), 3));
    geometry.setAttribute('vertexId', new BufferAttribute(Float32Array.from({ length: count }, (_, i) => i), 1));
    if (mode > 4) geometry.setIndex(triangleIndex(mode, count));
  }
  const object = new (pass.fragment ? VERTEX_OBJECTS[mode] : Mesh)(geometry, material);
  object.frustumCulled = false;
  return object;
}
