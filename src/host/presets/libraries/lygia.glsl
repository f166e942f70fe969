// LYGIA
//
// LYGIA is a library of functions, one per file. A shader includes them with `#include
// "lygia/math/decimate.glsl"`, resolved by the host, a bundler or lygia.xyz; the path may be
// relative. LYGIA adds nothing else: the shader has its own version, precision and uniforms, and
// names come only from the included files. A file is a shader fragment without main().
//
// The files work in GLSL ES 1.00, GLSL ES 3.00 and desktop GLSL. They use SAMPLER_TYPE and
// SAMPLER_FNC(TEX, UV) instead of sampler2D and texture() or texture2D(); `sampler.glsl` defines
// these, and a shader may define them first.
//
// Many files read macros that a shader defines before the include, for example NAME_FNC,
// NAME_SAMPLER_FNC, NAME_TYPE, RESOLUTION, CAMERA_POSITION, LIGHT_POSITION and RAYMARCH_MAP_FNC.
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
