// ISF
//
// A shader in the Interactive Shader Format starts with a comment that contains a JSON object. The
// host compiles it as GLSL ES 1.00, after the declarations below. A vertex shader calls
// isf_vertShaderInit(). IMG_PIXEL and similar are replaced in the text and are therefore declared
// here as functions; their first argument is the name of an image. When an old shader is upgraded,
// the ISF 1 names vv_FragNormCoord and vv_vertShaderInit are renamed.
//
// Not declared here: the uniforms that the JSON object defines. These are one for each of INPUTS
// (float: float; image: sampler2D; bool and event: bool; long: int; color: vec4; point2D: vec2),
// and a sampler2D for each PASSES target and each name in IMPORTED. For an image NAME there are
// also _NAME_imgRect (vec4), _NAME_imgSize (vec2), _NAME_flip (bool) and the varyings
// _NAME_normTexCoord and _NAME_texCoord.
//
// Not supported: images other than 2D, audio and audioFFT inputs, and hosts on desktop OpenGL,
// since the JavaScript package does not support them.
//
// source: interactive-shader-format 2.9.0, src/ISFParser.js, src/ISFUpgrader.js
// package: interactive-shader-format
// word: isf_FragNormCoord isf_FragCoord isf_vertShaderInit vv_FragNormCoord vv_vertShaderInit IMG_PIXEL IMG_NORM_PIXEL IMG_THIS_PIXEL IMG_THIS_NORM_PIXEL IMG_SIZE RENDERSIZE PASSINDEX
// version: 100
// takes: desktop
// names: some
// entry: main
// composes: yes
precision highp float;
precision highp int;
#define vv_FragNormCoord isf_FragNormCoord
uniform int PASSINDEX;
uniform vec2 RENDERSIZE; // = resolution, own
varying vec2 isf_FragNormCoord; // = port_place, own
#ifdef VERTEX_SHADER
#define vv_vertShaderInit isf_vertShaderInit
attribute vec2 position;
vec2 isf_fragCoord;
void isf_vertShaderInit();
#endif
#ifdef FRAGMENT_SHADER
varying vec2 isf_FragCoord; // = port_place * port_size
uniform float TIME; // = time
uniform float TIMEDELTA; // = delta
uniform int FRAMEINDEX; // = frame
uniform vec4 DATE; // = date-from-one
vec4 VVSAMPLER_2DBYPIXEL(sampler2D sampler, vec4 samplerImgRect, vec2 samplerImgSize, bool samplerFlip, vec2 loc);
vec4 VVSAMPLER_2DBYNORM(sampler2D sampler, vec4 samplerImgRect, vec2 samplerImgSize, bool samplerFlip, vec2 normLoc);
vec4 IMG_PIXEL(sampler2D image, vec2 pixel);
vec4 IMG_NORM_PIXEL(sampler2D image, vec2 normLoc);
vec4 IMG_THIS_PIXEL(sampler2D image);
vec4 IMG_THIS_NORM_PIXEL(sampler2D image);
vec2 IMG_SIZE(sampler2D image);
#endif
