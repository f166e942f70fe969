// three-custom-shader-material
//
// CustomShaderMaterial puts the text of a user into a built-in material of three.js, in
// onBeforeCompile: what stands before main() goes in front of the material's main(), the body of
// main() to its begin, and comments are removed. The text writes to the csm_ variables below, which
// have their values before it begins. It is compiled as GLSL ES 3.00 with all that three.js gives;
// it may also use whatever the chunks of that material declare (the uniforms `diffuse`, `opacity`,
// `roughness`, `map`, the varyings `vNormal`, `vViewPosition`, the functions of <common>), which is
// not declared here. Some variables are there only in some materials: csm_PointSize in
// PointsMaterial; csm_Emissive, csm_Roughness, csm_Metalness and csm_Iridescence in
// MeshStandardMaterial and MeshPhysicalMaterial; csm_Clearcoat, csm_ClearcoatRoughness,
// csm_ClearcoatNormal, csm_Transmission and csm_Thickness in MeshPhysicalMaterial. The text
// declares its uniforms itself. A text without main() is all put before main().
//
// source: three-custom-shader-material 6.4.0, vanilla/three-custom-shader-material.es.js; three 0.187.0, src/renderers/webgl/WebGLProgram.js
// package: three-custom-shader-material
// word: csm_*
// version: 300 es
// names: some
// entry: main
// include: <...>
precision highp float;
precision highp int;
precision highp sampler2D;
precision highp samplerCube;
precision highp sampler3D;
precision highp sampler2DArray;
precision highp sampler2DShadow;
precision highp samplerCubeShadow;
precision highp sampler2DArrayShadow;
precision highp isampler2D;
precision highp isampler3D;
precision highp isamplerCube;
precision highp isampler2DArray;
precision highp usampler2D;
precision highp usampler3D;
precision highp usamplerCube;
precision highp usampler2DArray;
#define HIGH_PRECISION
#define SHADER_TYPE MeshStandardMaterial
#define SHADER_NAME CustomShaderMaterial
#define texture2D texture
uniform mat4 viewMatrix;
uniform vec3 cameraPosition;
uniform bool isOrthographic;
#ifdef VERTEX_SHADER
#define attribute in
#define varying out
uniform mat4 modelMatrix;
uniform mat4 modelViewMatrix;
uniform mat4 projectionMatrix;
uniform mat3 normalMatrix;
attribute vec3 position;
attribute vec3 normal;
attribute vec2 uv;
// of an InstancedMesh (USE_INSTANCING, USE_INSTANCING_COLOR)
attribute mat4 instanceMatrix;
attribute vec3 instanceColor;
// of a SkinnedMesh (USE_SKINNING)
attribute vec4 skinIndex;
attribute vec4 skinWeight;
#define IS_VERTEX
// three-custom-shader-material
vec3 csm_Position;
vec4 csm_PositionRaw;
vec3 csm_Normal;
float csm_PointSize;
varying mat4 csm_internal_vModelViewMatrix;
#endif
#ifdef FRAGMENT_SHADER
#define varying in
// not with glslVersion GLSL3; then the shader declares its own output
#ifndef OWN_OUTPUT
layout(location = 0) out highp vec4 pc_fragColor;
#define gl_FragColor pc_fragColor
#endif
#define gl_FragDepthEXT gl_FragDepth
#define textureCube texture
#define texture2DProj textureProj
#define texture2DLodEXT textureLod
#define texture2DProjLodEXT textureProjLod
#define textureCubeLodEXT textureLod
#define texture2DGradEXT textureGrad
#define texture2DProjGradEXT textureProjGrad
#define textureCubeGradEXT textureGrad
vec4 LinearTransferOETF(in vec4 value);
vec4 sRGBTransferEOTF(in vec4 value);
vec4 sRGBTransferOETF(in vec4 value);
vec4 linearToOutputTexel(vec4 value);
float luminance(const in vec3 rgb);
#define IS_FRAGMENT
// three-custom-shader-material
vec4 csm_DiffuseColor;
vec4 csm_FragColor;
float csm_UnlitFac;
vec3 csm_Emissive;
float csm_Roughness;
float csm_Metalness;
float csm_Iridescence;
float csm_Clearcoat;
float csm_ClearcoatRoughness;
vec3 csm_ClearcoatNormal;
float csm_Transmission;
float csm_Thickness;
float csm_AO;
vec3 csm_FragNormal;
float csm_DepthAlpha;
varying mat4 csm_internal_vModelViewMatrix;
#endif
