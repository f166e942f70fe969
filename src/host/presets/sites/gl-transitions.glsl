// GL Transitions
//
// A transition between two images is a shader fragment, GLSL ES 1.00, without main(). It defines
// `vec4 transition(vec2 uv)`, with uv from 0 to 1 and y up, which returns the colour of a pixel. The
// host inserts the declarations below before it and appends main().
//
// `progress` goes from 0 to 1, and `ratio` is the width divided by the height of the canvas. The
// parameters of a transition are uniforms that it declares itself, with a default value in a
// comment: `uniform float size; // = 0.1`.
//
// source: gl-transition 1.13.0, src/index.js; gl-transitions 1.71.0, README.md
// package: gl-transition gl-transitions
// word: getFromColor getToColor
// version: 100
// names: all
// entry: transition
// composes: yes
#ifdef FRAGMENT_SHADER
#if __VERSION__ == 300
#define texture2D texture
#endif
precision highp float;
varying vec2 _uv; // = port_place
uniform sampler2D from; // = file
uniform sampler2D to; // = screen
uniform float progress; // = progress
uniform float ratio; // = aspect
uniform float _fromR; // = aspect
uniform float _toR; // = aspect
vec4 getFromColor(vec2 uv) { return texture2D(from, uv); }
vec4 getToColor(vec2 uv) { return texture2D(to, uv); }
#endif
#ifdef SHADER_MAIN
void main() {
    gl_FragColor = transition(_uv);
}
#endif
