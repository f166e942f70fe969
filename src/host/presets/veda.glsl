// VEDA
//
// A live coding package for Atom and Visual Studio Code, and the library VEDA.js. Shaders are GLSL ES
// 1.00 and declare the uniforms that they use. A comment with a JSON5 object at the start turns inputs
// on, such as `"audio": true`, imports images, and lists passes: `"PASSES": [{"TARGET": "a"}, {}]`.
//
// The text runs once for each pass, with its number in `PASSINDEX`, unless `fs` names another file.
// Later passes read the output of a pass from the sampler of its name. `WIDTH` and `HEIGHT` of a pass
// are numbers or expressions of `$WIDTH` and `$HEIGHT`; `FLOAT` gives its target float components.
//
// `key` holds the pressed keys by their codes. The page of `shaderport` reads no MIDI, OSC or
// gamepads: `midi`, `note`, `gamepad` and `osc_*` are 0. `volume` is the average of the spectrum,
// from 0 to 255.
//
// Its vertex shaders are read as those of VertexShaderArt.
//
// source: README.md of fand/veda; src/veda.ts, src/audio-loader.ts and src/key-loader.ts of fand/vedajs
// package: vedajs
// version: 100
// names: some
// entry: main
// composes: yes
// defines: PASSINDEX
#ifdef SHADER_DECLARES
uniform float time; // = time
uniform vec2 mouse; // = pointer-unit
uniform vec2 resolution; // = resolution
uniform int FRAMEINDEX; // = frame
uniform float volume; // = volume-bytes
uniform vec3 mouseButtons; // = nothing
uniform float vertexCount; // = nothing
uniform sampler2D backbuffer; // = last-frame
uniform sampler2D camera; // = file
uniform sampler2D spectrum; // = music
uniform sampler2D samples; // = music
#endif
