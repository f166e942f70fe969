// VS Code Shader Toy
//
// A VS Code extension that runs ShaderToy code. It has ShaderToy's names, ten channels, and
// directives such as `#iChannel0 "file"` and `#iUniform` that define the inputs of the channels and
// additional uniforms. A channel may be a cube map.
//
// A shader may have `main` instead of `mainImage`. It is compiled for WebGL2 with the functions of
// both versions.
//
// source: README.md, src/bufferprovider.ts, src/glsl_extension_grammar.txt, src/extensions/preamble_extension.ts of stevensona/shader-toy
// version: 300 es
// names: some
// entry: mainImage main
// composes: yes
// directive: iChannel* iUniform iKeyboard iVertex iFirstPersonControls StrictCompatibility
uniform vec3 iResolution; // = resolution
uniform float iTime; // = time
uniform float iTimeDelta; // = delta
uniform float iFrameRate; // = frame-rate
uniform int iFrame; // = frame
uniform vec4 iDate; // = date
uniform vec3 iChannelResolution[10]; // = channel-resolution
uniform vec4 iMouse; // = mouse
uniform vec4 iMouseButton; // = button
uniform float iSampleRate; // = sample-rate
uniform mat4 iViewMatrix; // = identity
#define iGlobalTime iTime
#define iGlobalFrame iFrame
#define SHADER_TOY
uniform sampler2D iChannel0;
uniform sampler2D iChannel1;
uniform sampler2D iChannel2;
uniform sampler2D iChannel3;
uniform sampler2D iChannel4;
uniform sampler2D iChannel5;
uniform sampler2D iChannel6;
uniform sampler2D iChannel7;
uniform sampler2D iChannel8;
uniform sampler2D iChannel9;
