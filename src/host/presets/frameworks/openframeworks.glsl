// openFrameworks
//
// ofShader compiles a shader unchanged, with its own `#version` (120, 150 and up, or `300 es` and
// `100` on OpenGL ES), so the shader declares all names itself. Only `#pragma include "file"` lines
// are replaced by files. The library's own shaders start with the placeholders %glsl_version% and
// %extensions%.
//
// If the shader declares them, the programmable renderer sets the uniforms `mat4
// modelViewProjectionMatrix`, `modelViewMatrix`, `modelMatrix`, `viewMatrix`, `projectionMatrix`,
// `textureMatrix`, `vec4 globalColor`, `sampler2D` or `sampler2DRect tex0`, `src_tex_unit0`, `float
// usingTexture`, `usingColors`, and the attributes `vec4 position`, `vec4 color`, `vec3 normal` (or
// vec4), `vec2 texcoord`. Desktop OpenGL shaders often use sampler2DRect, which WebGL does not
// support.
//
// source: documentation of ofShader (no npm package); copies of ofShader.cpp (includes) and ofGLProgrammableRenderer.cpp (names) of openFrameworks
// version: own
// names: all
// entry: main
// include: "..."
// hole: %...%
