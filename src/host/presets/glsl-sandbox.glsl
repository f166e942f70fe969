// GLSL Sandbox
//
// glslsandbox.com, once glsl.heroku.com, compiles a text as it is written, as GLSL ES 1.00 with
// derivatives. The mouse goes from 0 to 1 from below and is in the middle at first.
// `surfacePosition` is a position on a surface whose height is 1, with the middle at (0, 0).
// `backbuffer` is the last frame, in bytes.
//
// source: static/index.html of mrdoob/glsl-sandbox
// version: 100
// names: some
// entry: main
#ifdef SHADER_DECLARES
uniform float time; // = time, usual
uniform vec2 mouse; // = pointer-unit, usual
uniform vec2 resolution; // = resolution, usual
uniform vec2 surfaceSize; // = surface-size, own
uniform sampler2D backbuffer; // = last-frame, nearest, usual
uniform sampler2D bb; // = last-frame, nearest, usual
varying vec2 surfacePosition; // = 0.5 * port_pos * vec2(port_size.x / port_size.y, 1.0), own
#endif
