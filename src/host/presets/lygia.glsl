// LYGIA
//
// LYGIA is a library of functions in files of one function each, put into a shader by `#include
// "lygia/math/decimate.glsl"` (by the host, a bundler or the resolver of lygia.xyz; the path may
// also be relative). It adds nothing by itself: version, precision and uniforms are the shader's
// own, and names come only from the files that are included. Its texts hold for GLSL ES 1.00, GLSL
// ES 3.00 and desktop GLSL, with SAMPLER_TYPE and SAMPLER_FNC(TEX, UV) in place of sampler2D and
// texture() or texture2D(), which `sampler.glsl` defines and a shader may define before. Many files
// read macros that a shader defines before the include, for example NAME_FNC, NAME_SAMPLER_FNC,
// NAME_TYPE, RESOLUTION, CAMERA_POSITION, LIGHT_POSITION and RAYMARCH_MAP_FNC. A file is a part of
// a shader without main().
//
// source: lygia 1.4.1, README.md, sampler.glsl
// package: lygia glsl-pipeline
// word: SAMPLER_FNC SAMPLER_TYPE
// version: own
// names: some
// entry: main
// include: "..."
#ifndef SAMPLER_FNC
#if __VERSION__ >= 300
#define SAMPLER_FNC(TEX, UV) texture(TEX, UV)
#else
#define SAMPLER_FNC(TEX, UV) texture2D(TEX, UV)
#endif
#endif
#ifndef SAMPLER_TYPE
#define SAMPLER_TYPE sampler2D
#endif
