// PixiJS
//
// GlProgram of version 8 compiles filters, meshes and shaders. A fragment text with `#version 300
// es` makes both stages GLSL ES 3.00 and gets only a precision; a text without it is compiled as
// GLSL ES 1.00, and then macros let it be written with the words of GLSL ES 3.00: `in`, `out`,
// texture(), and an output with the name finalColor, whose line `out vec4 finalColor;` is cut out
// of the text (it must be written exactly so). As `in` is a macro there, a parameter with the
// qualifier `in` does not compile. The precision of float is added only where the text does not
// begin with `precision`: highp for vertex shaders, mediump for fragment shaders. No uniforms are
// declared by the host: a filter declares `in vec2 vTextureCoord`, `uniform sampler2D uTexture`,
// `uniform vec4 uInputSize`, `uInputClamp`, `uInputPixel`, `uOutputFrame`, `uOutputTexture`,
// `uGlobalFrame`, and a mesh `aPosition`, `aUV`, `uProjectionMatrix`, `uWorldTransformMatrix`,
// `uTransformMatrix` itself. Not declared here: the locals that a part of a shader (a "bit" for
// compileHighShaderGl, put into {{header}}, {{start}}, {{main}}, {{end}}) may use, such as
// `position`, `uv`, `modelMatrix`, `outColor`, `vColor`.
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
