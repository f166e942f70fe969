// luma.gl and deck.gl
//
// luma.gl keeps the `#version` line of the shader and inserts after it a prologue, the shader
// modules that the model requests, and the hooks. `#version` must be the first line; a shader
// without one is treated as GLSL ES 1.00 and converted to GLSL ES 3.00. Only fragment shaders get a
// precision.
//
// deck.gl adds the modules `geometry` and `layer` to every layer; nearly all layers request
// `project32` (which includes `project`) and `picking`. Modules have separate text for each stage:
// `project` and the picking setters exist in vertex shaders only, the picking filters in fragment
// shaders only. Without deck.gl, the module `project` of luma.gl is a different one: its block has
// viewMatrix, projectionMatrix, viewProjectionMatrix and cameraPositionWorld.
//
// Hooks may be written in JavaScript, as shader fragments with the keys 'vs:#decl',
// 'vs:#main-start', 'vs:#main-end', 'vs:DECKGL_FILTER_COLOR', 'fs:#decl', 'fs:#main-start',
// 'fs:#main-end', 'fs:DECKGL_FILTER_COLOR'. Such a fragment can use `color`, `size`, `position` and
// `geometry`.
//
// Not declared here: other modules, each of which has a uniform block with its own instance name
// (`scatterplot`, `lighting`, `material`, `shadow`, and those that users write), the defines of the
// model, and injected declarations.
//
// source: @luma.gl/shadertools 9.4.2, src/lib/shader-assembly/assemble-shaders.ts, src/modules/engine/picking/picking.ts, src/modules/math/fp32/fp32.ts; @deck.gl/core 9.4.0, src/shaderlib
// package: @luma.gl/ @deck.gl/ deck.gl
// word: DECKGL_FILTER_SIZE DECKGL_FILTER_GL_POSITION DECKGL_FILTER_COLOR project_position project_position_to_clipspace project_common_position_to_clipspace project_size_to_pixel project_pixel_size project_pixel_size_to_clipspace picking_setPickingColor picking_setPickingAttribute picking_filterColor picking_filterHighlightColor picking_filterPickingColor picking_getPickingColorFromIndex picking_vRGBcolor_Avalid lighting_getLightColor
// version: own
// names: some
// entry: main
#define DEFAULT_GPU
#define LUMA_FP64_CODE_ELIMINATION_WORKAROUND 1
#define LUMA_FP32_TAN_PRECISION_WORKAROUND 1
#define LUMA_FP64_HIGH_BITS_OVERFLOW_WORKAROUND 1
#define SMOOTH_EDGE_RADIUS 0.5
#ifdef VERTEX_SHADER
#define SHADER_TYPE_VERTEX
#endif
#ifdef FRAGMENT_SHADER
#define SHADER_TYPE_FRAGMENT
precision highp float;
#endif
#if __VERSION__ >= 300
layout(std140) uniform layerUniforms { float opacity; } layer;
layout(std140) uniform pickingUniforms {
  float isActive; float isAttribute; float isHighlightActive; float useByteColors;
  vec3 highlightedObjectColor; vec4 highlightColor;
  float disabledPickingIndexCount;
  vec4 disabledPickingIndices0; vec4 disabledPickingIndices1; vec4 disabledPickingIndices2;
} picking;
#ifdef VERTEX_SHADER
struct VertexGeometry {
  vec4 position; vec3 worldPosition; vec3 worldPositionAlt; vec3 normal; vec2 uv; vec3 pickingColor;
} geometry = VertexGeometry(vec4(0.0, 0.0, 1.0, 0.0), vec3(0.0), vec3(0.0), vec3(0.0), vec2(0.0), vec3(0.0));
void DECKGL_FILTER_SIZE(inout vec3 size, VertexGeometry geometry);
void DECKGL_FILTER_GL_POSITION(inout vec4 position, VertexGeometry geometry);
void DECKGL_FILTER_COLOR(inout vec4 color, VertexGeometry geometry);
// project, project32
layout(std140) uniform projectUniforms {
  bool wrapLongitude; int coordinateSystem; vec3 commonUnitsPerMeter; int projectionMode; float scale;
  vec3 commonUnitsPerWorldUnit; vec3 commonUnitsPerWorldUnit2; vec4 center; mat4 modelMatrix;
  mat4 viewProjectionMatrix; vec2 viewportSize; float devicePixelRatio; float focalDistance;
  vec3 cameraPosition; vec3 coordinateOrigin; vec3 commonOrigin; bool pseudoMeters;
} project;
const int COORDINATE_SYSTEM_DEFAULT = -1, COORDINATE_SYSTEM_LNGLAT = 1, COORDINATE_SYSTEM_METER_OFFSETS = 2,
  COORDINATE_SYSTEM_LNGLAT_OFFSETS = 3, COORDINATE_SYSTEM_CARTESIAN = 0;
const int PROJECTION_MODE_WEB_MERCATOR = 1, PROJECTION_MODE_GLOBE = 2,
  PROJECTION_MODE_WEB_MERCATOR_AUTO_OFFSET = 4, PROJECTION_MODE_IDENTITY = 0;
const int UNIT_COMMON = 0, UNIT_METERS = 1, UNIT_PIXELS = 2;
const float TILE_SIZE = 512.0;
const float PI = 3.1415926536;
const float WORLD_SCALE = TILE_SIZE / (PI * 2.0);
const vec3 ZERO_64_LOW = vec3(0.0);
const float EARTH_RADIUS = 6370972.0;
const float GLOBE_RADIUS = 256.0;
float tan_fp32(float a);
float project_size_at_latitude(float lat);
float project_size_at_latitude(float meters, float lat);
float project_size();
float project_size(float meters);
vec2 project_size(vec2 meters);
vec3 project_size(vec3 meters);
vec4 project_size(vec4 meters);
mat3 project_get_orientation_matrix(vec3 up);
bool project_needs_rotation(vec3 commonPosition, out mat3 transform);
vec3 project_normal(vec3 vector);
vec4 project_offset_(vec4 offset);
vec2 project_mercator_(vec2 lnglat);
vec3 project_globe_(vec3 lnglatz);
vec4 project_position(vec4 position, vec3 position64Low);
vec4 project_position(vec4 position);
vec3 project_position(vec3 position, vec3 position64Low);
vec3 project_position(vec3 position);
vec2 project_position(vec2 position);
vec4 project_common_position_to_clipspace(vec4 position, mat4 viewProjectionMatrix, vec4 center);
vec4 project_common_position_to_clipspace(vec4 position);
vec2 project_pixel_size_to_clipspace(vec2 pixels);
float project_size_to_pixel(float meters);
vec2 project_size_to_pixel(vec2 meters);
float project_size_to_pixel(float size, int unit);
float project_pixel_size(float pixels);
vec2 project_pixel_size(vec2 pixels);
vec4 project_position_to_clipspace(vec3 position, vec3 position64Low, vec3 offset, out vec4 commonPosition);
vec4 project_position_to_clipspace(vec3 position, vec3 position64Low, vec3 offset);
// picking
out vec4 picking_vRGBcolor_Avalid;
vec3 picking_normalizeColor(vec3 color);
vec4 picking_normalizeColor(vec4 color);
bool picking_isColorZero(vec3 color);
bool picking_isColorValid(vec3 color);
bool isVertexHighlighted(vec3 vertexColor);
void picking_setPickingColor(vec3 pickingColor);
void picking_setPickingAttribute(float value);
void picking_setPickingAttribute(vec2 value);
void picking_setPickingAttribute(vec3 value);
vec3 picking_getPickingColorFromIndex(float objectIndex);
vec3 picking_getPickingColorFromIndex(uint objectIndex);
vec3 picking_getPickingColorFromInstanceID();
void picking_setPickingColorFromInstanceID();
#endif
#ifdef FRAGMENT_SHADER
struct FragmentGeometry { vec2 uv; };
FragmentGeometry geometry;
float smoothedge(float edge, float x);
void DECKGL_FILTER_COLOR(inout vec4 color, FragmentGeometry geometry);
in vec4 picking_vRGBcolor_Avalid;
vec4 picking_filterHighlightColor(vec4 color);
vec4 picking_filterPickingColor(vec4 color);
vec4 picking_filterColor(vec4 color);
#endif
#endif
