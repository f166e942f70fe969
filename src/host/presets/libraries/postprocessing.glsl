// postprocessing
//
// An Effect of the package `postprocessing` has a fragment shader without main(). It defines
// mainImage(), mainUv() or both, and EffectPass inserts it into a ShaderMaterial of three.js.
// Everything that three.js provides is available, and the chunks `<common>`, `<packing>` and
// <dithering_pars_fragment> are included. The result is compiled as GLSL ES 3.00. Passes with their
// own ShaderMaterial belong to the host three.js.
//
// Signatures: `void mainImage(const in vec4 inputColor, const in vec2 uv, out vec4 outputColor)`,
// with `const in float depth` between uv and outputColor if the effect requests depth
// (EffectAttribute.DEPTH), and `void mainUv(inout vec2 uv)`. A vertex shader defines `void
// mainSupport()` or `void mainSupport(const in vec2 uv)`.
//
// Functions, varyings, uniforms and macros of the effect get a prefix such as `e0`, so names of
// different effects do not collide. The shader declares its uniforms itself. Not declared here: the
// macros in the Map object `defines` of the JavaScript class. DepthMaskMaterial defines `depthTest(d0, d1)`.
//
// base: three
// source: postprocessing 6.39.6, build/index.js (effect.frag, effect.vert, EffectPass); three 0.187.0, src/renderers/webgl/WebGLProgram.js, ShaderChunk/common.glsl.js, packing.glsl.js
// package: postprocessing @react-three/postprocessing
// word: inputBuffer getViewZ readDepth packFloatToRGBA unpackRGBAToFloat
// complete: Effect
// also: depthTest
// renames: yes
// entry: mainImage mainUv mainSupport
#define THREE_REVISION 187
#define DEPTH_PACKING 0
#define ENCODE_OUTPUT 1
#define PERSPECTIVE_CAMERA 1
#define UV vUv
uniform vec2 resolution;
uniform vec2 texelSize;
uniform float cameraNear;
uniform float cameraFar;
uniform float aspect;
uniform float time;
varying vec2 vUv;
#ifdef FRAGMENT_SHADER
// the chunk <common>
#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#define saturate( a ) clamp( a, 0.0, 1.0 )
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2(const in float x);
vec3 pow2(const in vec3 x);
float pow3(const in float x);
float pow4(const in float x);
float max3(const in vec3 v);
float average(const in vec3 v);
highp float rand(const in vec2 uv);
float precisionSafeLength(vec3 v);
struct IncidentLight { vec3 color; vec3 direction; bool visible; };
struct ReflectedLight { vec3 directDiffuse; vec3 directSpecular; vec3 indirectDiffuse; vec3 indirectSpecular; };
vec3 transformDirection(in vec3 dir, in mat4 matrix);
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix(in vec3 normal, in mat4 viewMatrix);
vec3 transformDirectionByInverseViewMatrix(in vec3 dir, in mat4 viewMatrix);
bool isPerspectiveMatrix(mat4 m);
vec2 equirectUv(in vec3 dir);
vec3 BRDF_Lambert(const in vec3 diffuseColor);
vec3 F_Schlick(const in vec3 f0, const in float f90, const in float dotVH);
float F_Schlick(const in float f0, const in float f90, const in float dotVH);
// the chunk <packing>
vec3 packNormalToRGB(const in vec3 normal);
vec3 unpackRGBToNormal(const in vec3 rgb);
vec4 packDepthToRGBA(const in float v);
vec3 packDepthToRGB(const in float v);
vec2 packDepthToRG(const in float v);
float unpackRGBAToDepth(const in vec4 v);
float unpackRGBToDepth(const in vec3 v);
float unpackRGToDepth(const in vec2 v);
vec4 pack2HalfToRGBA(const in vec2 v);
vec2 unpackRGBATo2Half(const in vec4 v);
float viewZToOrthographicDepth(const in float viewZ, const in float near, const in float far);
float orthographicDepthToViewZ(const in float depth, const in float near, const in float far);
float viewZToPerspectiveDepth(const in float viewZ, const in float near, const in float far);
float perspectiveDepthToViewZ(const in float depth, const in float near, const in float far);
// declared by the package
#define packFloatToRGBA(v) packDepthToRGBA(v)
#define unpackRGBAToFloat(v) unpackRGBAToDepth(v)
uniform sampler2D inputBuffer;
uniform highp sampler2D depthBuffer;
vec4 sRGBToLinear(const in vec4 value);
float readDepth(const in vec2 uv);
float getViewZ(const in float depth);
vec3 RGBToHCV(const in vec3 RGB);
vec3 RGBToHSL(const in vec3 RGB);
vec3 HueToRGB(const in float H);
vec3 HSLToRGB(const in vec3 HSL);
#endif
