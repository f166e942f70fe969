// WebGL page
//
// A page, an engine or a tutorial that compiles a shader unchanged and has no host of its own here.
// The shader declares all its names. The names below have nearly the same meaning in most shaders.
//
// reads: complete shader
// source: conventions in the shaders of public repositories
// version: own
// names: all
// entry: main
#ifdef SHADER_DECLARES
uniform vec2 resolution; // = resolution, or vec3 ivec2
uniform vec2 u_resolution; // = resolution, or vec3 ivec2
uniform vec2 uResolution; // = resolution, or vec3 ivec2
uniform vec2 screenSize; // = resolution, or vec3 ivec2
uniform vec4 resolution; // = resolution-and-pixel
uniform vec4 u_resolution; // = resolution-and-pixel
uniform vec4 uResolution; // = resolution-and-pixel
uniform float aspect; // = aspect
uniform float u_aspect; // = aspect
uniform float uAspect; // = aspect
uniform float aspectRatio; // = aspect
uniform float uPixelRatio; // = pixel-ratio
uniform float u_pixelRatio; // = pixel-ratio
uniform float time; // = time
uniform float u_time; // = time
uniform float uTime; // = time
uniform float u_Time; // = time
uniform float globalTime; // = time
uniform float delta; // = delta
uniform float deltaTime; // = delta
uniform float u_delta; // = delta
uniform float u_deltaTime; // = delta
uniform float uDelta; // = delta
uniform int frame; // = frame, or uint float
uniform int u_frame; // = frame, or uint float
uniform int uFrame; // = frame, or uint float
uniform vec4 date; // = date
uniform vec4 u_date; // = date
uniform vec2 mouse; // = pointer-unit, or vec3 vec4
uniform vec2 u_mouse; // = pointer, or vec3 vec4
uniform vec2 uMouse; // = pointer-unit, or vec3 vec4
uniform sampler2D backbuffer; // = last-frame
uniform sampler2D u_backbuffer; // = last-frame
uniform sampler2D prevFrame; // = last-frame
uniform sampler2D previousFrame; // = last-frame
varying vec3 vViewPosition; // = vec3(-port_pos, 1.0)
#endif
