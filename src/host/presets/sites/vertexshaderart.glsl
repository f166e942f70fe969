// VertexShaderArt
//
// vertexshaderart.com runs a vertex shader for numbered vertices and draws them as points, lines or
// triangles. It puts its declarations before the shader and `gl_PointSize = 1.0` at the start of
// `main`.
//
// The mouse ranges from -1 to 1, y up. `sound` holds the spectra of the last 240 frames, the newest
// at v = 0. A JSON header, as in VEDA and ossia score, may set the number of vertices.
//
// source: src/js/shaders.js and src/js/main.js of greggman/vertexshaderart; the manuals of VEDA and ossia score
// version: 100
// names: all
// entry: main
// composes: yes
attribute float vertexId;
uniform vec2 mouse; // = pointer-signed
uniform vec2 resolution; // = resolution
uniform vec4 background; // = control
uniform float time; // = time
uniform float vertexCount; // = control
uniform sampler2D volume;
uniform sampler2D sound;
uniform sampler2D floatSound;
uniform sampler2D touch;
uniform vec2 soundRes; // = history-size
varying vec4 v_color;
