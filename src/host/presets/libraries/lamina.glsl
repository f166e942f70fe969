// lamina
//
// A lamina layer (a class that extends Abstract) has a fragment shader, a vertex shader, or both.
// The text before main() and the body of main() are inserted into a three-custom-shader-material,
// so its csm_ variables and everything from three.js are available.
//
// main() is declared `void` but returns a value. `return vec4(...)` in a fragment shader is the
// colour of the layer and is blended into lamina_finalColor; `return vec3(...)` in a vertex shader
// is lamina_finalPosition.
//
// Names with the prefix u_, v_ or f_ are renamed for each layer. Uniforms must start with u_ and
// are static properties of the class, varyings start with v_, locals with f_. The shader declares
// its uniforms itself. Built-in layers have the placeholders lamina_mapping_template,
// lamina_noise_template and axes_template.
//
// base: three-custom-shader-material
// source: lamina 1.2.2, vanilla-BEVDQrzM.js; three-custom-shader-material 6.4.0; three 0.187.0
// package: lamina
// word: lamina_*
// entry: main
#ifdef VERTEX_SHADER
vec3 lamina_finalPosition;
vec3 lamina_finalNormal;
float lamina_map(float value, float min1, float max1, float min2, float max2);
float lamina_normalize(float v);
float lamina_noise_mod289(float x); vec4 lamina_noise_mod289(vec4 x);
vec4 lamina_noise_perm(vec4 x); vec4 lamina_noise_permute(vec4 x);
vec4 lamina_noise_taylorInvSqrt(vec4 r); float lamina_noise_white(vec2 p);
float lamina_noise_white(vec3 p); vec3 lamina_noise_fade(vec3 t); float lamina_noise_perlin(vec3 P);
float lamina_noise_simplex(vec3 v); vec3 lamina_noise_simplex3(vec3 x);
vec3 lamina_noise_curl(vec3 p); vec3 lamina_permute(vec3 x);
vec3 lamina_dist(vec3 x, vec3 y, vec3 z, bool manhattanDistance); float lamina_noise_worley(vec3 P);
float lamina_noise_swirl(vec3 position);
#endif
#ifdef FRAGMENT_SHADER
uniform vec3 u_lamina_color;
uniform float u_lamina_alpha;
vec4 lamina_finalColor;
float lamina_map(float value, float min1, float max1, float min2, float max2);
float lamina_normalize(float v);
float lamina_noise_mod289(float x); vec4 lamina_noise_mod289(vec4 x);
vec4 lamina_noise_perm(vec4 x); vec4 lamina_noise_permute(vec4 x);
vec4 lamina_noise_taylorInvSqrt(vec4 r); float lamina_noise_white(vec2 p);
float lamina_noise_white(vec3 p); vec3 lamina_noise_fade(vec3 t); float lamina_noise_perlin(vec3 P);
float lamina_noise_simplex(vec3 v); vec3 lamina_noise_simplex3(vec3 x);
vec3 lamina_noise_curl(vec3 p); vec3 lamina_permute(vec3 x);
vec3 lamina_dist(vec3 x, vec3 y, vec3 z, bool manhattanDistance); float lamina_noise_worley(vec3 P);
float lamina_noise_swirl(vec3 position);
vec4 lamina_blend_add(const in vec4 x, const in vec4 y, const in float opacity);
vec3 lamina_blend_alpha(const in vec3 x, const in vec3 y, const in float opacity);
vec4 lamina_blend_alpha(const in vec4 x, const in vec4 y, const in float opacity);
vec4 lamina_blend_average(const in vec4 x, const in vec4 y, const in float opacity);
float lamina_blend_color_burn(const in float x, const in float y);
vec4 lamina_blend_color_burn(const in vec4 x, const in vec4 y, const in float opacity);
float lamina_blend_color_dodge(const in float x, const in float y);
vec4 lamina_blend_color_dodge(const in vec4 x, const in vec4 y, const in float opacity);
vec4 lamina_blend_darken(const in vec4 x, const in vec4 y, const in float opacity);
vec4 lamina_blend_difference(const in vec4 x, const in vec4 y, const in float opacity);
float lamina_blend_divide(const in float x, const in float y);
vec4 lamina_blend_divide(const in vec4 x, const in vec4 y, const in float opacity);
vec4 lamina_blend_exclusion(const in vec4 x, const in vec4 y, const in float opacity);
vec4 lamina_blend_lighten(const in vec4 x, const in vec4 y, const in float opacity);
vec4 lamina_blend_multiply(const in vec4 x, const in vec4 y, const in float opacity);
vec4 lamina_blend_negation(const in vec4 x, const in vec4 y, const in float opacity);
vec4 lamina_blend_normal(const in vec4 x, const in vec4 y, const in float opacity);
float lamina_blend_overlay(const in float x, const in float y);
vec4 lamina_blend_overlay(const in vec4 x, const in vec4 y, const in float opacity);
float lamina_blend_reflect(const in float x, const in float y);
vec4 lamina_blend_reflect(const in vec4 x, const in vec4 y, const in float opacity);
vec4 lamina_blend_screen(const in vec4 x, const in vec4 y, const in float opacity);
float lamina_blend_softlight(const in float x, const in float y);
vec4 lamina_blend_softlight(const in vec4 x, const in vec4 y, const in float opacity);
vec4 lamina_blend_subtract(const in vec4 x, const in vec4 y, const in float opacity);
#endif
