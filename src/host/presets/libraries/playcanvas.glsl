// PlayCanvas
//
// The engine puts this before every GLSL shader (ShaderMaterial, Shader, and its own materials).
// Shaders are always compiled as GLSL ES 3.00, with macros for GLSL ES 1.00 syntax and a precision
// for float, int and the samplers in both stages. pcFragColor1 to pcFragColor7 exist only if the
// device has that many colour attachments. The shader declares uniforms such as `matrix_model` and
// `matrix_viewProjection` and attributes such as `vertex_position` itself.
//
// PlayCanvas preprocesses the text: comments are removed first, `#include "name"` and `#include
// "name, COUNT"` insert chunks (in the latter `{i}` is the index), and `{NAME}` is replaced by the
// value of `#define {NAME} value`.
//
// Not declared here: the contents of included chunks, the names that a chunk may use if it replaces
// one of the engine's (`matrix_viewProjection`, `dNormalW`, `dAlbedo`, `litArgs_*`), the macros
// CAPS_* of the device, and the macros of the material.
//
// source: playcanvas 2.23.3, src/platform/graphics/shader-definition-utils.js, src/platform/graphics/shader-chunks/frag/gles3.js, vert/gles3.js and frag/shared.js, src/core/preprocessor.js
// package: playcanvas @playcanvas/react
// word: pcFragColor0 pcFragColor1 pcFragColor2 pcFragColor3 getGrabScreenPos getImageEffectUV TEXTURE_ACCEPT TEXTURE_ACCEPT_HIGHP TEXTURE_PASS SHADOWMAP_ACCEPT SHADOWMAP_PASS litArgs_* dPositionW dVertexNormalW dModelMatrix
// global: pc
// version: 300 es
// names: some
// entry: main
// include: "..."
precision highp float;
precision highp int;
precision highp usampler2D;
precision highp isampler2D;
precision highp sampler2DShadow;
precision highp samplerCubeShadow;
precision highp sampler2DArray;
#define GL2
#define SHADER_NAME Untitled
#define texture2D texture
#define utexture2D texture
#define itexture2D texture
#define TEXTURE_PASS(name) name
#define TEXTURE_ACCEPT(name) sampler2D name
#define TEXTURE_ACCEPT_HIGHP(name) highp sampler2D name
vec2 getGrabScreenPos(vec4 clipPos);
vec2 getImageEffectUV(vec2 uv);
#ifdef VERTEX_SHADER
#define VERTEXSHADER
#define attribute in
#define varying out
#endif
#ifdef FRAGMENT_SHADER
#define varying in
#define outType_0 vec4
layout(location = 0) out highp outType_0 pcFragColor0;
layout(location = 1) out highp vec4 pcFragColor1;
layout(location = 2) out highp vec4 pcFragColor2;
layout(location = 3) out highp vec4 pcFragColor3;
layout(location = 4) out highp vec4 pcFragColor4;
layout(location = 5) out highp vec4 pcFragColor5;
layout(location = 6) out highp vec4 pcFragColor6;
layout(location = 7) out highp vec4 pcFragColor7;
#define gl_FragColor pcFragColor0
#define texture2DBias texture
#define textureCube texture
#define texture2DProj textureProj
#define texture2DLod textureLod
#define texture2DProjLod textureProjLod
#define textureCubeLod textureLod
#define texture2DGrad textureGrad
#define texture2DProjGrad textureProjGrad
#define textureCubeGrad textureGrad
#define textureShadow(res, uv) textureGrad(res, uv, vec2(1, 1), vec2(1, 1))
#define SHADOWMAP_PASS(name) name
#define SHADOWMAP_ACCEPT(name) sampler2DShadow name
#endif
