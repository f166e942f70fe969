// Syntax highlighting: the scopes of words in GLSL and in other languages that contain it, with the
// grammars of VS Code.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import { createRequire } from 'node:module';
import { test } from 'node:test';
import oniguruma from 'vscode-oniguruma';
import textmate from 'vscode-textmate';

const require = createRequire(import.meta.url);
const syntaxes = new URL('../../editors/vscode/syntaxes/', import.meta.url);
const INJECTION = 'shaderlint.embedded.glsl';

/** Grammars by scope name. */
const files = new Map([
  ['source.glsl', new URL('glsl.tmLanguage.json', syntaxes)],
  [INJECTION, new URL('embedded.tmLanguage.json', syntaxes)],
]);
const packaged = new URL('node_modules/tm-grammars/grammars/', import.meta.url);
for (const name of fs.readdirSync(packaged)) {
  const { scopeName } = JSON.parse(fs.readFileSync(new URL(name, packaged), 'utf8'));
  // One of them is also for GLSL.
  if (!files.has(scopeName)) files.set(scopeName, new URL(name, packaged));
}

await oniguruma.loadWASM(fs.readFileSync(require.resolve('vscode-oniguruma/release/onig.wasm')).buffer);
const registry = new textmate.Registry({
  onigLib: Promise.resolve({
    createOnigScanner: (patterns) => new oniguruma.OnigScanner(patterns),
    createOnigString: (text) => new oniguruma.OnigString(text),
  }),
  loadGrammar: (scope) => {
    const file = files.get(scope);
    return Promise.resolve(file ? textmate.parseRawGrammar(fs.readFileSync(file, 'utf8'), 'x.json') : null);
  },
  getInjections: (scope) => (scope === INJECTION || scope === 'source.glsl' ? [] : [INJECTION]),
});

/** All tokens of a text with their scopes. */
async function tokens(scope, text) {
  const grammar = await registry.loadGrammar(scope);
  let state = textmate.INITIAL;
  return text.split('\n').flatMap((line, number) => {
    const told = grammar.tokenizeLine(line, state);
    state = told.ruleStack;
    return told.tokens.map((t) => ({ line: number + 1, word: line.slice(t.startIndex, t.endIndex), scopes: t.scopes }));
  });
}

const SHADER = `#version 300 es
precision highp float;
#define SPEED 2.0 // how fast (0~4)
#define TWICE(a) \\
  ((a) * 2.0)
#if defined(GL_ES) && SPEED > 1
#extension GL_OES_standard_derivatives : enable
#endif
layout(location = 0) out vec4 fragColor;
uniform sampler2D tex; /* two
lines */ uniform uvec2 size;
struct Ray { vec3 origin; };
// shaderlint: allow(tidy)
float wave(in vec2 p) { return sin(p.x * 0x1Fu + 1e-3 + .5); }
void mainImage(out vec4 color, in vec2 at) {
  color = texture(tex, at / iResolution.xy).rgba;
  color.xyz += wave(at) + gl_FragCoord.x;
  for (int i = 0; i < 3; ++i) { if (i == 2) discard; }
  Ray ray = Ray(vec3(1.0)); ray.origin.x = 1.; double bad;
}`;

// Each case: the scope of the language, the text, and words with their expected scopes; a word may be
// followed by its line number.
const CASES = [
  ['source.glsl', SHADER, [
    ['version', 'keyword.control.directive.version'], ['300', 'constant.numeric'], ['es', 'storage.modifier.profile'],
    ['highp', 'storage.modifier.precision'], ['SPEED', 'entity.name.function.preprocessor'],
    ['2.0', 'constant.numeric.float'], [' how fast (0~4)', 'comment.line'],
    ['TWICE', 'entity.name.function.preprocessor'], ['a', 'variable.parameter.preprocessor'],
    ['2.0@5', 'meta.preprocessor.macro'], ['defined', 'keyword.operator.defined'], ['endif', 'keyword.control.directive'],
    ['GL_OES_standard_derivatives', 'entity.name.extension'], ['enable', 'keyword.other.behavior'],
    ['layout', 'storage.modifier.layout'], ['location', 'storage.modifier.layout'], ['out', 'storage.modifier'],
    ['vec4', 'storage.type'], ['sampler2D', 'storage.type'], ['lines ', 'comment.block'], ['uniform@11', 'storage.modifier'],
    ['uvec2', 'storage.type'], ['Ray', 'entity.name.type.struct'], ['allow', 'keyword.other.suppression'],
    ['float@14', 'storage.type'], ['wave@14', 'entity.name.function'], ['in@14', 'storage.modifier'],
    ['return', 'keyword.control.flow'], ['sin', 'support.function.math'], ['x@14', 'variable.other.property.swizzle'],
    ['0x1Fu', 'constant.numeric.hex'], ['1e-3', 'constant.numeric.float'], ['.5', 'constant.numeric.float'],
    ['mainImage', 'entity.name.function.entry'], ['texture', 'support.function.texture'],
    ['iResolution', 'support.variable.shadertoy'], ['rgba', 'variable.other.property.swizzle'],
    ['+=', 'keyword.operator.assignment'], ['wave@17', 'entity.name.function.call'], ['gl_FragCoord', 'support.variable'],
    ['for', 'keyword.control'], ['++', 'keyword.operator.increment'], ['==', 'keyword.operator.comparison'],
    ['discard', 'keyword.control.flow'], ['origin@19', 'variable.other.property'], ['1.', 'constant.numeric.float'],
    ['double', 'invalid.illegal'],
  ]],
  ['source.js', 'const a = /* glsl */ `\nvoid main() { // ${b.c} `;\nlet d = vec3(1);', [
    ['void', 'storage.type.glsl'], ['void', 'meta.embedded.block.glsl'], ['b', 'meta.template.expression'],
    ['let', 'storage.type.js'], ['vec3', 'entity.name.function.js'],
  ]],
  ['source.ts', 'const a: string = glsl`vec2 p = ${x}.xy;`; f(a);', [
    ['vec2', 'storage.type.glsl'], ['xy', 'variable.other.property.swizzle.glsl'], ['f', 'entity.name.function.ts'],
  ]],
  ['source.js', 'gl.f(`#version 300 es\nin vec2 a;`);\nconst s = "glsl`vec2`"; // glsl`vec2`', [
    ['version', 'keyword.control.directive.version.glsl'], ['in', 'storage.modifier.glsl'],
    ['glsl`vec2`', 'string.quoted.double.js'], [' glsl`vec2`', 'comment.line'],
  ]],
  ['text.html.basic', '<script id="a" type="x-shader/x-fragment">\nuniform vec2 a; // end</script>\n<script>let b;</script>', [
    ['uniform', 'storage.modifier.glsl'], ['type', 'entity.other.attribute-name'], ['script', 'entity.name.tag'],
    ['let', 'storage.type.js'],
  ]],
  ['text.html.vue', '<script>\nconst a = glsl`uniform vec2 a;`;\n</script>\n<template><p/></template>', [
    ['uniform', 'storage.modifier.glsl'], ['template', 'entity.name.tag'],
  ]],
  ['source.svelte', '<script lang="ts">\nconst a = /* glsl */`uniform vec2 a;`;\n</script>\n<p>x</p>', [
    ['uniform', 'storage.modifier.glsl'], ['p', 'entity.name.tag'],
  ]],
  ['source.astro', '---\nconst a = glsl`uniform vec2 a;`;\n---\n<p>x</p>', [['uniform', 'storage.modifier.glsl']]],
  ['text.html.markdown', 'Text.\n\n```glsl\nuniform vec2 a; // `b`\n```\n\n*vec2*', [
    ['uniform', 'storage.modifier.glsl'], ['vec2@7', 'markup.italic'],
  ]],
  ['text.html.markdown', '1. Text\n\n   ~~~frag title\n   uniform vec2 a;\n   ~~~\n\n*vec2*', [
    ['uniform', 'storage.modifier.glsl'], ['vec2@7', 'markup.italic'],
  ]],
];

/** Why a word does not have a scope; nothing if it has. */
function mistake(all, what, wanted) {
  const [word, line] = /^(.+?)(?:@(\d+))?$/s.exec(what).slice(1);
  const found = all.filter((t) => t.word === word && (!line || t.line === Number(line)));
  const holds = (token) => token.scopes.some((s) => s === wanted || s.startsWith(`${wanted}.`));
  // A word that is not a function name may precede one that is.
  if (line ? found.length > 0 && found.every(holds) : found.some(holds)) return [];
  return [`${what} is not ${wanted}: ${found.map((t) => t.scopes.join(' ')).join('\n    ') || 'no such token'}`];
}

for (const [scope, text, expected] of CASES) {
  test(`${scope}: ${expected[0][0]}`, async () => {
    const all = await tokens(scope, text);
    assert.deepEqual(expected.flatMap(([what, wanted]) => mistake(all, what, wanted)), []);
  });
}
