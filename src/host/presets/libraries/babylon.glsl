// Babylon.js
//
// The engine adds these declarations to every shader that it compiles: those of ShaderMaterial,
// Effect, PostProcess, ProceduralTexture and its own materials. Babylon.js adds no uniforms and no
// attributes: the shader declares `world`, `viewProjection`, `textureSampler` and `vUV` itself.
//
// With WebGL 2, the default, the shader is compiled as GLSL ES 3.00. The engine replaces GLSL ES
// 1.00 syntax in the text: `attribute`, `varying` and `texture2D(`, in fragment shaders also
// `textureCube(`, `texture2DLodEXT(`, `textureCubeLodEXT(`, gl_FragDepthEXT, gl_FragColor and
// gl_FragData. The macros below stand for these replacements. texture2DProj and the *GradEXT
// functions are not replaced. A `#version 300 es` is removed, and the rest of such a shader is left
// unchanged.
//
// A float precision is added in both stages if the shader has no `precision highp float`. The
// output glFragColor is declared before `void main(`, unless the shader has its own
// `layout(location = 0) out`.
//
// Not declared here: the contents of `#include<name>`, the names available to CustomMaterial and
// plugins (`finalWorld`, `positionUpdated`, `normalW`), and the macros of the `defines` list.
// Includes may have replacements and an index: `#include<lightFragment>[0..maxSimultaneousLights]`,
// `#include<name>(from,to)`, `#include<__decl__name>`; `{X}` in the included file is the index.
//
// source: @babylonjs/core 9.34.0, Engines/Processors/shaderProcessor.js, Engines/WebGL/webGL2ShaderProcessors.js, Engines/thinEngine.functions.js, Materials/effect.functions.js
// package: @babylonjs/ reactylon babylonjs babylonjs-materials babylonjs-post-process babylonjs-procedural-textures
// word: finalWorld positionUpdated normalUpdated tangentUpdated uvUpdated
// global: BABYLON
// version: 300 es
// takes: version
// names: all
// entry: main
// include: <...>
#define WEBGL2
precision highp float;
#define texture2D texture
#ifdef VERTEX_SHADER
#define SHADER_NAME vertex
#define attribute in
#define varying out
#endif
#ifdef FRAGMENT_SHADER
#define SHADER_NAME fragment
#define varying in
#define texture2DLodEXT textureLod
#define textureCubeLodEXT textureLod
#define textureCube texture
#define gl_FragDepthEXT gl_FragDepth
// unless the shader has its own `layout(location = 0) out`
#ifndef OWN_OUTPUT
layout(location = 0) out vec4 glFragColor;
#define gl_FragColor glFragColor
#endif
#define gl_FragData glFragData
#endif
