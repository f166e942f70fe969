// The Book of Shaders
//
// GlslCanvas, the host of The Book of Shaders, and related tools (glslViewer, the VS Code extension
// glsl-canvas) put one macro before a fragment shader and compile it as GLSL ES 1.00. No float
// precision is added.
//
// The host declares no uniforms. The shader declares the ones that it uses, with the names below,
// and the host sets them (in a vertex shader also `attribute vec2 a_position` and `a_texcoord`).
// The mouse is in pixels from the bottom left. A line `#include "lygia/..."` is replaced by that
// file from lygia.xyz.
//
// For each `#ifdef BUFFER_0` or `defined(BUFFER_0)`, the shader is compiled once more with that
// macro defined, and the result is available as `u_buffer0`. The macro is not defined in the main
// pass.
//
// alias: glslcanvas
// source: glslCanvas 0.2.6, src/GlslCanvas.js; the pages on uniforms and defines of the wiki of glslViewer
// package: glslCanvas
// word: PLATFORM_WEBGL
// shows: usual BUFFER_0
// version: 100
// takes: desktop
// names: all
// entry: main
// include: "..."
#ifdef FRAGMENT_SHADER
#define PLATFORM_WEBGL
#endif
#ifdef SHADER_DECLARES
uniform float u_time; // = time, usual
uniform vec2 u_resolution; // = resolution, usual
uniform vec2 u_mouse; // = pointer, usual
uniform float u_delta; // = delta, usual
uniform vec4 u_date; // = date, usual
uniform int u_frame; // = frame, or float, usual
uniform vec3 u_camera; // = camera, usual
uniform vec2 u_tex0Resolution; // = texture-size, numbered, usual
uniform vec2 u_trails[10]; // = nothing, usual
uniform sampler2D u_tex0; // = file, repeat, numbered, usual
uniform sampler2D u_texture_0; // = file, repeat, numbered, usual
uniform sampler2D u_buffer0; // = buffer, numbered, usual
uniform sampler2D u_doubleBuffer0; // = buffer, numbered, own
varying vec2 v_texcoord; // = port_place
varying vec4 v_position; // = vec4(port_pos, 0.0, 1.0)
#endif
