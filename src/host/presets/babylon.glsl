// Babylon.js
//
// The engine puts this before every shader that it compiles: those of ShaderMaterial, Effect,
// PostProcess, ProceduralTexture and its own materials. With WebGL 2, which is the rule, the text
// is compiled as GLSL ES 3.00: the words of GLSL ES 1.00 are replaced in the text itself
// (`attribute`, `varying`, `texture2D(`, in fragment shaders also `textureCube(`,
// `texture2DLodEXT(`, `textureCubeLodEXT(`, gl_FragDepthEXT, gl_FragColor and gl_FragData), which
// the macros below stand for; texture2DProj and the *GradEXT functions are not replaced. A
// `#version 300 es` in the text is cut, and such a text is left as it is otherwise. A precision for
// float is added in both stages where the text has no `precision highp float`. The output
// glFragColor stands before `void main(`, and is left out when the text has an own `layout(location
// = 0) out`. Babylon.js adds no uniforms and no attributes: the text declares `world`,
// `viewProjection`, `textureSampler`, `vUV` itself. What `#include<name>` brings, and what a text
// of CustomMaterial or a plugin may use (`finalWorld`, `positionUpdated`, `normalW`), is not
// declared here, nor are the macros of the `defines` list. Includes may have replacements and an
// index, `#include<lightFragment>[0..maxSimultaneousLights]`, `#include<name>(from,to)`,
// `#include<__decl__name>`; in such a file `{X}` is the index.
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
// not where the text has an own `layout(location = 0) out`
#ifndef OWN_OUTPUT
layout(location = 0) out vec4 glFragColor;
#define gl_FragColor glFragColor
#endif
#define gl_FragData glFragData
#endif
