// twigl
//
// twigl.app runs very short shaders, in modes that each allow a shader to omit more. `classic` is
// like GLSL Sandbox. `geek` names the uniforms `r`, `m`, `t`, `f`, `s` and `b`. `geeker` declares
// them. `geekest` adds `FC` for `gl_FragCoord`, noise and rotations, and makes `main` optional.
//
// GLSL ES 3.00 modes write to `o`. Modes with several targets write to `o0` and `o1`, of which the
// first is shown; `b0` and `b1` are the targets of the previous frame. Frames are counted from 1;
// the mouse starts in the corner.
//
// `s`, and `sound` in `classic`, is the loudness of the sound shader that twigl plays beside the
// image: 0 without one. `shaderport` has no sound shader and sets it by a made-up beat.
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
