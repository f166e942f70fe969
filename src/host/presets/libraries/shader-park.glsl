// Shader Park
//
// A GLSL shader for Shader Park (glslToThreeJSMaterial, glslToMinimalRenderer and similar) has no
// main(). It defines `float surfaceDistance(vec3 p)` and `vec3 shade(vec3 p, vec3 normal)`; the
// host puts its library before it and its own main() after it. The host provides the vertex shader.
//
// The result is compiled as GLSL ES 3.00 with highp float. With three.js it is the fragment shader
// of a ShaderMaterial and has everything that three.js provides (of these, cameraPosition,
// viewMatrix and the macros are declared below); otherwise there are macros for cameraPosition and
// worldPos.
//
// Not declared here: the uniforms that a JavaScript sculpture creates with input(). Functions
// passed to glslSDF() and glslFunc() in JavaScript are complete functions that may use the same
// names.
//
// source: shader-park-core 0.2.8, dist/shader-park-core.esm.js (threeHeader, minimalHeader, sculptureStarterCode, glslFragFooter, baseUniforms)
// package: shader-park-core
// word: sculptureCenter mouseIntersection fractalNoise sphericalDistribution simpleLighting blendMaterial
// version: 300 es
// names: some
// entry: surfaceDistance shade
precision highp float;
precision highp int;
#ifdef FRAGMENT_SHADER
#define varying in
#define texture2D texture
#define textureCube texture
layout(location = 0) out highp vec4 pc_fragColor;
#define gl_FragColor pc_fragColor
uniform mat4 viewMatrix;
uniform mat4 projectionMatrix;
uniform vec3 cameraPosition;
uniform sampler2D msdf;
varying vec4 worldPos;
varying vec3 sculptureCenter;
uniform float time;
uniform float opacity;
uniform float _scale;
uniform vec3 mouse;
uniform float stepSize;
uniform vec2 resolution;
const float STEP_SIZE_CONSTANT = 0.9;
const int MAX_ITERATIONS = 300;
#define MAX_REFLECTIONS 0
const float PI = 3.14159265;
const float TAU = PI*2.0;
const float TWO_PI = TAU;
const float max_dist = 100.0;
const float intersection_threshold = 0.00001;
const float PHI = 1.61803398875;
struct Material { vec3 albedo; vec3 reflectiveAlbedo; float metallic; float roughness; float ao; };
struct ShadedMaterial { Material mat; vec3 color; vec3 backgroundColor; };
float surfaceDistance(vec3 p);
Material blendMaterial(Material a, Material b, float amount); float nsin(float x);
float ncos(float x); float softSquare(float x, int pw);
float osc(float freq, float amp, float base, float phase);
float osc(float freq, float amp, float base); float osc(float freq, float amp);
float osc(float freq); float osc(); vec3 hsv2rgb(vec3 c); vec3 rgb2hsv(vec3 c);
float line(vec3 p, vec3 a, vec3 b); float line(vec3 p, vec3 a, vec3 b, float radius);
float sphere(vec3 p, float size); float uBox(vec3 p, vec3 b);
float uRoundBox(vec3 p, vec3 b, float r); float box(vec3 p, vec3 box);
float box(vec3 p, float bx, float by, float bz); float roundedBox(vec3 p, vec3 box , float r);
float torus(vec3 p, vec2 t); float torus(vec3 p, float tx, float ty);
float infCylinder(vec3 p, vec3 c); float cylinder(vec3 p, vec2 h);
float cylinder(vec3 p, float hx, float hy); float cone(vec3 p, vec2 c); float plane(vec3 p, vec4 n);
float plane(vec3 p, float nx, float ny, float nz, float nw); float hexPrism(vec3 p, vec2 h);
float triPrism(vec3 p, vec2 h); float capsule(vec3 p, vec3 a, vec3 b, float r);
float triangularPrism(vec3 p, vec2 h); float cappedCone(vec3 p, vec3 c);
float roundCone(vec3 p, vec3 a, vec3 b, float r1, float r2); float ellipsoid(vec3 p, vec3 r);
vec3 toSpherical(vec3 p); vec3 fromSpherical(vec3 p); float dot2(vec3 v);
float uTriangle(vec3 p, vec3 a, vec3 b, vec3 c); float overwrite(float d1, float d2);
float add(float d1, float d2); float add(float d1, float d2, float d3);
float add(float d1, float d2, float d3, float d4);
float add(float d1, float d2, float d3, float d4, float d5);
float add(float d1, float d2, float d3, float d4, float d5, float d6);
float add(float d1, float d2, float d3, float d4, float d5, float d6, float d7);
float subtract(float d1, float d2); float intersect(float d1, float d2);
float shell(float d, float thickness); vec3 repeat3D(vec3 p, vec3 c);
float repeat1D(float p, float size); mat2 rot2(float a);
vec3 rotateVec(vec3 inputVec, vec3 axis, float angle); float smoothAdd(float a, float b, float k);
float smoothSubtract(float a,float b, float k); vec2 _hash(vec2 p); float noise(vec2 p);
float _hash13(vec3 p3); vec3 _hash33(vec3 p3); float noise(vec3 p);
float fractalNoise(vec3 p, float falloff, int iterations); float fractalNoise(vec3 p);
vec4 sphericalDistribution(vec3 p, float n); float intersect(vec3 ro, vec3 rd, float stepFraction);
vec3 getRayDirection(); vec3 mouseIntersection(); vec3 calcNormal(vec3 pos);
vec3 fresnelSchlick(float cosTheta, vec3 F0);
float DistributionGGX(vec3 N, vec3 H, float roughness);
float GeometrySchlickGGX(float NdotV, float roughness);
float GeometrySmith(vec3 N, vec3 V, vec3 L, float roughness);
ShadedMaterial pbrLighting(vec3 WordPos, vec3 N, vec3 lightdir, Material mat, vec3 backgroundColor);
float simpleLighting(vec3 p, vec3 normal, vec3 lightdir);
float specularLighting(vec3 p, vec3 normal, vec3 lightDirection, float shine);
float shadow(vec3 p, vec3 lightDirection, float amount); float occlusion(vec3 p,vec3 n);
#endif
