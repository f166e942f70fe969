// What the chunks of three.js declare, set and read, and which releases have them.
//
// A chunk starts with its name after `//#`. One in a function is given by its effects: `vec3 a;` is a variable it
// declares and sets, `sets a b` and `reads a b` are variables of the code around it. `once a b` are names
// that releases before this one declared there. The functions of the others have no bodies.
//
// `from 154` is the first release that has a chunk, `until 153` the last one. `until 153 a 163`: the next release
// has the same text as `a`, and the releases up to 163 insert that for the old name, with a warning. The
// shaders of whole materials (`meshbasic_frag`), which three.js keeps in the same object, are not listed.
//
// The release is the middle number of the version of `package`. In addresses of its scripts, one of the texts of
// `cited` stands before it. Programs read it as `asked` and add chunks to `registry`.
//
// source: three 0.187.0 and nine releases from 0.90.0 on, src/renderers/shaders/ShaderChunk; for `from` and `until`
// the first version of every release from 0.90.0 to 0.187.0, and src/renderers/webgl/WebGLProgram.js
// package: three
// cited: three@0. three@^0. three@~0. three.js/0. three.js/r three.js@r
// asked: REVISION
// registry: ShaderChunk
//# alphahash_fragment
from 154
#ifdef USE_ALPHAHASH
reads diffuseColor vPosition
#endif
//# alphahash_pars_fragment
from 154
#ifdef USE_ALPHAHASH
const float ALPHA_HASH_SCALE = 0.05;
float hash2D( vec2 value );
float hash3D( vec3 value );
float getAlphaHashThreshold( vec3 position );
#endif
//# alphamap_fragment
#ifdef USE_ALPHAMAP
sets diffuseColor
reads alphaMap vAlphaMapUv
#endif
//# alphamap_pars_fragment
#ifdef USE_ALPHAMAP
uniform sampler2D alphaMap;
#endif
//# alphatest_fragment
#ifdef USE_ALPHATEST
#ifdef ALPHA_TO_COVERAGE
sets diffuseColor
reads alphaTest
#else
reads diffuseColor alphaTest
#endif
#endif
//# alphatest_pars_fragment
from 132
#ifdef USE_ALPHATEST
uniform float alphaTest;
#endif
//# aomap_fragment
#ifdef USE_AOMAP
float ambientOcclusion;
sets reflectedLight
reads aoMap vAoMapUv aoMapIntensity
#if defined( USE_CLEARCOAT )
sets clearcoatSpecularIndirect
reads ambientOcclusion
#endif
#if defined( USE_SHEEN )
sets sheenSpecularIndirect
reads ambientOcclusion
#endif
#if defined( USE_ENVMAP ) && defined( STANDARD )
float dotNV;
sets reflectedLight
reads geometryNormal geometryViewDir ambientOcclusion
#endif
#endif
//# aomap_pars_fragment
#ifdef USE_AOMAP
uniform sampler2D aoMap;
uniform float aoMapIntensity;
#endif
//# batching_pars_vertex
from 159
#ifdef USE_BATCHING
#if ! defined( GL_ANGLE_multi_draw )
#define gl_DrawID _gl_DrawID
uniform int _gl_DrawID;
#endif
uniform highp sampler2D batchingTexture;
uniform highp usampler2D batchingIdTexture;
mat4 getBatchingMatrix( const in float i );
float getIndirectIndex( const in int i );
#endif
#ifdef USE_BATCHING_COLOR
uniform sampler2D batchingColorTexture;
vec4 getBatchingColor( const in float i );
#endif
once batchId
//# batching_vertex
from 159
#ifdef USE_BATCHING
mat4 batchingMatrix;
reads gl_DrawID
#endif
//# begin_vertex
vec3 transformed;
reads position
#ifdef USE_ALPHAHASH
sets vPosition
reads position
#endif
//# beginnormal_vertex
vec3 objectNormal;
reads normal
#ifdef USE_TANGENT
vec3 objectTangent;
reads tangent
#endif
//# bsdfs
float G_BlinnPhong_Implicit( );
float D_BlinnPhong( const in float shininess, const in float dotNH );
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess );
once BRDF_Diffuse_Lambert BRDF_GGX BRDF_GGX_Iridescence BRDF_Lambert BRDF_Sheen BRDF_Specular_BlinnPhong
once BRDF_Specular_GGX BRDF_Specular_GGX_Environment BRDF_Specular_Multiscattering_Environment BRDF_Specular_Sheen
once BlinnExponentToGGXRoughness D_Charlie D_GGX F_Schlick F_Schlick_RoughnessDependent GGXRoughnessToBlinnExponent
once G_GGX_Smith G_GGX_SmithCorrelated LTC_ClippedSphereFormFactor LTC_EdgeVectorFormFactor LTC_Evaluate LTC_Uv
once Schlick_to_F0 V_GGX_SmithCorrelated V_Neubelt integrateSpecularBRDF punctualLightIntensityToIrradianceFactor
once rectCoords
//# bumpmap_pars_fragment
#ifdef USE_BUMPMAP
uniform sampler2D bumpMap;
uniform float bumpScale;
vec2 dHdxy_fwd();
vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection );
#endif
//# clearcoat_normal_fragment_begin
from 108
#ifdef USE_CLEARCOAT
vec3 clearcoatNormal;
reads nonPerturbedNormal
#endif
//# clearcoat_normal_fragment_maps
from 108
#ifdef USE_CLEARCOAT_NORMALMAP
vec3 clearcoatMapN;
sets clearcoatMapN clearcoatNormal
reads clearcoatNormalMap vClearcoatNormalMapUv clearcoatNormalScale tbn2
#endif
once mapN vTBN
//# clearcoat_normalmap_pars_fragment
from 108
until 114
once clearcoatNormalMap clearcoatNormalScale
//# clearcoat_pars_fragment
from 115
#ifdef USE_CLEARCOATMAP
uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
uniform sampler2D clearcoatNormalMap;
uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
uniform sampler2D clearcoatRoughnessMap;
#endif
//# clipping_planes_fragment
#if NUM_CLIPPING_PLANES > 0
vec4 plane;
#ifdef ALPHA_TO_COVERAGE
float clipOpacity;
sets plane distanceToPlane distanceGradient clipOpacity
reads vClipPosition
#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
float unionClipOpacity;
sets plane distanceToPlane distanceGradient unionClipOpacity clipOpacity
reads vClipPosition
#endif
sets diffuseColor
reads clipOpacity
#else
sets plane
reads vClipPosition
#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
bool clipped;
sets plane clipped
reads vClipPosition
#endif
#endif
#endif
//# clipping_planes_pars_fragment
#if NUM_CLIPPING_PLANES > 0
varying vec3 vClipPosition;
uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif
once vViewPosition
//# clipping_planes_pars_vertex
#if NUM_CLIPPING_PLANES > 0
varying vec3 vClipPosition;
#endif
once vViewPosition
//# clipping_planes_vertex
#if NUM_CLIPPING_PLANES > 0
sets vClipPosition
reads mvPosition
#endif
//# color_fragment
#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
sets diffuseColor
reads vColor
#endif
//# color_pars_fragment
#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
varying vec4 vColor;
#endif
//# color_pars_vertex
#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
varying vec4 vColor;
#endif
//# color_vertex
#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
sets vColor
#endif
#ifdef USE_COLOR_ALPHA
sets vColor
reads color
#elif defined( USE_COLOR )
sets vColor
reads color
#endif
#ifdef USE_INSTANCING_COLOR
sets vColor
reads instanceColor
#endif
#ifdef USE_BATCHING_COLOR
sets vColor
reads gl_DrawID
#endif
once batchingColor
//# colorspace_fragment
from 154
sets gl_FragColor
//# colorspace_pars_fragment
from 154
vec4 LinearTransferOETF( in vec4 value );
vec4 sRGBTransferEOTF( in vec4 value );
vec4 sRGBTransferOETF( in vec4 value );
once LINEAR_DISPLAY_P3_TO_LINEAR_SRGB LINEAR_SRGB_TO_LINEAR_DISPLAY_P3 LinearDisplayP3ToLinearSRGB
once LinearSRGBToLinearDisplayP3 LinearToLinear LinearTosRGB
//# common
#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x );
vec3 pow2( const in vec3 x );
float pow3( const in float x );
float pow4( const in float x );
float max3( const in vec3 v );
float average( const in vec3 v );
highp float rand( const in vec2 uv );
#ifdef HIGH_PRECISION
float precisionSafeLength( vec3 v );
#else
float precisionSafeLength( vec3 v );
#endif
struct IncidentLight { vec3 color; vec3 direction; bool visible; };
struct ReflectedLight { vec3 directDiffuse; vec3 directSpecular; vec3 indirectDiffuse; vec3 indirectSpecular; };
#ifdef USE_ALPHAHASH
varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix );
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix );
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix );
bool isPerspectiveMatrix( mat4 m );
vec2 equirectUv( in vec3 dir );
vec3 BRDF_Lambert( const in vec3 diffuseColor );
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH );
float F_Schlick( const in float f0, const in float f90, const in float dotVH );
once GeometricContext LOG2 bicubic clearcoatNormal g0 g1 h0 h1 linePlaneIntersect linearToRelativeLuminance
once luminance normal position projectOnPlane sideOfPlane textureBicubic transposeMat3 viewDir w0 w1 w2 w3
once whiteCompliment
//# cube_uv_reflection_fragment
until 186
once MipLevelInfo bilinearCubeUV cubeUV_m0 cubeUV_m1 cubeUV_m4 cubeUV_m5 cubeUV_m6 cubeUV_maxLods1 cubeUV_maxLods2
once cubeUV_maxLods3 cubeUV_maxMipLevel cubeUV_maxTileSize cubeUV_minMipLevel cubeUV_minTileSize cubeUV_r0
once cubeUV_r1 cubeUV_r4 cubeUV_r5 cubeUV_r6 cubeUV_rangeClamp cubeUV_rcpTextureSize cubeUV_textureSize cubeUV_v0
once cubeUV_v1 cubeUV_v4 cubeUV_v5 cubeUV_v6 getCubeUV getFace getFaceFromDirection getUV m0 m1 m4 m5 m6 r0 r1 r4
once r5 r6 roughnessToMip textureCubeUV v0 v1 v4 v5 v6
//# defaultnormal_vertex
vec3 transformedNormal;
reads objectNormal
#ifdef USE_TANGENT
vec3 transformedTangent;
reads objectTangent
#endif
#ifdef USE_BATCHING
mat3 bm;
sets transformedNormal
reads batchingMatrix
#ifdef USE_TANGENT
sets transformedTangent
reads bm
#endif
#endif
#ifdef USE_INSTANCING
mat3 im;
sets transformedNormal
reads instanceMatrix
#ifdef USE_TANGENT
sets transformedTangent
reads im
#endif
#endif
sets transformedNormal
reads normalMatrix
#ifdef FLIP_SIDED
sets transformedNormal
#endif
#ifdef USE_TANGENT
sets transformedTangent
reads modelViewMatrix
#endif
//# displacementmap_pars_vertex
#ifdef USE_DISPLACEMENTMAP
uniform sampler2D displacementMap;
uniform float displacementScale;
uniform float displacementBias;
#endif
//# displacementmap_vertex
#ifdef USE_DISPLACEMENTMAP
sets transformed
reads objectNormal displacementMap vDisplacementMapUv displacementScale displacementBias
#endif
//# dithering_fragment
#ifdef DITHERING
sets gl_FragColor
#endif
//# dithering_pars_fragment
#ifdef DITHERING
vec3 dithering( vec3 color );
#endif
//# emissivemap_fragment
#ifdef USE_EMISSIVEMAP
vec4 emissiveColor;
reads emissiveMap vEmissiveMapUv
#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
sets emissiveColor
#endif
sets totalEmissiveRadiance
reads emissiveColor
#endif
//# emissivemap_pars_fragment
#ifdef USE_EMISSIVEMAP
uniform sampler2D emissiveMap;
#endif
//# encodings_fragment
until 153 colorspace_fragment 163
//# encodings_pars_fragment
until 153 colorspace_pars_fragment 163
once GammaToLinear LinearToGamma LinearToLinear LinearToLogLuv LinearToRGBD LinearToRGBE LinearToRGBM LinearTosRGB
once LogLuvToLinear RGBDToLinear RGBEToLinear RGBMToLinear cLogLuvInverseM cLogLuvM sRGBToLinear
//# envmap_common_pars_fragment
from 108
#ifdef USE_ENVMAP
uniform float envMapIntensity;
uniform mat3 envMapRotation;
uniform samplerCube envMap;
#ifdef ENVMAP_TYPE_PMREM
float roughnessToMip( const in float roughness );
#endif
#endif
once flipEnvMap maxMipLevel
//# envmap_fragment
#ifdef USE_ENVMAP
#ifdef ENV_WORLDPOS
vec3 cameraToFrag;
vec3 worldNormal;
sets cameraToFrag
reads isOrthographic viewMatrix vWorldPosition cameraPosition normal
#ifdef ENVMAP_MODE_REFLECTION
vec3 reflectVec;
reads cameraToFrag worldNormal
#else
vec3 reflectVec;
reads cameraToFrag worldNormal refractionRatio
#endif
#else
vec3 reflectVec;
reads vReflect
#endif
#ifdef ENVMAP_TYPE_CUBE
vec4 envColor;
reads envMap envMapRotation reflectVec
#ifdef ENVMAP_BLENDING_MULTIPLY
sets outgoingLight
reads envColor specularStrength reflectivity
#elif defined( ENVMAP_BLENDING_MIX )
sets outgoingLight
reads envColor specularStrength reflectivity
#elif defined( ENVMAP_BLENDING_ADD )
sets outgoingLight
reads envColor specularStrength reflectivity
#endif
#endif
#endif
once cameraToVertex reflectView sampleUV
//# envmap_pars_fragment
#ifdef USE_ENVMAP
uniform float reflectivity;
#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
#define ENV_WORLDPOS
#endif
#ifdef ENV_WORLDPOS
varying vec3 vWorldPosition;
uniform float refractionRatio;
#else
varying vec3 vReflect;
#endif
#endif
once envMap envMapIntensity flipEnvMap
//# envmap_pars_vertex
#ifdef USE_ENVMAP
#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
#define ENV_WORLDPOS
#endif
#ifdef ENV_WORLDPOS
varying vec3 vWorldPosition;
#else
varying vec3 vReflect;
uniform float refractionRatio;
#endif
#endif
//# envmap_physical_pars_fragment
from 95
#ifdef USE_ENVMAP
vec3 getIBLIrradiance( const in vec3 normal );
vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness );
#ifdef USE_RETROREFLECTION
vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness );
#endif
#ifdef USE_ANISOTROPY
vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy );
#ifdef USE_RETROREFLECTION
vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy );
#endif
#endif
#endif
once getLightProbeIndirectIrradiance getLightProbeIndirectRadiance getSpecularMIPLevel refractionRatio
//# envmap_vertex
#ifdef USE_ENVMAP
#ifdef ENV_WORLDPOS
sets vWorldPosition
reads worldPosition
#else
vec3 cameraToVertex;
vec3 worldNormal;
sets cameraToVertex
reads isOrthographic viewMatrix worldPosition cameraPosition transformedNormal
#ifdef ENVMAP_MODE_REFLECTION
sets vReflect
reads cameraToVertex worldNormal
#else
sets vReflect
reads cameraToVertex worldNormal refractionRatio
#endif
#endif
#endif
//# fog_fragment
#ifdef USE_FOG
#ifdef FOG_EXP2
float fogFactor;
reads fogDensity vFogDepth
#else
float fogFactor;
reads fogNear fogFar vFogDepth
#endif
sets gl_FragColor
reads fogColor fogFactor
#endif
//# fog_pars_fragment
#ifdef USE_FOG
uniform vec3 fogColor;
varying float vFogDepth;
#ifdef FOG_EXP2
uniform float fogDensity;
#else
uniform float fogNear;
uniform float fogFar;
#endif
#endif
once fogDepth
//# fog_pars_vertex
#ifdef USE_FOG
varying float vFogDepth;
#endif
once fogDepth
//# fog_vertex
#ifdef USE_FOG
sets vFogDepth
reads mvPosition
#endif
//# gradientmap_pars_fragment
#ifdef USE_GRADIENTMAP
uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection );
//# iridescence_fragment
from 141
#ifdef USE_IRIDESCENCE
const mat3 XYZ_TO_REC709 = mat3( 3.2404542, -0.9692660, 0.0556434, -1.5371385, 1.8760108, -0.2040259, -0.4985314, 0.0415560, 1.0572252 );
vec3 Fresnel0ToIor( vec3 fresnel0 );
vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor );
float IorToFresnel0( float transmittedIor, float incidentIor );
vec3 evalSensitivity( float OPD, vec3 shift );
vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 );
#endif
//# iridescence_pars_fragment
from 141
#ifdef USE_IRIDESCENCEMAP
uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
uniform sampler2D iridescenceThicknessMap;
#endif
//# lightmap_fragment
until 163
once lightMapIrradiance lightMapTexel
//# lightmap_pars_fragment
#ifdef USE_LIGHTMAP
uniform sampler2D lightMap;
uniform float lightMapIntensity;
#endif
//# lightprobes_pars_fragment
from 184
#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution );
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal );
#endif
//# lights_fragment_begin
from 91
vec3 geometryPosition;
vec3 geometryNormal;
vec3 geometryViewDir;
vec3 geometryClearcoatNormal;
reads vViewPosition normal isOrthographic
#ifdef USE_CLEARCOAT
sets geometryClearcoatNormal
reads clearcoatNormal
#endif
#ifdef USE_IRIDESCENCE
float dotNVi;
reads normal geometryViewDir
#endif
#ifdef STANDARD
float dotNVms;
reads geometryNormal geometryViewDir dfgLUT
#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
float EssMs;
#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
PointLight pointLight;
#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
PointLightShadow pointLightShadow;
#endif
reads geometryPosition
#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
reads receiveShadow
#endif
sets reflectedLight
reads geometryPosition geometryNormal geometryViewDir geometryClearcoatNormal
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
SpotLight spotLight;
vec4 spotColor;
vec3 spotLightCoord;
bool inSpotLightMap;
#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
SpotLightShadow spotLightShadow;
#endif
reads geometryPosition
#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
#else
#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
#endif
#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
sets spotLightCoord inSpotLightMap spotColor
#endif
#undef SPOT_LIGHT_MAP_INDEX
#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
reads receiveShadow
#endif
sets reflectedLight
reads geometryPosition geometryNormal geometryViewDir geometryClearcoatNormal
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
SunLight sunLight;
#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
SunLightShadow sunLightShadow;
#endif
#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
reads receiveShadow
#endif
sets reflectedLight
reads geometryPosition geometryNormal geometryViewDir geometryClearcoatNormal
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
DirectionalLight directionalLight;
#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
DirectionalLightShadow directionalLightShadow;
#endif
#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
reads receiveShadow
#endif
sets reflectedLight
reads geometryPosition geometryNormal geometryViewDir geometryClearcoatNormal
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
RectAreaLight rectAreaLight;
sets reflectedLight
reads geometryPosition geometryNormal geometryViewDir geometryClearcoatNormal
#endif
#if defined( RE_IndirectDiffuse )
vec3 iblIrradiance;
vec3 irradiance;
reads ambientLightColor
#if defined( USE_LIGHT_PROBES )
sets irradiance
reads geometryNormal
#endif
#if ( NUM_HEMI_LIGHTS > 0 )
sets irradiance
reads geometryNormal
#endif
#if NUM_LIGHT_PROBE_GRIDS > 0
vec3 probeWorldPos;
vec3 probeWorldNormal;
int probeGrid;
sets probeGrid irradiance
reads geometryPosition viewMatrix geometryNormal
#endif
#endif
#if defined( RE_IndirectSpecular )
vec3 radiance;
vec3 clearcoatRadiance;
#endif
once geometry
//# lights_fragment_end
from 91
#if defined( RE_IndirectDiffuse )
#if defined( LAMBERT ) || defined( PHONG )
sets irradiance
reads iblIrradiance
#endif
sets reflectedLight
reads irradiance geometryPosition geometryNormal geometryViewDir geometryClearcoatNormal
#endif
#if defined( RE_IndirectSpecular )
sets reflectedLight
reads radiance iblIrradiance clearcoatRadiance geometryPosition geometryNormal geometryViewDir geometryClearcoatNormal
#endif
//# lights_fragment_maps
from 91
#if defined( RE_IndirectDiffuse )
#ifdef USE_LIGHTMAP
vec4 lightMapTexel;
vec3 lightMapIrradiance;
sets irradiance
reads lightMap vLightMapUv lightMapIntensity
#endif
#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
sets iblIrradiance
reads geometryNormal
#endif
#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
#ifdef USE_ANISOTROPY
vec3 iblRadiance;
reads geometryViewDir geometryNormal
#else
vec3 iblRadiance;
reads geometryViewDir geometryNormal
#endif
#ifdef USE_RETROREFLECTION
#ifdef USE_ANISOTROPY
vec3 retroIBLRadiance;
reads geometryViewDir geometryNormal
#else
vec3 retroIBLRadiance;
reads geometryViewDir geometryNormal
#endif
sets iblRadiance
reads retroIBLRadiance
#endif
sets radiance
reads iblRadiance
#ifdef USE_CLEARCOAT
sets clearcoatRadiance
reads geometryViewDir geometryClearcoatNormal
#endif
#endif
//# lights_lambert_fragment
from 144
LambertMaterial material;
reads diffuseColor specularStrength
//# lights_lambert_pars_fragment
from 144
varying vec3 vViewPosition;
struct LambertMaterial { vec3 diffuseColor; float specularStrength; };
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight );
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight );
#define RE_Direct RE_Direct_Lambert
#define RE_IndirectDiffuse RE_IndirectDiffuse_Lambert
//# lights_lambert_vertex
until 143
once backGeometry diffuse directLight directLightColor_Diffuse dotNL geometry
//# lights_pars
until 90
once DirectionalLight HemisphereLight PointLight RectAreaLight SpotLight ambientLightColor color coneCos decay
once direction directionalLights distance getAmbientLightIrradiance getDirectionalDirectLightIrradiance
once getHemisphereLightIrradiance getLightProbeIndirectIrradiance getLightProbeIndirectRadiance
once getPointDirectLightIrradiance getSpecularMIPLevel getSpotDirectLightIrradiance groundColor halfHeight
once halfWidth hemisphereLights ltc_1 ltc_2 penumbraCos pointLights position rectAreaLights shadow shadowBias
once shadowCameraFar shadowCameraNear shadowMapSize shadowRadius skyColor spotLights
//# lights_pars_begin
from 91
uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] );
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal );
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor );
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent );
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine );
#if NUM_SUN_LIGHTS > 0
struct SunLight { vec3 direction; vec3 color; };
uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
void getSunLightInfo( const in SunLight sunLight, out IncidentLight light );
#endif
#if NUM_DIR_LIGHTS > 0
struct DirectionalLight { vec3 direction; vec3 color; };
uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light );
#endif
#if NUM_POINT_LIGHTS > 0
struct PointLight { vec3 position; vec3 color; float distance; float decay; };
uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light );
#endif
#if NUM_SPOT_LIGHTS > 0
struct SpotLight { vec3 position; vec3 direction; vec3 color; float distance; float decay; float coneCos; float penumbraCos; };
uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light );
#endif
#if NUM_RECT_AREA_LIGHTS > 0
struct RectAreaLight { vec3 color; vec3 position; vec3 halfWidth; vec3 halfHeight; };
uniform sampler2D ltc_1;
uniform sampler2D ltc_2;
uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
struct HemisphereLight { vec3 direction; vec3 skyColor; vec3 groundColor; };
uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal );
#endif
#include <lightprobes_pars_fragment>
once getDirectionalDirectLightIrradiance getPointDirectLightIrradiance getSpotDirectLightIrradiance shadow
once shadowBias shadowCameraFar shadowCameraNear shadowMapSize shadowRadius
//# lights_phong_fragment
BlinnPhongMaterial material;
reads diffuseColor specular shininess specularStrength
//# lights_phong_pars_fragment
varying vec3 vViewPosition;
struct BlinnPhongMaterial { vec3 diffuseColor; vec3 specularColor; float specularShininess; float specularStrength; };
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight );
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight );
#define RE_Direct RE_Direct_BlinnPhong
#define RE_IndirectDiffuse RE_IndirectDiffuse_BlinnPhong
once Material_LightProbeLOD vNormal
//# lights_physical_fragment
PhysicalMaterial material;
vec3 dxy;
float geometryRoughness;
reads diffuseColor metalnessFactor nonPerturbedNormal roughnessFactor
#ifdef USE_DIFFUSE_ROUGHNESS
float diffuseRoughnessFactor;
reads diffuseRoughness
#ifdef USE_DIFFUSE_ROUGHNESSMAP
sets diffuseRoughnessFactor
reads diffuseRoughnessMap vDiffuseRoughnessMapUv
#endif
reads diffuseRoughnessFactor
#endif
#ifdef IOR
reads ior
#ifdef USE_SPECULAR
float specularIntensityFactor;
vec3 specularColorFactor;
reads specularIntensity specularColor
#ifdef USE_SPECULAR_COLORMAP
sets specularColorFactor
reads specularColorMap vSpecularColorMapUv
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
sets specularIntensityFactor
reads specularIntensityMap vSpecularIntensityMapUv
#endif
reads specularIntensityFactor metalnessFactor
#else
float specularIntensityFactor;
vec3 specularColorFactor;
#endif
reads specularColorFactor specularIntensityFactor diffuseColor metalnessFactor
#else
reads diffuseColor metalnessFactor
#endif
#ifdef USE_CLEARCOAT
reads clearcoat clearcoatRoughness
#ifdef USE_CLEARCOATMAP
reads clearcoatMap vClearcoatMapUv
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
reads clearcoatRoughnessMap vClearcoatRoughnessMapUv
#endif
reads geometryRoughness
#endif
#ifdef USE_DISPERSION
reads dispersion
#endif
#ifdef USE_RETROREFLECTION
reads retroreflectivity
#endif
#ifdef USE_IRIDESCENCE
reads iridescence iridescenceIOR
#ifdef USE_IRIDESCENCEMAP
reads iridescenceMap vIridescenceMapUv
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
reads iridescenceThicknessMaximum iridescenceThicknessMinimum iridescenceThicknessMap vIridescenceThicknessMapUv
#else
reads iridescenceThicknessMaximum
#endif
#endif
#ifdef USE_SHEEN
reads sheenColor
#ifdef USE_SHEEN_COLORMAP
reads sheenColorMap vSheenColorMapUv
#endif
reads sheenRoughness
#ifdef USE_SHEEN_ROUGHNESSMAP
reads sheenRoughnessMap vSheenRoughnessMapUv
#endif
#endif
#ifdef USE_ANISOTROPY
#ifdef USE_ANISOTROPYMAP
mat2 anisotropyMat;
vec3 anisotropyPolar;
vec2 anisotropyV;
reads anisotropyVector anisotropyMap vAnisotropyMapUv
#else
vec2 anisotropyV;
reads anisotropyVector
#endif
sets anisotropyV
reads tbn
#endif
//# lights_physical_pars_fragment
uniform sampler2D dfgLUT;
struct PhysicalMaterial { vec3 diffuseColor; vec3 diffuseContribution; vec3 specularColor; vec3 specularColorBlended; float roughness; float metalness; float specularF90; float dispersion; vec2 dfg; vec3 multiScatteringCompensation;
#ifdef USE_DIFFUSE_ROUGHNESS
float diffuseRoughness;
#endif
#ifdef USE_RETROREFLECTION
float retroreflectivity;
#endif
#ifdef USE_CLEARCOAT
float clearcoat;
float clearcoatRoughness;
vec3 clearcoatF0;
float clearcoatF90;
#endif
#ifdef USE_IRIDESCENCE
float iridescence;
float iridescenceIOR;
float iridescenceThickness;
vec3 iridescenceFresnel;
vec3 iridescenceF0Dielectric;
vec3 iridescenceF0Metallic;
#endif
#ifdef USE_SHEEN
vec3 sheenColor;
float sheenRoughness;
#endif
#ifdef IOR
float ior;
#endif
#ifdef USE_TRANSMISSION
float transmission;
float transmissionAlpha;
float thickness;
float attenuationDistance;
vec3 attenuationColor;
#endif
#ifdef USE_ANISOTROPY
float anisotropy;
float alphaT;
vec3 anisotropyT;
vec3 anisotropyB;
#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH );
#ifdef USE_DIFFUSE_ROUGHNESS
const float EON_EPSILON = 1e-7;
float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A );
vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness );
vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV );
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV );
float D_GGX( const in float alpha, const in float dotNH );
#ifdef USE_ANISOTROPY
float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL );
float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH );
#endif
#ifdef USE_CLEARCOAT
vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material);
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material );
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness );
float LTC_ClippedSphereFormFactor( const in vec3 f );
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 );
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] );
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH );
float V_Neubelt( float dotNV, float dotNL );
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness );
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness );
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness );
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter );
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter );
#endif
#if NUM_RECT_AREA_LIGHTS > 0
void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight );
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight );
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight );
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight);
#define RE_Direct RE_Direct_Physical
#define RE_Direct_RectArea RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness );
once DEFAULT_SPECULAR_COEFFICIENT DFGApprox MAXIMUM_SPECULAR_COEFFICIENT Material_BlinnShininessExponent
once Material_ClearCoat_BlinnShininessExponent clearCoat clearCoatDHRApprox clearCoatRoughness clearcoatDHRApprox
once clearcoatSpecular computeMultiscattering iridescenceF0 sheenSpecular specularRoughness
//# lights_template
until 90
once clearCoatRadiance directLight directionalLight geometry irradiance lightMapIrradiance pointLight radiance
once rectAreaLight spotLight
//# lights_toon_fragment
from 112
ToonMaterial material;
reads diffuseColor
//# lights_toon_pars_fragment
from 112
varying vec3 vViewPosition;
struct ToonMaterial { vec3 diffuseColor; };
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight );
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight );
#define RE_Direct RE_Direct_Toon
#define RE_IndirectDiffuse RE_IndirectDiffuse_Toon
once Material_LightProbeLOD vNormal
//# logdepthbuf_fragment
#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
sets gl_FragDepth
reads vIsPerspective gl_FragCoord vFragDepth logDepthBufFC
#endif
//# logdepthbuf_pars_fragment
#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
uniform float logDepthBufFC;
varying float vFragDepth;
varying float vIsPerspective;
#endif
//# logdepthbuf_pars_vertex
#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
varying float vFragDepth;
varying float vIsPerspective;
#endif
once logDepthBufFC
//# logdepthbuf_vertex
#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
sets vFragDepth vIsPerspective
reads gl_Position projectionMatrix
#endif
//# map_fragment
#ifdef USE_MAP
vec4 sampledDiffuseColor;
reads map vMapUv
#ifdef DECODE_VIDEO_TEXTURE
sets sampledDiffuseColor
#endif
sets diffuseColor
reads sampledDiffuseColor
#endif
once texelColor
//# map_pars_fragment
#ifdef USE_MAP
uniform sampler2D map;
#endif
//# map_particle_fragment
#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
#if defined( USE_POINTS_UV )
vec2 uv;
reads vUv
#else
vec2 uv;
reads uvTransform gl_PointCoord
#endif
#endif
#ifdef USE_MAP
sets diffuseColor
reads map uv
#endif
#ifdef USE_ALPHAMAP
sets diffuseColor
reads alphaMap uv
#endif
once mapTexel
//# map_particle_pars_fragment
#if defined( USE_POINTS_UV )
varying vec2 vUv;
#else
#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
uniform mat3 uvTransform;
#endif
#endif
#ifdef USE_MAP
uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
uniform sampler2D alphaMap;
#endif
//# metalnessmap_fragment
float metalnessFactor;
reads metalness
#ifdef USE_METALNESSMAP
vec4 texelMetalness;
sets metalnessFactor
reads metalnessMap vMetalnessMapUv
#endif
//# metalnessmap_pars_fragment
#ifdef USE_METALNESSMAP
uniform sampler2D metalnessMap;
#endif
//# morphcolor_vertex
from 138
#if defined( USE_MORPHCOLORS )
#if defined( USE_COLOR_ALPHA )
sets vColor
reads morphTargetBaseInfluence
#elif defined( USE_COLOR )
sets vColor
reads morphTargetBaseInfluence
#endif
#if defined( USE_COLOR_ALPHA )
sets vColor
reads gl_VertexID
#elif defined( USE_COLOR )
sets vColor
reads gl_VertexID
#endif
#endif
//# morphinstance_vertex
from 162
#ifdef USE_INSTANCING_MORPH
float morphTargetInfluences[ MORPHTARGETS_COUNT ];
float morphTargetBaseInfluence;
reads morphTexture gl_InstanceID
#endif
//# morphnormal_vertex
#ifdef USE_MORPHNORMALS
sets objectNormal
reads morphTargetBaseInfluence gl_VertexID
#endif
//# morphtarget_pars_vertex
#ifdef USE_MORPHTARGETS
#ifndef USE_INSTANCING_MORPH
uniform float morphTargetBaseInfluence;
uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
#endif
uniform sampler2DArray morphTargetsTexture;
uniform ivec2 morphTargetsTextureSize;
vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset );
#endif
//# morphtarget_vertex
#ifdef USE_MORPHTARGETS
sets transformed
reads morphTargetBaseInfluence gl_VertexID
#endif
//# normal_fragment
until 90
once fdx fdy normal
//# normal_fragment_begin
from 91
float faceDirection;
reads gl_FrontFacing
#ifdef FLAT_SHADED
vec3 fdx;
vec3 fdy;
vec3 normal;
reads vViewPosition
#else
vec3 normal;
reads vNormal
#ifdef DOUBLE_SIDED
sets normal
reads faceDirection
#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
#ifdef USE_TANGENT
mat3 tbn;
reads vTangent vBitangent normal
#else
mat3 tbn;
reads vViewPosition normal
#if defined( USE_NORMALMAP )
reads vNormalMapUv
#elif defined( USE_CLEARCOAT_NORMALMAP )
reads vClearcoatNormalMapUv
#else
reads vUv
#endif
#endif
#ifdef DOUBLE_SIDED
sets tbn
reads faceDirection
#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
#ifdef USE_TANGENT
mat3 tbn2;
reads vTangent vBitangent normal
#else
mat3 tbn2;
reads vViewPosition normal vClearcoatNormalMapUv
#endif
#ifdef DOUBLE_SIDED
sets tbn2
reads faceDirection
#endif
#endif
vec3 nonPerturbedNormal;
reads normal
once bitangent geometryNormal tangent vTBN
//# normal_fragment_maps
from 91
#ifdef USE_NORMALMAP_OBJECTSPACE
sets normal
reads normalMap vNormalMapUv
#ifdef FLIP_SIDED
sets normal
#endif
#ifdef DOUBLE_SIDED
sets normal
reads faceDirection
#endif
sets normal
reads normalMatrix
#elif defined( USE_NORMALMAP_TANGENTSPACE )
vec3 mapN;
reads normalMap vNormalMapUv
#if defined( USE_PACKED_NORMALMAP )
sets mapN
#endif
sets mapN normal
reads normalScale tbn
#elif defined( USE_BUMPMAP )
sets normal
reads vViewPosition faceDirection
#endif
once vTBN
//# normal_pars_fragment
from 132
#ifndef FLAT_SHADED
varying vec3 vNormal;
#ifdef USE_TANGENT
varying vec3 vTangent;
varying vec3 vBitangent;
#endif
#endif
//# normal_pars_vertex
from 132
#ifndef FLAT_SHADED
varying vec3 vNormal;
#ifdef USE_TANGENT
varying vec3 vTangent;
varying vec3 vBitangent;
#endif
#endif
//# normal_vertex
from 132
#ifndef FLAT_SHADED
sets vNormal
reads transformedNormal
#ifdef USE_TANGENT
sets vTangent vBitangent
reads transformedTangent vNormal tangent
#ifdef FLIP_SIDED
sets vBitangent
#endif
#endif
#endif
//# normalmap_pars_fragment
#ifdef USE_NORMALMAP
uniform sampler2D normalMap;
uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv );
#endif
once perturbNormal2Arb
//# opaque_fragment
from 154
#ifdef OPAQUE
sets diffuseColor
#endif
#ifdef USE_TRANSMISSION
sets diffuseColor
#endif
sets gl_FragColor
reads outgoingLight diffuseColor
//# output_fragment
from 132
until 153 opaque_fragment 163
//# packing
vec3 packNormalToRGB( const in vec3 normal );
vec3 unpackRGBToNormal( const in vec3 rgb );
const float PackUpscale = 256. / 255.;
const float UnpackDownscale = 255. / 256.;
const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v );
vec3 packDepthToRGB( const in float v );
vec2 packDepthToRG( const in float v );
float unpackRGBAToDepth( const in vec4 v );
float unpackRGBToDepth( const in vec3 v );
float unpackRGToDepth( const in vec2 v );
vec4 pack2HalfToRGBA( const in vec2 v );
vec2 unpackRGBATo2Half( const in vec4 v );
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far );
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far );
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far );
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far );
once UnpackFactors decodeHalfRGBA encodeHalfRGBA
//# premultiplied_alpha_fragment
#ifdef PREMULTIPLIED_ALPHA
sets gl_FragColor
#endif
//# project_vertex
vec4 mvPosition;
reads transformed
#ifdef USE_BATCHING
sets mvPosition
reads batchingMatrix
#endif
#ifdef USE_INSTANCING
sets mvPosition
reads instanceMatrix
#endif
sets mvPosition gl_Position
reads modelViewMatrix projectionMatrix
//# roughnessmap_fragment
float roughnessFactor;
reads roughness
#ifdef USE_ROUGHNESSMAP
vec4 texelRoughness;
sets roughnessFactor
reads roughnessMap vRoughnessMapUv
#endif
//# roughnessmap_pars_fragment
#ifdef USE_ROUGHNESSMAP
uniform sampler2D roughnessMap;
#endif
//# shadowmap_pars_fragment
#if NUM_SPOT_LIGHT_COORDS > 0
varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
#if NUM_SUN_LIGHT_SHADOWS > 0
#define SUN_LIGHT_CASCADES 2
#if defined( SHADOWMAP_TYPE_PCF )
uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
#else
uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
#endif
uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
varying vec4 vSunShadowWorldPosition;
varying vec3 vSunShadowWorldNormal;
struct SunLightShadow { float shadowIntensity; float shadowBias; float shadowNormalBias; float shadowRadius; vec2 shadowMapSize; };
uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
#endif
#if NUM_DIR_LIGHT_SHADOWS > 0
#if defined( SHADOWMAP_TYPE_PCF )
uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
#else
uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
#endif
varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
struct DirectionalLightShadow { float shadowIntensity; float shadowBias; float shadowNormalBias; float shadowRadius; vec2 shadowMapSize; };
uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
#endif
#if NUM_SPOT_LIGHT_SHADOWS > 0
#if defined( SHADOWMAP_TYPE_PCF )
uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
#else
uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
#endif
struct SpotLightShadow { float shadowIntensity; float shadowBias; float shadowNormalBias; float shadowRadius; vec2 shadowMapSize; };
uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
#endif
#if NUM_POINT_LIGHT_SHADOWS > 0
#if defined( SHADOWMAP_TYPE_PCF )
uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
#elif defined( SHADOWMAP_TYPE_BASIC )
uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
#endif
varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
struct PointLightShadow { float shadowIntensity; float shadowBias; float shadowNormalBias; float shadowRadius; vec2 shadowMapSize; float shadowCameraNear; float shadowCameraFar; };
uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
#endif
#if defined( SHADOWMAP_TYPE_PCF )
float interleavedGradientNoise( vec2 position );
vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi );
#endif
#if defined( SHADOWMAP_TYPE_PCF )
float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord );
#elif defined( SHADOWMAP_TYPE_VSM )
float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord );
#else
float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord );
#endif
#if NUM_SUN_LIGHT_SHADOWS > 0
float getSunShadow(
#if defined( SHADOWMAP_TYPE_PCF )
sampler2DShadow shadowMap,
#else
sampler2D shadowMap,
#endif
SunLightShadow sunLightShadow, int shadowIndex );
#endif
#if NUM_POINT_LIGHT_SHADOWS > 0
#if defined( SHADOWMAP_TYPE_PCF )
float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar );
#elif defined( SHADOWMAP_TYPE_BASIC )
float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar );
#endif
#endif
#endif
once VSMShadow cubeToUV texture2DCompare texture2DDistribution texture2DShadowLerp vSpotShadowCoord
//# shadowmap_pars_vertex
#if NUM_SPOT_LIGHT_COORDS > 0
uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
#if NUM_SUN_LIGHT_SHADOWS > 0
varying vec4 vSunShadowWorldPosition;
varying vec3 vSunShadowWorldNormal;
#endif
#if NUM_DIR_LIGHT_SHADOWS > 0
uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
struct DirectionalLightShadow { float shadowIntensity; float shadowBias; float shadowNormalBias; float shadowRadius; vec2 shadowMapSize; };
uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
#endif
#if NUM_SPOT_LIGHT_SHADOWS > 0
struct SpotLightShadow { float shadowIntensity; float shadowBias; float shadowNormalBias; float shadowRadius; vec2 shadowMapSize; };
uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
#endif
#if NUM_POINT_LIGHT_SHADOWS > 0
uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
struct PointLightShadow { float shadowIntensity; float shadowBias; float shadowNormalBias; float shadowRadius; vec2 shadowMapSize; float shadowCameraNear; float shadowCameraFar; };
uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
#endif
#endif
once spotShadowMatrix vSpotShadowCoord
//# shadowmap_vertex
#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
#ifdef HAS_NORMAL
vec3 shadowWorldNormal;
reads transformedNormal viewMatrix
#else
vec3 shadowWorldNormal;
#endif
vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
#if NUM_SUN_LIGHT_SHADOWS > 0
sets vSunShadowWorldPosition vSunShadowWorldNormal
reads worldPosition mvPosition shadowWorldNormal
#endif
#if NUM_DIR_LIGHT_SHADOWS > 0
sets shadowWorldPosition
reads worldPosition shadowWorldNormal
#endif
#if NUM_POINT_LIGHT_SHADOWS > 0
sets shadowWorldPosition
reads worldPosition shadowWorldNormal
#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
sets shadowWorldPosition
reads worldPosition
#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
sets shadowWorldPosition
reads shadowWorldNormal
#endif
reads shadowWorldPosition
#endif
//# shadowmask_pars_fragment
float getShadowMask();
//# skinbase_vertex
#ifdef USE_SKINNING
mat4 boneMatX;
mat4 boneMatY;
mat4 boneMatZ;
mat4 boneMatW;
reads skinIndex
#endif
//# skinning_pars_vertex
#ifdef USE_SKINNING
uniform mat4 bindMatrix;
uniform mat4 bindMatrixInverse;
uniform highp sampler2D boneTexture;
mat4 getBoneMatrix( const in float i );
#endif
once boneMatrices boneTextureSize
//# skinning_vertex
#ifdef USE_SKINNING
vec4 skinVertex;
vec4 skinned;
sets skinned transformed
reads bindMatrix boneMatX skinWeight boneMatY boneMatZ boneMatW bindMatrixInverse
#endif
//# skinnormal_vertex
#ifdef USE_SKINNING
mat4 skinMatrix;
sets skinMatrix objectNormal
reads skinWeight boneMatX boneMatY boneMatZ boneMatW bindMatrixInverse bindMatrix
#ifdef USE_TANGENT
sets objectTangent
reads skinMatrix
#endif
#endif
//# specularmap_fragment
float specularStrength;
#ifdef USE_SPECULARMAP
vec4 texelSpecular;
sets specularStrength
reads specularMap vSpecularMapUv
#else
sets specularStrength
#endif
//# specularmap_pars_fragment
#ifdef USE_SPECULARMAP
uniform sampler2D specularMap;
#endif
//# tonemapping_fragment
#if defined( TONE_MAPPING )
sets gl_FragColor
#endif
//# tonemapping_pars_fragment
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color );
vec3 ReinhardToneMapping( vec3 color );
vec3 CineonToneMapping( vec3 color );
vec3 RRTAndODTFit( vec3 v );
vec3 ACESFilmicToneMapping( vec3 color );
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3( vec3( 1.6605, - 0.1246, - 0.0182 ), vec3( - 0.5876, 1.1329, - 0.1006 ), vec3( - 0.0728, - 0.0083, 1.1187 ) );
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3( vec3( 0.6274, 0.0691, 0.0164 ), vec3( 0.3293, 0.9195, 0.0880 ), vec3( 0.0433, 0.0113, 0.8956 ) );
vec3 agxDefaultContrastApprox( vec3 x );
vec3 AgXToneMapping( vec3 color );
vec3 NeutralToneMapping( vec3 color );
vec3 CustomToneMapping( vec3 color );
once OptimizedCineonToneMapping Uncharted2Helper Uncharted2ToneMapping toneMappingWhitePoint
//# transmission_fragment
from 129
#ifdef USE_TRANSMISSION
reads transmission thickness attenuationDistance attenuationColor
#ifdef USE_TRANSMISSIONMAP
reads transmissionMap vTransmissionMapUv
#endif
#ifdef USE_THICKNESSMAP
reads thicknessMap vThicknessMapUv
#endif
vec3 pos;
vec3 v;
vec3 n;
vec4 transmitted;
sets totalDiffuse
reads vWorldPosition cameraPosition normal viewMatrix modelMatrix projectionMatrix
#endif
once thicknessFactor transmission transmissionAlpha transmissionFactor
//# transmission_pars_fragment
from 129
#ifdef USE_TRANSMISSION
uniform float transmission;
uniform float thickness;
uniform float attenuationDistance;
uniform vec3 attenuationColor;
#ifdef USE_TRANSMISSIONMAP
uniform sampler2D transmissionMap;
#endif
#ifdef USE_THICKNESSMAP
uniform sampler2D thicknessMap;
#endif
uniform vec2 transmissionSamplerSize;
uniform sampler2D transmissionSamplerMap;
uniform mat4 modelMatrix;
uniform mat4 projectionMatrix;
varying vec3 vWorldPosition;
float w0( float a );
float w1( float a );
float w2( float a );
float w3( float a );
float g0( float a );
float g1( float a );
float h0( float a );
float h1( float a );
vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod );
vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod );
vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix );
float applyIorToRoughness( const in float roughness, const in float ior );
vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior );
vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance );
vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor, const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix, const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness, const in vec3 attenuationColor, const in float attenuationDistance );
#endif
once applyVolumeAttenuation
//# transmissionmap_fragment
from 119
until 128
//# transmissionmap_pars_fragment
from 119
until 128
once transmissionMap
//# uv2_pars_fragment
until 150
once vUv2
//# uv2_pars_vertex
until 150
once uv2 uv2Transform vUv2
//# uv2_vertex
until 150
//# uv_pars_fragment
#if defined( USE_UV ) || defined( USE_ANISOTROPY )
varying vec2 vUv;
#endif
#ifdef USE_MAP
varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
uniform mat3 transmissionMapTransform;
varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
uniform mat3 thicknessMapTransform;
varying vec2 vThicknessMapUv;
#endif
//# uv_pars_vertex
#if defined( USE_UV ) || defined( USE_ANISOTROPY )
varying vec2 vUv;
#endif
#ifdef USE_MAP
uniform mat3 mapTransform;
varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
uniform mat3 alphaMapTransform;
varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
uniform mat3 lightMapTransform;
varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
uniform mat3 aoMapTransform;
varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
uniform mat3 bumpMapTransform;
varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
uniform mat3 normalMapTransform;
varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
uniform mat3 displacementMapTransform;
varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
uniform mat3 emissiveMapTransform;
varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
uniform mat3 metalnessMapTransform;
varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
uniform mat3 roughnessMapTransform;
varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
uniform mat3 diffuseRoughnessMapTransform;
varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
uniform mat3 anisotropyMapTransform;
varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
uniform mat3 clearcoatMapTransform;
varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
uniform mat3 clearcoatNormalMapTransform;
varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
uniform mat3 clearcoatRoughnessMapTransform;
varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
uniform mat3 sheenColorMapTransform;
varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
uniform mat3 sheenRoughnessMapTransform;
varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
uniform mat3 iridescenceMapTransform;
varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
uniform mat3 iridescenceThicknessMapTransform;
varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
uniform mat3 specularMapTransform;
varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
uniform mat3 specularColorMapTransform;
varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
uniform mat3 specularIntensityMapTransform;
varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
uniform mat3 transmissionMapTransform;
varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
uniform mat3 thicknessMapTransform;
varying vec2 vThicknessMapUv;
#endif
once uvTransform
//# uv_vertex
#if defined( USE_UV ) || defined( USE_ANISOTROPY )
sets vUv
reads uv
#endif
#ifdef USE_MAP
sets vMapUv
reads mapTransform
#endif
#ifdef USE_ALPHAMAP
sets vAlphaMapUv
reads alphaMapTransform
#endif
#ifdef USE_LIGHTMAP
sets vLightMapUv
reads lightMapTransform
#endif
#ifdef USE_AOMAP
sets vAoMapUv
reads aoMapTransform
#endif
#ifdef USE_BUMPMAP
sets vBumpMapUv
reads bumpMapTransform
#endif
#ifdef USE_NORMALMAP
sets vNormalMapUv
reads normalMapTransform
#endif
#ifdef USE_DISPLACEMENTMAP
sets vDisplacementMapUv
reads displacementMapTransform
#endif
#ifdef USE_EMISSIVEMAP
sets vEmissiveMapUv
reads emissiveMapTransform
#endif
#ifdef USE_METALNESSMAP
sets vMetalnessMapUv
reads metalnessMapTransform
#endif
#ifdef USE_ROUGHNESSMAP
sets vRoughnessMapUv
reads roughnessMapTransform
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
sets vDiffuseRoughnessMapUv
reads diffuseRoughnessMapTransform
#endif
#ifdef USE_ANISOTROPYMAP
sets vAnisotropyMapUv
reads anisotropyMapTransform
#endif
#ifdef USE_CLEARCOATMAP
sets vClearcoatMapUv
reads clearcoatMapTransform
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
sets vClearcoatNormalMapUv
reads clearcoatNormalMapTransform
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
sets vClearcoatRoughnessMapUv
reads clearcoatRoughnessMapTransform
#endif
#ifdef USE_IRIDESCENCEMAP
sets vIridescenceMapUv
reads iridescenceMapTransform
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
sets vIridescenceThicknessMapUv
reads iridescenceThicknessMapTransform
#endif
#ifdef USE_SHEEN_COLORMAP
sets vSheenColorMapUv
reads sheenColorMapTransform
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
sets vSheenRoughnessMapUv
reads sheenRoughnessMapTransform
#endif
#ifdef USE_SPECULARMAP
sets vSpecularMapUv
reads specularMapTransform
#endif
#ifdef USE_SPECULAR_COLORMAP
sets vSpecularColorMapUv
reads specularColorMapTransform
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
sets vSpecularIntensityMapUv
reads specularIntensityMapTransform
#endif
#ifdef USE_TRANSMISSIONMAP
sets vTransmissionMapUv
reads transmissionMapTransform
#endif
#ifdef USE_THICKNESSMAP
sets vThicknessMapUv
reads thicknessMapTransform
#endif
//# worldpos_vertex
#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
vec4 worldPosition;
reads transformed
#ifdef USE_BATCHING
sets worldPosition
reads batchingMatrix
#endif
#ifdef USE_INSTANCING
sets worldPosition
reads instanceMatrix
#endif
sets worldPosition
reads modelMatrix
#endif
