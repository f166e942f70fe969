// Cesium
//
// ShaderSource of CesiumJS puts `#version 300 es` before every shader: materials, post-process
// stages, custom shaders of models and its own shaders. It adds a precision for float and int in
// fragment shaders and one for sampler3D in both stages. Then it adds the names with the prefix
// czm_ that the shader uses, with their dependencies: automatic uniforms, constants, structures and
// functions. So every czm_ name below may be used without a declaration, and no others.
//
// A `#version` in the shader is moved to the top, as are `#extension` lines, and the first
// `precision ... float;` or `int;` line is removed. The output out_FragColor is declared if the
// shader uses it. This applies to WebGL 2; for WebGL 1 the shader is converted back to GLSL ES
// 1.00.
//
// A post-process stage declares `uniform sampler2D colorTexture`, `depthTexture` and `in vec2
// v_textureCoordinates` itself. czm_selected() exists in post-process stages with a selection. A
// material (Fabric) defines `czm_material czm_getMaterial(czm_materialInput materialInput)`; its
// uniforms come from a JavaScript object and are not declared here, and a word such as `channels`
// is replaced by the value in that object.
//
// A custom shader of a model defines `void vertexMain(VertexInput vsInput, inout
// czm_modelVertexOutput vsOutput)` and/or `void fragmentMain(FragmentInput fsInput, inout
// czm_modelMaterial material)`. Not declared here: the structures VertexInput and FragmentInput,
// the uniforms (u_*) and the varyings (v_*), which are generated for the model. czm_modelMaterial
// is declared with the members that depend on USE_SPECULAR, USE_ANISOTROPY and USE_CLEARCOAT.
//
// source: @cesium/engine 26.3.0, Source/Renderer/ShaderSource.js, Source/Renderer/AutomaticUniforms.js, Source/Shaders/Builtin, Source/Scene/Model/CustomShader.js
// package: @cesium/ cesium resium
// word: czm_*
// global: Cesium
// version: 300 es
// takes: version
// names: some
// entry: main czm_getMaterial vertexMain fragmentMain
precision highp sampler3D;
#define OES_texture_float_linear
#define OES_texture_float
#ifdef FRAGMENT_SHADER
precision highp float;
precision highp int;
#ifndef OWN_OUTPUT
layout(location = 0) out vec4 out_FragColor;
#endif
#endif
uniform vec4 czm_viewport, czm_frustumPlanes, czm_backgroundColor, czm_invertClassificationColor;
uniform mat4 czm_viewportOrthographic, czm_viewportTransformation, czm_model, czm_inverseModel,
    czm_view, czm_view3D, czm_inverseView, czm_inverseView3D, czm_projection, czm_inverseProjection,
    czm_infiniteProjection, czm_modelView, czm_modelView3D, czm_modelViewRelativeToEye,
    czm_inverseModelView, czm_inverseModelView3D, czm_viewProjection, czm_inverseViewProjection,
    czm_modelViewProjection, czm_inverseModelViewProjection, czm_modelViewProjectionRelativeToEye,
    czm_modelViewInfiniteProjection, czm_modelToEnu, czm_enuToModel;
uniform sampler2D czm_globeDepthTexture, czm_edgeIdTexture, czm_edgeColorTexture,
    czm_edgeDepthTexture, czm_planarFillIdTexture, czm_brdfLut;
uniform mat3 czm_viewRotation, czm_viewRotation3D, czm_inverseViewRotation,
    czm_inverseViewRotation3D, czm_normal, czm_normal3D, czm_inverseNormal, czm_inverseNormal3D,
    czm_eyeToEnu, czm_temeToPseudoFixed;
uniform float czm_orthographicIn3D, czm_eyeHeight, czm_farDepthFromNearPlusOne,
    czm_log2FarDepthFromNearPlusOne, czm_oneOverLog2FarDepthFromNearPlusOne, czm_frameNumber,
    czm_morphTime, czm_sceneMode, czm_pass, czm_specularEnvironmentMapsMaximumLOD, czm_pixelRatio,
    czm_fogDensity, czm_fogVisualDensityScalar, czm_fogMinimumBrightness,
    czm_atmosphereLightIntensity, czm_atmosphereRayleighScaleHeight, czm_atmosphereMieScaleHeight,
    czm_atmosphereMieAnisotropy, czm_atmosphereDynamicLighting, czm_splitPosition,
    czm_geometricToleranceOverMeter, czm_minimumDisableDepthTestDistance, czm_gamma;
uniform vec3 czm_eyeCartographic, czm_eyeEllipsoidNormalEC, czm_sunPositionWC,
    czm_sunPositionColumbusView, czm_sunDirectionEC, czm_sunDirectionWC, czm_moonDirectionEC,
    czm_lightDirectionEC, czm_lightDirectionWC, czm_lightColor, czm_lightColorHdr,
    czm_encodedCameraPositionMCHigh, czm_encodedCameraPositionMCLow, czm_viewerPositionWC,
    czm_sphericalHarmonicCoefficients[9], czm_atmosphereHsbShift, czm_atmosphereRayleighCoefficient,
    czm_atmosphereMieCoefficient, czm_ellipsoidRadii, czm_ellipsoidInverseRadii;
uniform vec2 czm_eyeHeight2D, czm_eyeEllipsoidCurvature, czm_entireFrustum, czm_currentFrustum;
uniform samplerCube czm_environmentMap, czm_specularEnvironmentMaps;
const float czm_degreesPerRadian = 57.29577951308232, czm_epsilon1 = 0.1, czm_epsilon2 = 0.01,
    czm_epsilon3 = 0.001, czm_epsilon4 = 0.0001, czm_epsilon5 = 0.00001, czm_epsilon6 = 0.000001,
    czm_epsilon7 = 0.0000001, czm_infinity = 5906376272000.0, czm_oneOverPi = 0.3183098861837907,
    czm_oneOverTwoPi = 0.15915494309189535, czm_passCesium3DTile = 6.0,
    czm_passCesium3DTileClassification = 7.0, czm_passCesium3DTileClassificationIgnoreShow = 8.0,
    czm_passCesium3DTileEdges = 4.0, czm_passCesium3DTileEdgesDirect = 12.0,
    czm_passCesium3DTilePlanarFillId = 5.0, czm_passClassification = 8.0, czm_passCompute = 1.0,
    czm_passEnvironment = 0.0, czm_passGaussianSplats = 12.0, czm_passGlobe = 2.0,
    czm_passOpaque = 9.0, czm_passOverlay = 13.0, czm_passTerrainClassification = 3.0,
    czm_passTranslucent = 10.0, czm_passVoxels = 11.0, czm_pi = 3.141592653589793,
    czm_piOverFour = 0.7853981633974483, czm_piOverSix = 0.5235987755982988,
    czm_piOverThree = 1.0471975511965976, czm_piOverTwo = 1.5707963267948966,
    czm_radiansPerDegree = 0.017453292519943295, czm_sceneMode2D = 2.0, czm_sceneMode3D = 3.0,
    czm_sceneModeColumbusView = 1.0, czm_sceneModeMorphing = 0.0, czm_solarRadius = 695500000.0,
    czm_threePiOver2 = 4.71238898038469, czm_twoPi = 6.283185307179586,
    czm_webMercatorMaxLatitude = 1.4844222297453324;
struct czm_depthRangeStruct { float near; float far; };
const czm_depthRangeStruct czm_depthRange = czm_depthRangeStruct(0.0, 1.0);
struct czm_material {
  vec3 diffuse; float specular; float shininess; vec3 normal; vec3 emission; float alpha;
};
struct czm_materialInput {
  float s; vec2 st; vec3 str; vec3 normalEC; mat3 tangentToEyeMatrix; vec3 positionToEyeEC;
  float height; float slope; float aspect; float waterMask;
};
struct czm_modelMaterial {
  vec4 baseColor; vec3 diffuse; float alpha; vec3 specular; float roughness; vec3 normalEC;
  float occlusion; vec3 emissive; float specularWeight; vec3 anisotropicT; vec3 anisotropicB;
  float anisotropyStrength; float clearcoatFactor; float clearcoatRoughness; vec3 clearcoatNormal;
};
struct czm_modelVertexOutput { vec3 positionMC; float pointSize; };
struct czm_ray { vec3 origin; vec3 direction; };
struct czm_raySegment { float start; float stop; };
const czm_raySegment czm_emptyRaySegment = czm_raySegment(-czm_infinity, -czm_infinity);
const czm_raySegment czm_fullRaySegment = czm_raySegment(0.0, czm_infinity);
struct czm_shadowParameters {
  vec2 texCoords; float depthBias; float depth; float nDotL; vec2 texelStepSize;
  float normalShadingSmooth; float darkness;
};
vec3 czm_HSBToRGB(vec3 hsb);
vec3 czm_HSLToRGB(vec3 hsl);
vec3 czm_RGBToHSB(vec3 rgb);
vec3 czm_RGBToHSL(vec3 rgb);
vec3 czm_RGBToXYZ(vec3 rgb);
vec3 czm_XYZToRGB(vec3 Yxy);
vec3 czm_acesTonemapping(vec3 color);
float czm_alphaWeight(float a);
vec3 czm_applyHSBShift(vec3 rgb, vec3 hsbShift, bool ignoreBlackPixels);
vec2 czm_approximateSphericalCoordinates(vec3 normal);
float czm_approximateTanh(float x);
float czm_branchFreeTernary(bool comparison, float a, float b); vec2 czm_branchFreeTernary(bool comparison, vec2 a, vec2 b);
vec3 czm_branchFreeTernary(bool comparison, vec3 a, vec3 b); vec4 czm_branchFreeTernary(bool comparison, vec4 a, vec4 b);
vec4 czm_cascadeColor(vec4 weights);
float czm_cascadeDistance(vec4 weights);
mat4 czm_cascadeMatrix(vec4 weights);
vec4 czm_cascadeWeights(float depthEye);
vec4 czm_columbusViewMorph(vec4 position2D, vec4 position3D, float time);
vec4 czm_computeAtmosphereColor(vec3 positionWC, vec3 lightDirection, vec3 rayleighColor, vec3 mieColor, float opacity);
vec4 czm_computeAtmosphereColor(czm_ray primaryRay, vec3 lightDirection, vec3 rayleighColor, vec3 mieColor, float opacity);
void czm_computeGroundAtmosphereScattering(vec3 positionWC, vec3 lightDirection, out vec3 rayleighColor, out vec3 mieColor, out float opacity);
void czm_computeScattering(czm_ray primaryRay, float primaryRayLength, vec3 lightDirection, float atmosphereInnerRadius, out vec3 rayleighColor, out vec3 mieColor, out float opacity);
vec2 czm_computeTextureTransform(vec2 texCoord, mat3 textureTransform);
vec2 czm_cosineAndSine(float angle);
vec4 czm_decodeRGB8(float encoded);
vec2 czm_decompressTextureCoordinates(float encoded);
mat3 czm_eastNorthUpToEyeCoordinates(vec3 positionMC, vec3 normalEC);
bool czm_ellipsoidContainsPoint(vec3 ellipsoid_inverseRadii, vec3 point);
vec2 czm_ellipsoidTextureCoordinates(vec3 normal);
bool czm_equalsEpsilon(vec4 left, vec4 right, float epsilon); bool czm_equalsEpsilon(vec3 left, vec3 right, float epsilon);
bool czm_equalsEpsilon(vec2 left, vec2 right, float epsilon); bool czm_equalsEpsilon(float left, float right, float epsilon);
vec4 czm_eyeOffset(vec4 positionEC, vec3 eyeOffset);
vec3 czm_eyeToCartographicDelta(vec3 positionEC);
vec4 czm_eyeToWindowCoordinates(vec4 positionEC);
float czm_fastApproximateAtan(float x); float czm_fastApproximateAtan(float x, float y);
vec3 czm_fog(float distanceToCamera, vec3 color, vec3 fogColor);
vec3 czm_fog(float distanceToCamera, vec3 color, vec3 fogColor, float fogModifierConstant);
vec3 czm_gammaCorrect(vec3 color); vec4 czm_gammaCorrect(vec4 color);
vec3 czm_geodeticSurfaceNormal(vec3 positionOnEllipsoid, vec3 ellipsoidCenter, vec3 oneOverEllipsoidRadiiSquared);
czm_material czm_getDefaultMaterial(czm_materialInput materialInput);
vec3 czm_getDynamicAtmosphereLightDirection(vec3 positionWC, float lightEnum);
float czm_getLambertDiffuse(vec3 lightDirectionEC, vec3 normalEC);
float czm_getSpecular(vec3 lightDirectionEC, vec3 toEyeEC, vec3 normalEC, float shininess);
vec4 czm_getWaterNoise(sampler2D normalMap, vec2 uv, float time, float angleInRadians);
vec3 czm_hue(vec3 rgb, float adjustment);
vec3 czm_inverseGamma(vec3 color);
bool czm_isEmpty(czm_raySegment interval);
bool czm_isFull(czm_raySegment interval);
float czm_latitudeToWebMercatorFraction(float latitude, float southMercatorY, float oneOverMercatorHeight);
float czm_lineDistance(vec2 point1, vec2 point2, vec2 point);
vec3 czm_linearToSrgb(vec3 linearIn); vec4 czm_linearToSrgb(vec4 linearIn);
float czm_luminance(vec3 rgb);
float czm_maximumComponent(vec2 v); float czm_maximumComponent(vec3 v); float czm_maximumComponent(vec4 v);
float czm_metersPerPixel(vec4 positionEC, float pixelRatio); float czm_metersPerPixel(vec4 positionEC);
vec4 czm_modelToWindowCoordinates(vec4 position);
vec3 czm_multiplyWithColorBalance(vec3 left, vec3 right);
float czm_nearFarScalar(vec4 nearFarScalar, float cameraDistSq);
vec3 czm_octDecode(vec2 encoded, float range); vec3 czm_octDecode(vec2 encoded); vec3 czm_octDecode(float encoded);
void czm_octDecode(vec2 encoded, out vec3 vector1, out vec3 vector2, out vec3 vector3);
vec4 czm_packDepth(float depth);
vec3 czm_pbrLighting(vec3 viewDirectionEC, vec3 normalEC, vec3 lightDirectionEC, czm_modelMaterial material);
vec3 czm_pbrNeutralTonemapping(vec3 color);
vec4 czm_phong(vec3 toEye, czm_material material, vec3 lightDirectionEC);
float czm_planeDistance(vec4 plane, vec3 point); float czm_planeDistance(vec3 planeNormal, float planeDistance, vec3 point);
vec3 czm_pointAlongRay(czm_ray ray, float time);
czm_raySegment czm_rayEllipsoidIntersectionInterval(czm_ray ray, vec3 ellipsoid_center, vec3 ellipsoid_inverseRadii);
czm_raySegment czm_raySphereIntersectionInterval(czm_ray ray, vec3 center, float radius);
float czm_readDepth(sampler2D depthTexture, vec2 texCoords);
float czm_readNonPerspective(float value, float oneOverW); vec2 czm_readNonPerspective(vec2 value, float oneOverW);
vec3 czm_readNonPerspective(vec3 value, float oneOverW); vec4 czm_readNonPerspective(vec4 value, float oneOverW);
float czm_reverseLogDepth(float logZ);
float czm_round(float value); vec2 czm_round(vec2 value); vec3 czm_round(vec3 value); vec4 czm_round(vec4 value);
vec3 czm_saturation(vec3 rgb, float adjustment);
float czm_sampleShadowMap(highp samplerCube shadowMap, vec3 d); float czm_sampleShadowMap(highp sampler2D shadowMap, vec2 uv);
float czm_shadowDepthCompare(samplerCube shadowMap, vec3 uv, float depth);
float czm_shadowDepthCompare(sampler2D shadowMap, vec2 uv, float depth);
float czm_shadowVisibility(samplerCube shadowMap, czm_shadowParameters shadowParameters);
float czm_shadowVisibility(sampler2D shadowMap, czm_shadowParameters shadowParameters);
float czm_signNotZero(float value); vec2 czm_signNotZero(vec2 value); vec3 czm_signNotZero(vec3 value);
vec4 czm_signNotZero(vec4 value);
vec3 czm_sphericalHarmonics(vec3 normal, vec3 coefficients[9]);
vec3 czm_srgbToLinear(vec3 srgbIn); vec4 czm_srgbToLinear(vec4 srgbIn);
mat3 czm_tangentToEyeSpaceMatrix(vec3 normalEC, vec3 tangentEC, vec3 bitangentEC);
vec4 czm_textureCube(samplerCube sampler, vec3 p); vec4 czm_textureCube(samplerCube sampler, vec3 p, float lod);
vec4 czm_transformPlane(vec4 plane, mat4 transform);
vec4 czm_translateRelativeToEye(vec3 high, vec3 low);
vec4 czm_translucentPhong(vec3 toEye, czm_material material, vec3 lightDirectionEC);
mat2 czm_transpose(mat2 matrix); mat3 czm_transpose(mat3 matrix); mat4 czm_transpose(mat4 matrix);
float czm_unpackDepth(vec4 packedDepth);
float czm_unpackFloat(vec4 packedFloat);
uint czm_unpackTexture(float packedValue); uint czm_unpackTexture(vec2 packedValue); uint czm_unpackTexture(vec3 packedValue);
uint czm_unpackTexture(vec4 packedValue);
int czm_unpackUint(float packedValue); int czm_unpackUint(vec2 packedValue); int czm_unpackUint(vec3 packedValue);
int czm_unpackUint(vec4 packedValue);
float czm_valueTransform(float offset, float scale, float value); vec2 czm_valueTransform(vec2 offset, vec2 scale, vec2 value);
vec3 czm_valueTransform(vec3 offset, vec3 scale, vec3 value); vec4 czm_valueTransform(vec4 offset, vec4 scale, vec4 value);
mat2 czm_valueTransform(mat2 offset, mat2 scale, mat2 value); mat3 czm_valueTransform(mat3 offset, mat3 scale, mat3 value);
mat4 czm_valueTransform(mat4 offset, mat4 scale, mat4 value);
vec4 czm_screenToEyeCoordinates(vec4 screenCoordinate);
vec4 czm_windowToEyeCoordinates(vec4 fragmentCoordinate);
vec4 czm_screenToEyeCoordinates(vec2 screenCoordinateXY, float depthOrLogDepth);
vec4 czm_windowToEyeCoordinates(vec2 fragmentCoordinateXY, float depthOrLogDepth);
float czm_writeNonPerspective(float value, float w); vec2 czm_writeNonPerspective(vec2 value, float w);
vec3 czm_writeNonPerspective(vec3 value, float w); vec4 czm_writeNonPerspective(vec4 value, float w);
#ifdef VERTEX_SHADER
vec4 czm_computePosition();
vec4 czm_depthClamp(vec4 coords);
vec4 czm_updatePositionDepth(vec4 coords);
void czm_vertexLogDepth(); void czm_vertexLogDepth(vec4 clipCoords);
#endif
#ifdef FRAGMENT_SHADER
vec4 czm_antialias(vec4 color1, vec4 color2, vec4 currentColor, float dist, float fuzzFactor);
vec4 czm_antialias(vec4 color1, vec4 color2, vec4 currentColor, float dist);
bool czm_backFacing();
void czm_writeDepthClamp();
void czm_writeLogDepth(float depth); void czm_writeLogDepth();
#endif
