// GLSL Sandbox
//
// glslsandbox.com, formerly glsl.heroku.com, compiles a shader unchanged, as GLSL ES 1.00 with
// derivatives.
//
// The mouse ranges from 0 to 1, y up, and starts in the centre. `surfacePosition` is a position on
// a surface of height 1 with its centre at (0, 0). `backbuffer` is the previous frame, in bytes.
//
// source: static/index.html of mrdoob/glsl-sandbox
// version: 100
// context: webgl1 OES_standard_derivatives
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
