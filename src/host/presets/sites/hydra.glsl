// Hydra
//
// Hydra generates the fragment shader, GLSL ES 1.00, from chained functions. Users pass only
// function bodies to setFunction(): the field `glsl` is the body of a function whose signature is
// generated from `type` and `inputs`, so it returns a value.
//
// A body can use `vec2 _st` (types src, coord and combineCoord) or `vec4 _c0` (color, combine),
// `vec4 _c1` (combine) or `_c0` (combineCoord), and the inputs by name, which are not declared
// here. It returns a vec4, or a vec2 for the types coord and combineCoord. The three parameters are
// declared below as variables.
//
// Functions of other transforms (osc, noise, shape) are in the shader only if the same chain uses
// them.
//
// source: hydra-synth 1.4.0, src/generator-factory.js, src/glsl-source.js, src/glsl/utility-functions.js
// package: hydra-synth
// word: _c0 _c1 _rgbToHsv _hsvToRgb
// version: 100
// names: some
// entry: main
precision mediump float;
varying vec2 uv;
#ifdef FRAGMENT_SHADER
uniform float time;
uniform vec2 resolution;
uniform sampler2D prevBuffer;
float _luminance(vec3 rgb);
vec4 permute(vec4 x);
vec4 taylorInvSqrt(vec4 r);
float _noise(vec3 v);
vec3 _rgbToHsv(vec3 c);
vec3 _hsvToRgb(vec3 c);
// parameters of the user's function
vec2 _st;
vec4 _c0;
vec4 _c1;
#endif
#ifdef VERTEX_SHADER
attribute vec2 position;
#endif
