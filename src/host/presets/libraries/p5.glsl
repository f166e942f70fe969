// p5.js
//
// A shader for createShader() or createFilterShader() is compiled unchanged, with its own
// `#version`, or as GLSL ES 1.00 without one. Nothing is added, so it declares uModelViewMatrix,
// uProjectionMatrix, aPosition, aTexCoord, vTexCoord or tex0 itself.
//
// The declarations below are added to the shaders of p5.js itself (written with IN, OUT, TEXTURE
// and OUT_COLOR), and to the functions that users pass to `modify()` of baseMaterialShader(),
// baseFilterShader() and similar: the hooks getObjectInputs, getWorldInputs, getCameraInputs,
// getPixelInputs, combineColors, getFinalColor, getColor and shouldDiscard. These are compiled as
// GLSL ES 3.00 unless the sketch uses WebGL 1. The structures differ between shaders: Inputs of a
// line has `color`, `tangent`, `center`, `position` and `strokeWeight` instead of the members
// below.
//
// Not declared here: the uniforms created by `modify()`, the attributes and varyings of the shader
// that the hook is inserted into, and the lights of the fragment shader.
//
// source: p5 2.3.4, dist/webgl/p5.RendererGL.js (_webGL2CompatibilityPrefix, phongVert, phongFrag, lineVert, lineFrag), dist/webgl2Compatibility-DA7DLMuq.js
// package: p5
// word: OUT_COLOR HOOK_getObjectInputs HOOK_getWorldInputs HOOK_getCameraInputs HOOK_getPixelInputs HOOK_combineColors HOOK_getFinalColor HOOK_getColor HOOK_beforeVertex HOOK_afterVertex HOOK_beforeFragment HOOK_afterFragment HOOK_shouldDiscard StrokeVertex
// global: p5
// complete: createShader createFilterShader
// patched: .modify(
// version: any
// names: some
// entry: main
precision highp float;
precision highp int;
#if __VERSION__ >= 300
#define WEBGL2
#define IN in
#define OUT out
#define TEXTURE texture
#ifdef FRAGMENT_SHADER
#ifndef OWN_OUTPUT
out vec4 outColor;
#define OUT_COLOR outColor
#endif
#endif
#else
#ifdef FRAGMENT_SHADER
#define IN varying
#define OUT_COLOR gl_FragColor
#else
#define IN attribute
#endif
#define OUT varying
#define TEXTURE texture2D
#endif
vec4 getTexture(in sampler2D content, vec2 coord);
#ifdef VERTEX_SHADER
struct Vertex { vec3 position; vec3 normal; vec2 texCoord; vec4 color; };
struct StrokeVertex { vec3 position; vec3 tangentIn; vec3 tangentOut; vec4 color; float weight; };
void HOOK_beforeVertex();
void HOOK_afterVertex();
Vertex HOOK_getObjectInputs(Vertex inputs);
Vertex HOOK_getWorldInputs(Vertex inputs);
Vertex HOOK_getCameraInputs(Vertex inputs);
StrokeVertex HOOK_getObjectInputs(StrokeVertex inputs);
StrokeVertex HOOK_getWorldInputs(StrokeVertex inputs);
StrokeVertex HOOK_getCameraInputs(StrokeVertex inputs);
#endif
#ifdef FRAGMENT_SHADER
struct ColorComponents {
  vec3 baseColor; float opacity; vec3 ambientColor; vec3 specularColor;
  vec3 diffuse; vec3 ambient; vec3 specular; vec3 emissive;
};
struct Inputs {
  vec3 normal; vec2 texCoord; vec3 ambientLight; vec3 ambientMaterial; vec3 specularMaterial;
  vec3 emissiveMaterial; vec4 color; float shininess; float metalness;
};
struct FilterInputs { vec2 texCoord; vec2 canvasSize; vec2 texelSize; };
void HOOK_beforeFragment();
void HOOK_afterFragment();
Inputs HOOK_getPixelInputs(Inputs inputs);
vec4 HOOK_combineColors(ColorComponents components);
vec4 HOOK_getFinalColor(vec4 color, vec2 texCoord);
vec4 HOOK_getColor(FilterInputs inputs, in sampler2D canvasContent);
bool HOOK_shouldDiscard(bool outside);
#endif
