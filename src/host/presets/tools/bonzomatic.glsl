// Bonzomatic
//
// The live coding tool of demo parties. Shaders start with `#version 410 core`, declare everything
// that they use, and write to an `out vec4` of any name.
//
// The spectra are one-dimensional textures, which WebGL does not support: they become rows of
// two-dimensional textures. `texFFTIntegrated` grows with the loudness. Images that shaders write
// to read as zero.
//
// source: the default shader of Gargaj/Bonzomatic and its README
// version: desktop
// names: some
// entry: main
#ifdef SHADER_DECLARES
uniform float fGlobalTime; // = time, own
uniform vec2 v2Resolution; // = resolution, own
uniform float fFrameTime; // = delta, own
uniform int iFrameIndex; // = frame, or float, usual
uniform sampler1D texFFT; // = music, own
uniform sampler1D texFFTSmoothed; // = music, own
uniform sampler1D texFFTIntegrated; // = music-sum, own
uniform sampler2D texPreviousFrame; // = last-frame, own
uniform sampler2D texChecker; // = file, mipmap, repeat, usual
uniform sampler2D texNoise; // = file, mipmap, repeat, usual
uniform sampler2D texRevision; // = file, mipmap, repeat, usual
uniform sampler2D texTex1; // = file, mipmap, repeat, numbered
#endif
