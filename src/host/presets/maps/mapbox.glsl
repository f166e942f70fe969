// Mapbox GL
//
// Mapbox puts `#version 300 es`, macros and this prelude before the shaders of its own layers.
// Vertex shaders have highp float, fragment shaders mediump. A custom layer gets nothing: its
// shader is compiled as written.
//
// Pragmas declare the values of a style: `#pragma mapbox: define highp vec4 color` and `#pragma
// mapbox: initialize highp vec4 color` create a uniform u_color, an attribute a_color or a varying,
// and the local `color`. `#include "_prelude_fog.fragment.glsl"` and similar add more names.
//
// Not declared here: names that depend on macros such as RENDER_CUTOFF and PROJECTION_GLOBE_VIEW.
//
// source: mapbox-gl 3.32.0, dist/mapbox-gl-dev.js (FRAGMENT_PRELUDE_BLOCK, VERTEX_PRELUDE_BLOCK, class Program)
// package: mapbox-gl
// word: storeEmissiveColor HANDLE_WIREFRAME_DEBUG unpack_mix_vec2 unpack_mix_color decomposeToPosAndSkirt FLIP_VIEWPORT_UV_Y textureLodCustom viewport_dither_index
// global: mapboxgl
// version: 300 es
// names: some
// entry: main
// include: "..."
#define EPSILON 0.0000001
#define PI 3.141592653589793
#ifdef VERTEX_SHADER
precision highp float;
#define EXTENT 8192.0
#define RAD_TO_DEG 180.0/PI
#define DEG_TO_RAD PI/180.0
#define GLOBE_RADIUS EXTENT/PI/2.0
#define GET_ATTRIBUTE_float(attrib, matInfo, attrib_id) attrib
#define GET_ATTRIBUTE_vec2(attrib, matInfo, attrib_id) attrib
#define GET_ATTRIBUTE_vec4(attrib, matInfo, attrib_id) attrib
#define DECLARE_MATERIAL_TABLE_INFO
const vec4 AWAY = vec4(-1000.0, -1000.0, -1000.0, 1);
const float skirtOffset = 24575.0;
float wrap(float n, float min, float max);
vec2 unpack_float(const float packedValue);
vec4 decode_color(const vec2 encodedColor);
float unpack_mix_vec2(const vec2 packedValue, const float t);
vec4 unpack_mix_color(const vec4 packedColors, const float t);
vec2 get_pattern_pos(const vec2 pixel_coord_upper, const vec2 pixel_coord_lower,
  const vec2 pattern_size, const vec2 units_to_pixels, const vec2 pos);
vec2 get_pattern_pos(const vec2 pixel_coord_upper, const vec2 pixel_coord_lower,
  const vec2 pattern_size, const float tile_units_to_pixels, const vec2 pos);
float mercatorXfromLng(float lng);
float mercatorYfromLat(float lat);
vec3 latLngToECEF(vec2 latLng);
vec3 decomposeToPosAndSkirt(ivec2 posWithComposedSkirt);
#endif
#ifdef FRAGMENT_SHADER
precision mediump float;
#define FLIP_VIEWPORT_UV_Y(uv)
#define HANDLE_WIREFRAME_DEBUG
#ifndef OWN_OUTPUT
layout(location = 0) out vec4 glFragColor;
#endif
const float DITHER_THRESHOLDS[16] = float[16](
  1.0/17.0, 9.0/17.0, 3.0/17.0, 11.0/17.0, 13.0/17.0, 5.0/17.0, 15.0/17.0, 7.0/17.0,
  4.0/17.0, 12.0/17.0, 2.0/17.0, 10.0/17.0, 16.0/17.0, 8.0/17.0, 14.0/17.0, 6.0/17.0);
highp float unpack_depth(highp vec4 rgba_depth);
highp vec4 pack_depth(highp float ndc_z);
int viewport_dither_index(vec2 fragCoordXY);
vec4 textureLodCustom(sampler2D image, highp vec2 pos, highp vec2 lod_coord);
vec4 premultiplyColor(vec3 nonPremultipliedColor, float a);
vec3 unpremultiplyColor(vec4 premultipliedColor);
vec3 applyLUT(highp sampler3D lut, vec3 col);
vec4 applyLUT(highp sampler3D lut, vec4 premultipliedColor);
void storeEmissiveColor(vec4 color, float emissiveStrength);
#endif
