// GlslCanvas
//
// The host of The Book of Shaders puts one macro before a fragment shader and compiles it as GLSL
// ES 1.00. No uniforms are declared: the text declares those that it uses, under these names, which
// the host then sets: `vec2 u_resolution`, `float u_time`, `float u_delta`, `vec2 u_mouse`, `vec4
// u_date`, `sampler2D u_tex0` and so on, `sampler2D u_buffer0` and so on, and `varying vec2
// v_texcoord` (in a vertex shader `attribute vec2 a_position` and `a_texcoord`). The precision of
// float is not added. A line `#include "lygia/..."` is replaced by the file of that name from
// lygia.xyz; with macros such as `BUFFER_0` before it, the same text is compiled once more for each
// `#ifdef BUFFER_0` or `defined(BUFFER_0)` in it. Such a macro is not defined in the main pass.
//
// source: glslCanvas 0.2.6, src/GlslCanvas.js
// package: glslCanvas
// word: PLATFORM_WEBGL
// version: 100
// names: all
// entry: main
// include: "..."
#ifdef FRAGMENT_SHADER
#define PLATFORM_WEBGL
#endif
