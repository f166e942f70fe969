// Butterchurn
//
// A Milkdrop preset for Butterchurn has two fragment shaders, `warp` and `comp`. The text before
// shader_body goes before main(), the text between its braces becomes the body of main(). Both are
// compiled as GLSL ES 3.00, texture2D and texture3D are replaced by texture, and the result is the
// local `ret`. The host provides the vertex shader.
//
// The two shaders have mostly the same names. Only `warp` has `decay`. Only `comp` has gammaAdj,
// echo_zoom, echo_alpha, echo_orientation, invert, brighten, darken, solarize, fShader, lum() and
// hue_shader. In `warp`, uv and uv_orig are read-only inputs.
//
// The locals of main() (ret, rad, ang, in `comp` also uv, uv_orig, hue_shader) are declared below
// as variables, and shader_body as a macro for main(). A preset declares the samplers that it adds:
// `uniform sampler2D sampler_NAME;`.
//
// source: butterchurn 2.6.7, lib/butterchurn.js (createShader of the warp and comp shaders, ShaderUtils)
// package: butterchurn butterchurn-presets
// word: shader_body sampler_main sampler_fw_main sampler_fc_main sampler_pw_main sampler_pc_main sampler_noise_lq sampler_noise_mq sampler_noise_hq sampler_noise_lq_lite sampler_noisevol_lq sampler_noisevol_hq sampler_pw_noise_lq hue_shader texsize_noise_lq texsize_noise_mq texsize_noise_hq slow_roam_cos slow_roam_sin
// version: 300 es
// names: some
// entry: shader_body main
#ifdef FRAGMENT_SHADER
precision highp float;
precision highp int;
precision mediump sampler2D;
precision mediump sampler3D;
#define texture2D texture
#define texture3D texture
#define shader_body void main()
in vec2 vUv;
in vec4 vColor;
out vec4 fragColor;
vec2 uv, uv_orig;
vec3 ret, hue_shader;
float rad, ang;
vec3 lum(vec3 v);
uniform sampler2D sampler_main, sampler_fw_main, sampler_fc_main, sampler_pw_main, sampler_pc_main;
uniform sampler2D sampler_blur1, sampler_blur2, sampler_blur3;
uniform sampler2D sampler_noise_lq, sampler_noise_lq_lite, sampler_noise_mq, sampler_noise_hq;
uniform sampler2D sampler_pw_noise_lq;
uniform sampler3D sampler_noisevol_lq, sampler_noisevol_hq;
uniform float time, decay, gammaAdj, echo_zoom, echo_alpha, echo_orientation, fShader;
uniform int invert, brighten, darken, solarize;
uniform vec2 resolution;
uniform vec4 aspect, texsize, texsize_noise_lq, texsize_noise_mq, texsize_noise_hq;
uniform vec4 texsize_noise_lq_lite, texsize_noisevol_lq, texsize_noisevol_hq;
uniform float bass, mid, treb, vol, bass_att, mid_att, treb_att, vol_att;
uniform float frame, fps;
uniform vec4 _qa, _qb, _qc, _qd, _qe, _qf, _qg, _qh;
#define q1 _qa.x
#define q2 _qa.y
#define q3 _qa.z
#define q4 _qa.w
#define q5 _qb.x
#define q6 _qb.y
#define q7 _qb.z
#define q8 _qb.w
#define q9 _qc.x
#define q10 _qc.y
#define q11 _qc.z
#define q12 _qc.w
#define q13 _qd.x
#define q14 _qd.y
#define q15 _qd.z
#define q16 _qd.w
#define q17 _qe.x
#define q18 _qe.y
#define q19 _qe.z
#define q20 _qe.w
#define q21 _qf.x
#define q22 _qf.y
#define q23 _qf.z
#define q24 _qf.w
#define q25 _qg.x
#define q26 _qg.y
#define q27 _qg.z
#define q28 _qg.w
#define q29 _qh.x
#define q30 _qh.y
#define q31 _qh.z
#define q32 _qh.w
uniform vec4 slow_roam_cos, roam_cos, slow_roam_sin, roam_sin;
uniform float blur1_min, blur1_max, blur2_min, blur2_max, blur3_min, blur3_max;
uniform float scale1, scale2, scale3, bias1, bias2, bias3;
uniform vec4 rand_frame, rand_preset;
float PI = 3.141592653589793;
#endif
