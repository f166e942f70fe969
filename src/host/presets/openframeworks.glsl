// openFrameworks
//
// ofShader compiles a text as it is written, with its own `#version` (120, 150 and up, or `300 es`
// and `100` on OpenGL ES), so the text declares all names itself. Only lines `#pragma include
// "file"` are replaced by files. Names that the programmable renderer sets when the text declares
// them: uniforms `mat4 modelViewProjectionMatrix`, `modelViewMatrix`, `modelMatrix`, `viewMatrix`,
// `projectionMatrix`, `textureMatrix`, `vec4 globalColor`, `sampler2D` or `sampler2DRect tex0`,
// `src_tex_unit0`, `float usingTexture`, `usingColors`; attributes `vec4 position`, `vec4 color`,
// `vec3 normal` (or vec4), `vec2 texcoord`. Texts of desktop OpenGL often have sampler2DRect, which
// no WebGL has. The shaders of the library itself begin with the holes %glsl_version% and
// %extensions%.
//
// source: documentation of ofShader (no npm package); stored copies of ofShader.cpp (includes) and ofGLProgrammableRenderer.cpp (names) of openFrameworks
// version: own
// names: all
// entry: main
// include: "..."
// hole: %...%
