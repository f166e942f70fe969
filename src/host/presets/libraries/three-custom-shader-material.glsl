// three-custom-shader-material
//
// CustomShaderMaterial inserts the user's shader into a built-in material of three.js, in
// onBeforeCompile. The text before main() goes before the material's main(), the body of main() to
// its start, and comments are removed. A shader without main() is inserted entirely before main().
// It assigns to the csm_ variables below, which have default values. It is compiled as GLSL ES 3.00
// with everything that three.js provides, and declares its uniforms itself.
//
// Some variables exist only in some materials: csm_PointSize in PointsMaterial; csm_Emissive,
// csm_Roughness, csm_Metalness and csm_Iridescence in MeshStandardMaterial and
// MeshPhysicalMaterial; csm_Clearcoat, csm_ClearcoatRoughness, csm_ClearcoatNormal,
// csm_Transmission and csm_Thickness in MeshPhysicalMaterial.
//
// Not declared here: the names that the chunks of that material declare, which the shader may use
// (the uniforms `diffuse`, `opacity`, `roughness`, `map`, the varyings `vNormal`, `vViewPosition`,
// the functions of `<common>`).
//
// base: three
// source: three-custom-shader-material 6.4.0, vanilla/three-custom-shader-material.es.js; three 0.187.0, src/renderers/webgl/WebGLProgram.js
// package: three-custom-shader-material
// word: csm_*
// also: diffuse opacity emissive specular shininess roughness metalness ior clearcoat clearcoatRoughness iridescence iridescenceIOR sheenColor sheenRoughness specularColor specularIntensity dispersion matcap map alphaMap aoMap bumpMap displacementMap emissiveMap envMap lightMap metalnessMap normalMap roughnessMap specularMap
// entry: main
#undef SHADER_TYPE
#undef SHADER_NAME
#define SHADER_TYPE MeshStandardMaterial
#define SHADER_NAME CustomShaderMaterial
#ifdef VERTEX_SHADER
#define IS_VERTEX
// three-custom-shader-material
vec3 csm_Position;
vec4 csm_PositionRaw;
vec3 csm_Normal;
float csm_PointSize;
varying mat4 csm_internal_vModelViewMatrix;
#endif
#ifdef FRAGMENT_SHADER
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
