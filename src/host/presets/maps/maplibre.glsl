// MapLibre GL
//
// MapLibre puts this before the shaders of its own layers, with `#version 300 es`, macros and the
// prelude of the projection (mercator or globe; the functions have the same names). Vertex shaders
// have highp float, fragment shaders mediump. With the macro TERRAIN3D there are also u_terrain,
// u_depth and the members of TerrainUBO.
//
// `#pragma maplibre: define highp vec4 color` creates, depending on the macro HAS_UNIFORM_u_color,
// either a uniform u_color or, in the vertex shader, an attribute a_color, a uniform u_color_t and,
// if the fragment shader has the same pragma, a varying `color`. `#pragma maplibre: initialize
// highp vec4 color` creates or sets the local `color` at that point. The name and type in a pragma
// are thus a declaration, which is not listed here.
//
// A custom layer gets nothing implicitly. Its shader starts with its own `#version 300 es` and
// inserts `shaderData.vertexShaderPrelude` and `shaderData.define` through placeholders of the
// JavaScript template. The vertex names below are available there too, but there is no prelude for
// its fragment shader.
//
// source: maplibre-gl 6.17.0, src/webgl/program.ts, src/shaders/shaders.ts, src/shaders/glsl/_prelude.vertex.glsl, _prelude.fragment.glsl, _projection_mercator.vertex.glsl
// package: maplibre-gl
// word: u_projection_matrix u_projection_fallback_matrix u_projection_transition projectTile projectTileWithElevation projectTileFor3D projectLineThickness projectCircleRadius clipAntimeridian u_units_to_pixels u_pixel_extrude_scale u_symbol_fade_change
// global: maplibregl
// version: 300 es
// names: some
// entry: main
#ifdef VERTEX_SHADER
precision highp float;
#endif
#ifdef FRAGMENT_SHADER
precision mediump float;
#endif
layout(std140) uniform ProjectionUBO {
  highp mat4 u_projection_matrix;
  highp mat4 u_projection_fallback_matrix;
  highp vec4 u_projection_tile_mercator_coords;
  highp vec4 u_projection_clipping_plane;
  highp float u_projection_transition;
  highp int u_projection_clip_antimeridian;
};
layout(std140) uniform FrameUBO {
  highp vec2 u_units_to_pixels;
  highp vec2 u_world_size;
  highp float u_camera_to_center_distance;
  highp float u_symbol_fade_change;
  highp float u_aspect_ratio;
  highp float u_device_pixel_ratio;
  highp vec2 u_viewport_size;
  highp vec2 u_pixel_extrude_scale;
  highp float u_pitch;
};
#ifdef VERTEX_SHADER
#define PROJECTION_UBO
const float PI = 3.141592653589793;
const highp vec4 bitSh = vec4(256. * 256. * 256., 256. * 256., 256., 1.);
const highp vec4 bitShifts = vec4(1.) / bitSh;
vec2 unpack_float(const float packedValue);
vec2 unpack_opacity(const uint packedOpacity);
vec4 decode_color(const vec2 encodedColor);
float unpack_mix_vec2(const vec2 packedValue, const float t);
vec4 unpack_mix_color(const vec4 packedColors, const float t);
vec2 get_pattern_pos(const vec2 pixel_coord_upper, const vec2 pixel_coord_lower,
  const vec2 pattern_size, const float tile_units_to_pixels, const vec2 pos);
mat3 rotationMatrixFromAxisAngle(vec3 u, float angle);
highp float unpack(highp vec4 color);
highp float depthOpacity(vec3 frag);
float calculate_visibility(vec4 pos);
float ele(ivec2 pos);
float get_elevation(vec2 pos);
float projectLineThickness(float tileY);
float projectCircleRadius(float tileY);
vec4 projectTile(vec2 p);
vec4 projectTile(vec2 p, vec2 rawPos);
vec4 projectTileWithElevation(vec2 posInTile, float elevation);
vec4 projectTileFor3D(vec2 posInTile, float elevation);
#endif
#ifdef FRAGMENT_SHADER
#ifndef OWN_OUTPUT
out highp vec4 fragColor;
#endif
void clipAntimeridian();
#endif
