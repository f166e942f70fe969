// Kodi
//
// The Kodi add-on visualization.shadertoy puts the early names of ShaderToy before a fragment
// shader and calls its mainImage(color, gl_FragCoord.xy) from its own main(). The alpha value from
// mainImage is not used. The host provides the vertex shader.
//
// With OpenGL ES the shader is GLSL ES 1.00 with mediump float and int; on desktop it is old GLSL
// without a precision. The extension GL_OES_standard_derivatives is enabled.
//
// Newer versions of the add-on may have more names (iTime instead of iGlobalTime), which are not
// declared here. Kodi's own shaders (m_samp0, m_cord0, m_unicol) declare all their names
// themselves.
//
// source: src/main.cpp of xbmc/visualization.shadertoy (no npm package)
// version: 100
// names: some
// entry: mainImage
#ifdef FRAGMENT_SHADER
#extension GL_OES_standard_derivatives : enable
precision mediump float;
precision mediump int;
uniform vec3 iResolution; // = resolution
uniform float iGlobalTime; // = time
uniform float iChannelTime[4]; // = channel-time
uniform vec4 iMouse; // = mouse
uniform vec4 iDate; // = date
uniform float iSampleRate; // = sample-rate
uniform vec3 iChannelResolution[4]; // = channel-resolution
uniform sampler2D iChannel0; // = music
uniform sampler2D iChannel1; // = file, mipmap, repeat
uniform sampler2D iChannel2; // = file, mipmap, repeat
uniform sampler2D iChannel3; // = file, mipmap, repeat
#endif
