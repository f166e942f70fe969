// KodeLife
//
// A live coding tool. Desktop shaders are `#version 150` and read the block `VertexData` from the
// vertex shader; mobile shaders are GLSL ES.
//
// `spectrum` holds the levels of low, middle and high frequencies; `prevFrame` is the previous
// frame.
//
// source: its templates, from user projects
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
