// The declarations of `shaderlint types` in projects: what compiles, what does not, and what it sets in the browser.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { folder, listen, program, put, run, top } from './browser.js';

const packages = path.join(top, 'tests/browser/node_modules');

const VERTEX = `#version 300 es
in vec3 position;
layout(location = 2) in vec2 uv;
struct Lamp { vec3 color; float weights[2]; mat2 turn; };
uniform mat4 uView;
uniform mat2x3 uShear;
uniform float uTime; // seconds
uniform int uCounts[3];
uniform bvec2 uFlags;
uniform vec2 uPoints[2];
uniform Lamp uLamps[2];
uniform Scene {
    mat3 turn;
    float steps[3];
    Lamp lamps[2];
    ivec2 cell;
    uint count;
    bool on;
    layout(row_major) mat2x3 shear;
    vec3 last;
} scene;
uniform Fog { vec2 range; float amount; };
out vec2 vUv;
flat out int vCount;
void main() {
    vUv = uv;
    vCount = uCounts[2] + scene.cell.x + int(scene.count) + int(scene.on) + int(uFlags.x);
    vec3 p = position * scene.turn[1] * scene.lamps[1].color * uLamps[0].color * uShear[1] * scene.last;
    float k = scene.steps[1] + scene.lamps[0].weights[1] + scene.shear[1].x + uPoints[1].x + uTime;
    k += range.x * amount + scene.lamps[1].turn[1].y + uLamps[1].turn[0].x + uLamps[1].weights[1];
    gl_Position = uView * vec4(p, k);
}
`;
const FRAGMENT = `#version 300 es
precision highp float;
in vec2 vUv;
uniform vec3 uColor;
uniform sampler2D uMap;
#ifdef FOG
uniform vec3 uFog;
#endif
out vec4 color;
void main() {
    color = texture(uMap, vUv.xy) * vec4(uColor, 1.0);
}
`;
const MAIN = `import vertex from "./a.vert";
import fragment from "./a.frag";
import type { Shader } from "./a.vert";
import { createProgram, setUniforms, writeBlock, type Program } from "../gl";

export function start(gl: WebGL2RenderingContext): WebGLProgram {
  const program: Program<typeof vertex, typeof fragment> = createProgram(gl, vertex, fragment);
  gl.useProgram(program);
  setUniforms(gl, program, { uTime: 1, uColor: [1, 0, 0], uMap: 0, uCounts: [1, 2, 3], uFlags: [true, false] });
  setUniforms(gl, program, { uView: new Float32Array(16), uPoints: [[1, 2], [3, 4]], uFog: [0, 0, 0] });
  const fog = writeBlock(gl, program, "Fog", { range: [1, 2], amount: 3 });
  gl.bufferData(gl.UNIFORM_BUFFER, fog, gl.DYNAMIC_DRAW);
  const at: Shader["layouts"]["Fog"]["offsets"]["amount"] = 8;
  const size: Shader["attributes"]["position"]["size"] = 3;
  gl.vertexAttribPointer(0, size, gl.FLOAT, false, at, 0);
  return program;
}
`;
/** Changes of the program, or of a shader, and a part of the message. */
const MISTAKES = [
  ['main.ts', 'uTime: 1', 'uTimee: 1', "'uTimee' does not exist"],
  ['main.ts', 'uColor: [1, 0, 0]', 'uColor: [1, 0]', 'readonly [number, number, number]'],
  ['main.ts', 'uCounts: [1, 2, 3]', 'uCounts: [1, 2]', 'number, number, number'],
  ['main.ts', 'uFlags: [true, false]', 'uFlags: [1, 0]', "'number' is not assignable to type 'boolean'"],
  ['main.ts', '"Fog"', '"Frog"', '"Frog"'],
  ['main.ts', 'amount: 3 }', 'amounts: 3 }', "'amounts' does not exist"],
  ['main.ts', '"amount"] = 8', '"amount"] = 4', "'4' is not assignable to type '8'"],
  ['a.frag', 'in vec2 vUv', 'in vec3 vUv', 'the stages declare the varying vUv differently'],
  ['a.frag', 'vUv', 'vUV', 'the vertex shader has no output vUV'],
  ['a.frag', 'uniform vec3 uColor', 'uniform vec2 uTime; uniform vec3 uColor', 'the stages declare the uniform uTime differently'],
  ['a.frag', 'uniform vec3 uColor', 'uniform Fog { vec3 range; }; uniform vec3 uColor', 'the stages declare the block Fog differently'],
  ['main.ts', 'import fragment from "./a.frag"', 'import fragment from "./a.vert"', 'the second shader is no fragment shader'],
];

/** `skipLibCheck` is off: the declarations are checked too. */
const CONFIG = {
  compilerOptions: {
    strict: true, skipLibCheck: false, noUncheckedIndexedAccess: true, exactOptionalPropertyTypes: true, noUnusedLocals: true,
    noUnusedParameters: true, verbatimModuleSyntax: true, isolatedModules: true, target: 'ES2022', module: 'ESNext',
    moduleResolution: 'Bundler', lib: ['ES2022', 'DOM'], types: [], outDir: 'out', noEmitOnError: true,
  },
  include: ['**/*.ts'],
};

/** Writes a part of a project; `edit` is a file of it, a text there and its replacement. */
function part(name, files, [edited, old, text] = []) {
  for (const [file, content] of Object.entries(files)) {
    const changed = file === edited ? content.replaceAll(old, text) : content;
    assert.ok(file !== edited || changed !== content, `${edited} has ${old}`);
    put(`${name}/${file}`, changed);
  }
}

/** Writes a project with these files, and with each of some mistakes; resolves to the errors of the compiler. */
async function errors(files, mistakes, ...args) {
  put('package.json', '{ "dependencies": { "three": "0.187.0" } }');
  put('tsconfig.json', JSON.stringify(CONFIG));
  fs.symlinkSync(packages, path.join(folder(), 'node_modules'));
  part('good', files);
  mistakes.forEach((mistake, number) => part(`mistake${number}`, files, mistake));
  await types(...args);
  const { stdout } = await run(path.join(packages, '.bin/tsc'), '-p', folder());
  return stdout;
}

/** Each mistake is an error, and nothing else is. */
function found(mistakes, text) {
  const messages = text.split(/^(?=\S)/m);
  const others = messages.filter((message) => !message.startsWith('mistake'));
  assert.equal(others.join(''), '');
  mistakes.forEach((mistake, number) => {
    const own = messages.filter((message) => message.startsWith(`mistake${number}/`)).join('');
    assert.ok(own.includes(mistake[3]), `${mistake.join(' | ')}\n${own}`);
  });
}

const types = (...args) => run(program('shaderlint'), 'types', folder(), ...args);

/** The module with the functions. */
const helpers = () => path.join(folder(), 'gl.ts');
const PROJECT = { 'a.vert': VERTEX, 'a.frag': FRAGMENT, 'main.ts': MAIN };

async function projects() {
  found(MISTAKES, await errors(PROJECT, MISTAKES, '--helpers', helpers()));
}

async function oneModule() {
  const main = MAIN.slice(MAIN.indexOf('import { createProgram'))
    .replace('type Program', 'type Program, type Shaders')
    .replace('export', 'declare const vertex: Shaders["./good/a.vert"];\ndeclare const fragment: Shaders["./good/a.frag"];\nexport')
    .replaceAll('Shader["', 'NonNullable<typeof vertex["~shader"]>["');
  assert.equal(await errors({ ...PROJECT, 'main.ts': main }, [], '--module', helpers()), '');
  assert.deepEqual(fs.readdirSync(path.join(folder(), 'good')), ['a.frag', 'a.vert', 'main.ts']);
}

const THREE_VERTEX = `uniform float uTime;
uniform vec2 uFrequency;
varying vec2 vUv;
void main() {
    vUv = uv;
    gl_Position = projectionMatrix * modelViewMatrix * vec4(position + sin(uv.x * uFrequency.x + uTime), 1.0);
}
`;
const THREE_FRAGMENT = `#include <common>
struct Lamp { vec3 direction; float power; };
uniform vec3 uColor;
uniform sampler2D uMap;
uniform samplerCube uSky;
uniform vec3 uPoints[20];
uniform Lamp uLamps[2];
varying vec2 vUv;
void main() {
    vec3 light = uPoints[1] * uLamps[0].power + textureCube(uSky, vec3(1.0)).rgb;
    gl_FragColor = vec4(uColor * texture2D(uMap, vUv).rgb + light, 1.0);
    #include <colorspace_fragment>
}
`;
const THREE_MAIN = `import { Color, CubeTexture, Mesh, PlaneGeometry, Texture, Vector2, Vector3 } from "three";
import vertexShader from "./a.vert";
import fragmentShader from "./a.frag";
import { shaderMaterial } from "../gl";

const lamp = { direction: new Vector3(), power: 1 };
const material = shaderMaterial({
  vertexShader,
  fragmentShader,
  transparent: true,
  uniforms: {
    uTime: { value: 0 },
    uFrequency: { value: new Vector2() },
    uColor: { value: new Color("red") },
    uMap: { value: new Texture() },
    uSky: { value: new CubeTexture() },
    uPoints: { value: Array.from({ length: 20 }, () => new Vector3()) },
    uLamps: { value: [lamp, lamp] },
  },
});
material.uniforms.uTime.value += 1;
export const mesh = new Mesh(new PlaneGeometry(), material);
`;
const THREE_MISTAKES = [
  ['main.ts', 'uTime.value +=', 'uTimee.value +=', "'uTimee' does not exist"],
  ['main.ts', 'new Color("red")', 'new Vector2()', "'Vector2' is not assignable to type 'Color | Vector3'"],
  ['main.ts', '    uMap: { value: new Texture() },\n', '', "'uMap' is missing"],
  ['main.ts', 'uTime: { value: 0 }', 'uTime: 0', "'number' is not assignable to type '{ value: number; }'"],
];

async function materials() {
  const files = { 'a.vert': THREE_VERTEX, 'a.frag': THREE_FRAGMENT, 'main.ts': THREE_MAIN };
  found(THREE_MISTAKES, await errors(files, THREE_MISTAKES, '--uniforms', 'three', '--helpers', helpers()));
}

/** Values that are set arrive, and members of blocks are where the declaration says. */
async function values(context) {
  assert.equal(await errors(PROJECT, [], '--helpers', helpers()), '');
  const code = fs.readFileSync(path.join(folder(), 'out/gl.js'), 'utf8');
  const { stdout } = await run(program('shaderlint'), 'reflect', path.join(folder(), 'good/a.vert'));
  const [scene, fog] = JSON.parse(stdout).shaders[0].blocks;
  const page = await context.newPage();
  listen(page);
  const seen = await page.evaluate(async ([text, vertex, fragment]) => {
    const gl = document.createElement('canvas').getContext('webgl2');
    const { createProgram, setUniforms, writeBlock } = await import(`data:text/javascript,${encodeURIComponent(text)}`);
    const linked = createProgram(gl, vertex, fragment);
    gl.useProgram(linked);
    const lamp = (k) => ({ color: [k, k + 1, k + 2], weights: [k + 3, k + 4], turn: new Float32Array([k + 5, k + 6, k + 7, k + 8]) });
    const lamps = [lamp(10), lamp(20)];
    setUniforms(gl, linked, { uShear: [1, 2, 3, 4, 5, 6], uTime: 2.5, uCounts: new Int32Array([7, 8, 9]), uFlags: [true, false] });
    setUniforms(gl, linked, { uPoints: [[1, 2], new Float32Array([3, 4])], uLamps: lamps, uColor: [1, 2, 3], uFog: [1, 1, 1] });
    const value = (name) => [gl.getUniform(linked, gl.getUniformLocation(linked, name))].flatMap((v) => (v.length ? [...v] : [v]));
    const names = ['uShear', 'uTime', 'uCounts[2]', 'uFlags', 'uPoints[1]', 'uLamps[0].color', 'uLamps[1].weights[1]', 'uLamps[1].turn', 'uColor'];
    const bytes = (buffer) => [...new Uint8Array(buffer)];
    return {
      uniforms: Object.fromEntries(names.map((name) => [name, value(name)])),
      scene: bytes(writeBlock(gl, linked, 'Scene', {
        turn: [1, 2, 3, 4, 5, 6, 7, 8, 9], steps: [1, 2, 3], lamps, cell: [-5, 6], count: 4000000000, on: true, shear: [1, 2, 3, 4, 5, 6], last: [7, 8, 9],
      })),
      fog: bytes(writeBlock(gl, linked, 'Fog', { range: [1, 2], amount: 3 })),
      error: gl.getError(),
    };
  }, [code, VERTEX, FRAGMENT]);
  assert.deepEqual(seen.uniforms, {
    uShear: [1, 2, 3, 4, 5, 6], uTime: [2.5], 'uCounts[2]': [9], uFlags: [true, false], 'uPoints[1]': [3, 4], 'uLamps[0].color': [10, 11, 12],
    'uLamps[1].weights[1]': [24], 'uLamps[1].turn': [25, 26, 27, 28], uColor: [1, 2, 3],
  });
  assert.equal(seen.error, 0);
  assert.equal(seen.scene.length, scene.size);
  assert.equal(seen.fog.length, fog.size);
  const read = (block, bytes, name) => {
    const { type, offset, size, stride = 0, array = 1 } = block.members.find((m) => m.name === name);
    const Words = { f: Float32Array, v: Float32Array, m: Float32Array, i: Int32Array, u: Uint32Array, b: Uint32Array }[type[0]];
    const length = array > 1 ? (array - 1) * stride + 4 : size;
    return [...new Words(Uint8Array.from(bytes.slice(offset, offset + length)).buffer)];
  };
  const placed = Object.fromEntries(scene.members.map((m) => [m.name, read(scene, seen.scene, m.name)]));
  assert.deepEqual(placed, {
    'Scene.turn': [1, 2, 3, 0, 4, 5, 6, 0, 7, 8, 9, 0], 'Scene.steps[0]': [1, 0, 0, 0, 2, 0, 0, 0, 3],
    'Scene.lamps[0].color': [10, 11, 12], 'Scene.lamps[0].weights[0]': [13, 0, 0, 0, 14], 'Scene.lamps[0].turn': [15, 16, 0, 0, 17, 18, 0, 0],
    'Scene.lamps[1].color': [20, 21, 22], 'Scene.lamps[1].weights[0]': [23, 0, 0, 0, 24], 'Scene.lamps[1].turn': [25, 26, 0, 0, 27, 28, 0, 0],
    'Scene.cell': [-5, 6], 'Scene.count': [4000000000], 'Scene.on': [1], 'Scene.shear': [1, 4, 0, 0, 2, 5, 0, 0, 3, 6, 0, 0], 'Scene.last': [7, 8, 9],
  });
  assert.deepEqual([read(fog, seen.fog, 'range'), read(fog, seen.fog, 'amount')], [[1, 2], [3]]);
}

export const typeTests = [
  { name: 'declarations of shaders: projects compile, mistakes do not', run: projects },
  { name: 'declarations of shaders: one module', run: oneModule },
  { name: 'declarations of shaders: materials of three.js', run: materials },
  { name: 'declarations of shaders: values in the browser', run: values },
];
