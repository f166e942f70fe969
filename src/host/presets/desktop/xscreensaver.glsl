// XScreenSaver
//
// Its module `xshadertoy`, since version 6.14, runs code of ShaderToy: `NAME.glsl`, or up to five
// programs `NAME-0.glsl`, `NAME-1.glsl` and so on, of which the last draws the image, with common
// code in `NAME-c.glsl`. A shader alone is read as one of ShaderToy.
//
// `iChannel0` to `iChannel3` are the outputs of programs 0 to 3, without filtering. A program cannot
// read what it drew itself. There are no textures, no keyboard and no sound, and the sizes and times
// of channels are not set. The month of `iDate` counts from 1.
//
// source: hacks/glx/xshadertoy.c of xscreensaver 6.15
// version: desktop
// names: all
// entry: mainImage
// programs: 5
uniform vec3 iResolution; // = resolution
uniform float iTime; // = time
uniform float iTimeDelta; // = delta
uniform float iFrameRate; // = frame-rate
uniform int iFrame; // = frame
uniform vec4 iDate; // = date-from-one
uniform vec4 iMouse; // = mouse
uniform vec3 iChannelResolution[4]; // = nothing
uniform float iChannelTime[4]; // = nothing
uniform float iSampleRate; // = nothing
uniform sampler2D iChannel0; // = channel, nearest
uniform sampler2D iChannel1; // = channel, nearest
uniform sampler2D iChannel2; // = channel, nearest
uniform sampler2D iChannel3; // = channel, nearest
#ifdef SHADER_TEMPLATE
#pragma code
#endif
