// PixiJS
//
// GlProgram of version 8 compiles filters, meshes and shaders. With `#version 300 es` in the
// fragment shader, both stages are GLSL ES 3.00 and get only a precision. Without it, they are GLSL
// ES 1.00, and macros allow GLSL ES 3.00 syntax: `in`, `out`, texture(), and an output named
// finalColor, whose line `out vec4 finalColor;` is removed (it must be written exactly like this).
// As `in` is a macro there, a parameter with the qualifier `in` does not compile.
//
// A float precision is added only if the shader does not start with `precision`: highp for vertex
// shaders, mediump for fragment shaders.
//
// The host declares no uniforms. A filter declares `in vec2 vTextureCoord`, `uniform sampler2D
// uTexture`, `uniform vec4 uInputSize`, `uInputClamp`, `uInputPixel`, `uOutputFrame`,
// `uOutputTexture`, `uGlobalFrame` itself, and a mesh `aPosition`, `aUV`, `uProjectionMatrix`,
// `uWorldTransformMatrix`, `uTransformMatrix`.
//
// Not declared here: the locals that a shader fragment may use (a "bit" for compileHighShaderGl,
// inserted at {{header}}, {{start}}, {{main}}, {{end}}), such as `position`, `uv`, `modelMatrix`,
// `outColor`, `vColor`.
//
// source: pixi.js 8.22.0, lib/rendering/renderers/gl/shader/GlProgram.mjs and program/preprocessors, lib/rendering/high-shader/defaultProgramTemplate.mjs
// package: pixi.js pixi-filters
// global: PIXI
// version: any
// names: all
// entry: main
// hole: {{...}}
#define SHADER_NAME pixi-program
#if __VERSION__ < 300
#ifdef VERTEX_SHADER
#define in attribute
#define out varying
#endif
#ifdef FRAGMENT_SHADER
#define in varying
#define finalColor gl_FragColor
#define texture texture2D
#endif
#endif
#ifdef VERTEX_SHADER
precision highp float;
#endif
#ifdef FRAGMENT_SHADER
precision mediump float;
#endif
