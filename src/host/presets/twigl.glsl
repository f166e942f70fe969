// twigl
//
// twigl.app runs shaders as short as a message, in modes of which each leaves more away: `classic`
// is like GLSL Sandbox; `geek` calls the uniforms `r`, `m`, `t`, `f`, `s` and `b`; `geeker` has
// them declared; `geekest` has `FC` for `gl_FragCoord`, noise and rotations, and may leave `main`
// away. Modes of GLSL ES 3.00 write to `o`, those with several targets to `o0` and `o1`, of which
// the first is shown; `b0` and `b1` are the targets a frame ago. The frame counts from 1; the mouse
// is in the corner at first.
//
// source: src/fragmen.js of doxas/twigl
// version: any
// names: some
// entry: main
// composes: yes
precision highp float;
#define FC gl_FragCoord
uniform vec2 r; // = resolution
uniform vec2 m; // = pointer-unit-zero
uniform float t; // = time
uniform float f; // = frame-from-one
uniform float s; // = volume
#ifdef SHADER_DECLARES
uniform sampler2D b; // = last-frame
uniform sampler2D b0; // = last-frame, numbered
uniform float frame; // = frame-from-one
uniform float sound; // = volume
uniform vec2 mouse; // = pointer-unit-zero
uniform sampler2D backbuffer; // = last-frame
uniform sampler2D backbuffer0; // = last-frame, numbered
#endif
