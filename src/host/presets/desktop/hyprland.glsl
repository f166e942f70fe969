// Hyprland screen shader
//
// The Wayland compositor Hyprland draws the screen through the shader that `decoration:screen_shader`
// names; hyprshade switches between such files. A shader declares what it uses, reads the screen
// from `tex` at `v_texcoord`, and is not preprocessed: it has no includes.
//
// Since Hyprland 0.50 the vertex shader is GLSL ES 3.00, so that shaders must start with
// `#version 300 es`. Older ones fail to link there: "all shaders must use same shading language
// version". `time` and the names of the pointer only change if `debug:damage_tracking` is off.
// Positions have their origin in the upper left corner.
//
// source: src/render/OpenGL.cpp and src/render/Shader.cpp of hyprwm/Hyprland; loqusion/hyprshade, pull request 59
// reads: Hyprland
// version: own
// takes: late-version
// requires: 300 es, Hyprland 0.50
// names: some
// uniforms: all
// entry: main
#ifdef SHADER_DECLARES
uniform sampler2D tex; // = screen, top-first, usual
uniform float time; // = time
uniform int wl_output; // = nothing, usual
uniform vec2 screen_size; // = resolution, usual
uniform vec2 screenSize; // = resolution
uniform vec2 fullSize; // = resolution
uniform vec2 pointer_position; // = pointer-unit-down, usual
uniform vec2 pointer_pressed_positions[32]; // = nothing, own
uniform float pointer_pressed_times[32]; // = nothing, own
uniform float pointer_last_active; // = nothing, own
uniform float pointer_switch_time; // = nothing, own
uniform float pointer_inactive_timeout; // = nothing, own
uniform int pointer_hidden; // = nothing, own
uniform int pointer_killing; // = nothing, own
uniform int pointer_shape; // = nothing, own
uniform int pointer_shape_previous; // = nothing, own
uniform int pointer_pressed_killed; // = nothing, own
uniform int pointer_pressed_touched; // = nothing, own
uniform float pointer_size; // = nothing, own
in vec2 v_texcoord; // = vec2(port_place.x, 1.0 - port_place.y), usual
#endif
#ifdef SHADER_TEMPLATE
#version 300 es
precision highp float;
precision highp int;
out vec4 pixelColor;
#pragma screen
vec4 screenTexture(sampler2D s, vec2 p) { return texture(s, vec2(p.x, 1.0 - p.y)); }
vec4 screenTexture(sampler2D s, vec2 p, float bias) { return texture(s, vec2(p.x, 1.0 - p.y), bias); }
vec4 screenLod(sampler2D s, vec2 p, float lod) { return textureLod(s, vec2(p.x, 1.0 - p.y), lod); }
vec4 screenFetch(sampler2D s, ivec2 p, int lod) {
    return texelFetch(s, ivec2(p.x, textureSize(s, lod).y - 1 - p.y), lod);
}
#define texture screenTexture
#define textureLod screenLod
#define texelFetch screenFetch
#pragma code
void main() {
    vec2 pixel = floor(vec2(v_texcoord.x, 1.0 - v_texcoord.y) * screen_size);
    vec4 color = vec4(0.0, 0.0, 0.0, 1.0);
    port_image(color, pixel + 0.5);
    pixelColor = vec4(color.rgb, 1.0);
}
#endif
