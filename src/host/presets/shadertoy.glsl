// ShaderToy
//
// The player of shadertoy.com puts its uniforms before each pass and calls `mainImage`, `mainSound`
// or `mainCubemap`. A file with such an entry is read as a pass of its own; this is for the files
// that go with it, and for programs that give the same uniforms to their own shaders.
//
// source: shadertoy.com, effect.js
// word: iResolution iTime iTimeDelta iFrame iFrameRate iMouse iDate iSampleRate iChannelTime iChannelResolution iChannel0 iChannel1 iChannel2 iChannel3
// version: any
// names: some
// entry: mainImage mainSound mainCubemap main
uniform vec3 iResolution;
uniform float iTime;
uniform float iTimeDelta;
uniform int iFrame;
uniform float iFrameRate;
uniform vec4 iMouse;
uniform vec4 iDate;
uniform float iSampleRate;
uniform float iChannelTime[4];
uniform vec3 iChannelResolution[4];
uniform sampler2D iChannel0;
uniform sampler2D iChannel1;
uniform sampler2D iChannel2;
uniform sampler2D iChannel3;
