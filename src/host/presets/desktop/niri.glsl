// niri
//
// The Wayland compositor niri animates windows with shaders in its configuration:
// `animations { window-open { custom-shader r"..." } }`. A shader defines one of `open_color`,
// `close_color` and `resize_color`, which return the premultiplied colour of a pixel. niri puts the
// declarations below before it and appends main(). Its errors are only in the log.
//
// Coordinates have their origin in the upper left corner of the window and are 1 in the lower right
// one; they may be outside of 0 to 1. A matrix maps them to a texture, such as
// `niri_tex` with `niri_geo_to_tex * coords_geo`. `niri_progress` may exceed 1, as springs do;
// `niri_clamped_progress` does not.
//
// source: src/render_helpers/shaders/*_prelude.frag and *_epilogue.frag of YaLTeR/niri
// word: niri_*
// shows: usual open_color
// shows: usual close_color
// shows: usual resize_color
// version: 100
// names: all
// entry: open_color close_color resize_color
// composes: yes
precision highp float;
uniform sampler2D niri_tex; // = screen, top-first
uniform sampler2D niri_tex_prev; // = screen, top-first
uniform sampler2D niri_tex_next; // = screen, top-first
uniform mat3 niri_geo_to_tex; // = identity
uniform mat3 niri_geo_to_tex_prev; // = identity
uniform mat3 niri_geo_to_tex_next; // = identity
uniform mat3 niri_curr_geo_to_prev_geo; // = identity
uniform mat3 niri_curr_geo_to_next_geo; // = identity
uniform mat3 niri_input_to_geo; // = identity
uniform mat3 niri_input_to_curr_geo; // = identity
/// The size of the window in logical pixels.
uniform vec2 niri_geo_size; // = resolution
/// The size of the area that is drawn, in logical pixels.
uniform vec2 niri_size; // = resolution
uniform vec2 niri_curr_geo_size; // = resolution
uniform float niri_progress; // = progress
uniform float niri_clamped_progress; // = progress
/// A random number from 0 to 1, other for each animation.
uniform float niri_random_seed; // = nothing
uniform vec4 niri_corner_radius; // = nothing
uniform float niri_clip_to_geometry; // = nothing
uniform float niri_alpha; // = ones
uniform float niri_scale; // = ones
#ifdef SHADER_MAIN
// A window of two thirds of the image, in front of a plain background.
void main() {
    vec2 port_at = gl_FragCoord.xy / niri_size - 0.5;
    vec3 port_geo = vec3(1.5 * vec2(port_at.x, -port_at.y) + 0.5, 1.0);
    vec4 port_window = port_entry(port_geo, vec3(niri_geo_size, 1.0)) * niri_alpha;
    vec3 port_behind = vec3(0.16, 0.18, 0.24);
    gl_FragColor = vec4(port_window.rgb + (1.0 - port_window.a) * port_behind, 1.0);
}
#endif
#ifdef SHADER_TEMPLATE
#pragma screen
vec4 texture(sampler2D s, vec2 p) {
    return texture2D(s, (niri_geo_to_tex * vec3(p.x, 1.0 - p.y, 1.0)).st);
}
vec4 texture(sampler2D s, vec2 p, float bias) {
    return texture2D(s, (niri_geo_to_tex * vec3(p.x, 1.0 - p.y, 1.0)).st, bias);
}
#pragma code
vec4 open_color(vec3 coords_geo, vec3 size_geo) {
    vec2 pixel = floor(vec2(coords_geo.x, 1.0 - coords_geo.y) * size_geo.xy * niri_scale);
    vec4 color = vec4(0.0, 0.0, 0.0, 1.0);
    port_image(color, (pixel + 0.5) / niri_scale);
    vec2 inside = step(0.0, coords_geo.xy) * step(coords_geo.xy, vec2(1.0));
    return vec4(color.rgb, 1.0) * inside.x * inside.y;
}
#pragma host
void main() {
    vec2 place = gl_FragCoord.xy / niri_geo_size;
    gl_FragColor = open_color(vec3(place.x, 1.0 - place.y, 1.0), vec3(niri_geo_size, 1.0));
}
#endif
