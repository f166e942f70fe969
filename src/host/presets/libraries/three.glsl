// three.js
//
// WebGLRenderer puts this before the shaders of ShaderMaterial and of its own materials. A
// RawShaderMaterial gets only the macros SHADER_TYPE and SHADER_NAME and the material's `defines`.
//
// The shader is always compiled as GLSL ES 3.00. Macros map GLSL ES 1.00 syntax to it, so both
// styles work, except `attribute` in a fragment shader. The default precision of float, int and all
// samplers is set in both stages. With `glslVersion: THREE.GLSL3` the output `pc_fragColor` and the
// macro gl_FragColor are omitted, and the shader declares its own output.
//
// `#include <name>` lines are replaced by the chunks of three.js. Text for `onBeforeCompile` is
// part of such chunks, so it may use any of their names (`transformed`, `diffuseColor`,
// `vViewPosition`). NUM_DIR_LIGHTS, NUM_POINT_LIGHTS and similar words are replaced by numbers
// before the shader is compiled; the numbers below are stand-ins. `#pragma unroll_loop_start` and
// `#pragma unroll_loop_end` around a `for ( int i = 0; i < 4; i ++ )` unroll the loop, and
// UNROLLED_LOOP_INDEX is the number of the copy.
//
// Not declared here, since they depend on the mesh or the material: the attribute `color` (vec3 or
// vec4, with vertexColors), `tangent`, `uv1`, `uv2`, `uv3`, `morphTexture`, the macros USE_*, the
// tone mapping functions with toneMapping() (only if the renderer or the material has tone mapping
// enabled), and everything in the material's `defines`.
//
// reads: three.js ShaderMaterial
// source: three 0.187.0, src/renderers/webgl/WebGLProgram.js, src/renderers/webgl/WebGLPrograms.js, src/renderers/shaders/ShaderChunk/colorspace_pars_fragment.glsl.js; for `removed` the first version of every release from 0.90.0 on
// package: three @react-three/fiber @react-three/drei three-stdlib @threlte/core @tresjs/core angular-three
// word: modelViewMatrix projectionMatrix cameraPosition normalMatrix isOrthographic instanceMatrix linearToOutputTexel sRGBTransferOETF sRGBTransferEOTF LinearTransferOETF pc_fragColor skinWeight skinIndex
// global: THREE
// complete: ShaderMaterial shaderMaterial
// patched: onBeforeCompile
// bare: RawShaderMaterial
// glsl: glslVersion GLSL3
// also: color tangent uv1 uv2 uv3 morphTexture morphTarget* morphNormal* toneMapping* saturate LinearToneMapping ReinhardToneMapping CineonToneMapping ACESFilmicToneMapping AgXToneMapping NeutralToneMapping CustomToneMapping
// removed: mapTexelToLinear 137 remove the call: textures are decoded when they are read
// removed: envMapTexelToLinear 137 remove the call: textures are decoded when they are read
// removed: matcapTexelToLinear 137 remove the call: textures are decoded when they are read
// removed: emissiveMapTexelToLinear 137 remove the call: textures are decoded when they are read
// removed: lightMapTexelToLinear 137 remove the call: textures are decoded when they are read
// removed: GeometricContext 157 pass the position, the normal and the view direction one by one
// removed: vUv2 151 use `vAoMapUv` or `vLightMapUv`
// removed: linearToRelativeLuminance 143 use `luminance`
// removed: GammaToLinear 136 use `pow`
// removed: LinearToLinear 167 remove the call: it returned its argument
// removed: sRGBToLinear 137 use `sRGBTransferEOTF` (r170 and later)
// removed: LinearTosRGB 167 use `sRGBTransferOETF`
// removed: OptimizedCineonToneMapping 168 use `CineonToneMapping`
// removed: punctualLightIntensityToIrradianceFactor 132 use `getDistanceAttenuation`
// removed: whiteCompliment 108 use `whiteComplement`
// version: 300 es
// names: some
// entry: main
// include: <...>
// chunks: three.js
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
#define SHADER_TYPE ShaderMaterial
#define SHADER_NAME ShaderMaterial
#define texture2D texture
// stand-ins for words that three.js replaces by numbers
#define NUM_SUN_LIGHTS 1
#define NUM_DIR_LIGHTS 1
#define NUM_SPOT_LIGHTS 1
#define NUM_SPOT_LIGHT_MAPS 1
#define NUM_SPOT_LIGHT_COORDS 1
#define NUM_RECT_AREA_LIGHTS 1
#define NUM_POINT_LIGHTS 1
#define NUM_HEMI_LIGHTS 1
#define NUM_SUN_LIGHT_SHADOWS 1
#define NUM_DIR_LIGHT_SHADOWS 1
#define NUM_SPOT_LIGHT_SHADOWS 1
#define NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS 1
#define NUM_POINT_LIGHT_SHADOWS 1
#define NUM_LIGHT_PROBE_GRIDS 1
#define UNROLLED_LOOP_INDEX 0
#define NUM_CLIPPING_PLANES 1
#define UNION_CLIPPING_PLANES 1
uniform mat4 viewMatrix; // = identity, usual
uniform vec3 cameraPosition; // = camera, own
uniform bool isOrthographic; // = nothing, own
#ifdef VERTEX_SHADER
#define attribute in
#define varying out
uniform mat4 modelMatrix; // = identity, usual
uniform mat4 modelViewMatrix; // = identity, usual
uniform mat4 projectionMatrix; // = identity, usual
uniform mat3 normalMatrix; // = identity, or mat4, usual
attribute vec3 position;
attribute vec3 normal;
attribute vec2 uv;
// of an InstancedMesh (USE_INSTANCING, USE_INSTANCING_COLOR)
attribute mat4 instanceMatrix;
attribute vec3 instanceColor;
// of a SkinnedMesh (USE_SKINNING)
attribute vec4 skinIndex;
attribute vec4 skinWeight;
#endif
#ifdef FRAGMENT_SHADER
#define varying in
// omitted with glslVersion GLSL3: the shader declares its own output
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
#endif
#ifdef SHADER_DECLARES
// names that pages often set, and varyings of their vertex shaders for a plane
uniform float uTime; // = time, usual
uniform vec2 uMouse; // = pointer-unit
uniform vec2 uResolution; // = resolution
uniform sampler2D tDiffuse; // = file, usual
varying vec2 vUv; // = port_place, usual
varying vec3 vNormal; // = vec3(0.0, 0.0, 1.0), usual
varying vec3 vWorldNormal; // = vec3(0.0, 0.0, 1.0), usual
varying vec3 vPosition; // = vec3(port_pos, 0.0), usual
varying vec3 vWorldPosition; // = vec3(port_pos, 0.0), usual
varying vec3 vViewPosition; // = vec3(-port_pos, 1.0), usual
varying float vElevation; // = 0.5 * sin(6.0 * port_place.x), usual
#endif
