// Hydra
//
// Hydra writes the fragment shader itself, GLSL ES 1.00, from chained functions. Users give only
// the bodies of functions to setFunction(): the field `glsl` is the inside of a function whose head
// is made of `type` and `inputs`, so it returns a value. A body sees `vec2 _st` (types src, coord
// and combineCoord) or `vec4 _c0` (color, combine), `vec4 _c1` (combine) or `_c0` (combineCoord),
// and the inputs by their names, which are not declared here; it returns a vec4, for the types
// coord and combineCoord a vec2. The three parameters are written below as variables, all of them.
// Functions of other transforms (osc, noise, shape) are in the shader only where they are used in
// the same chain.
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
// parameters of the function whose body is written
vec2 _st;
vec4 _c0;
vec4 _c1;
#endif
#ifdef VERTEX_SHADER
attribute vec2 position;
#endif
