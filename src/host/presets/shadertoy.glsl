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
uniform vec3 iResolution; // = resolution, or vec2 ivec2
uniform float iTime; // = time
uniform float iTimeDelta; // = delta
uniform int iFrame; // = frame, or uint float
uniform float iFrameRate; // = frame-rate, or int uint
uniform vec4 iMouse; // = mouse, or vec2 vec3
uniform vec4 iDate; // = date
uniform float iSampleRate; // = sample-rate, or int uint
uniform float iChannelTime[4]; // = channel-time
uniform vec3 iChannelResolution[4]; // = channel-resolution
uniform sampler2D iChannel0; // = channel
uniform sampler2D iChannel1; // = channel
uniform sampler2D iChannel2; // = channel
uniform sampler2D iChannel3; // = channel
#ifdef SHADER_DECLARES
// programs that give the same uniforms to their own shaders, and the name of the time until 2017
uniform float iGlobalTime; // = time
uniform vec4 iResolution; // = resolution-and-pixel
#endif
