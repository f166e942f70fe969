// KodeLife
//
// A live coding tool. Texts for desktops are `#version 150` and take the block `VertexData` from
// the vertex shader; those for devices are GLSL ES. `spectrum` tells how loud low, middle and high
// sounds are; `prevFrame` is the last frame.
//
// source: its templates, as projects of its users hold them
// shows: own inData VertexData
// version: own
// names: some
// entry: main
#ifdef SHADER_DECLARES
uniform float time; // = time
uniform vec2 resolution; // = resolution
uniform vec2 mouse; // = pointer-unit
uniform vec3 spectrum; // = spectrum, own
uniform sampler2D texture0; // = file, repeat, numbered, usual
uniform sampler2D prevFrame; // = last-frame, own
uniform sampler2D prevPass; // = file, usual
in vec4 v_position; // = vec4(port_pos, 0.0, 1.0), usual
in vec3 v_normal; // = vec3(0.0, 0.0, 1.0), usual
in vec2 v_texcoord; // = port_place, usual
#endif
