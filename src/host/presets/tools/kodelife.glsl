// KodeLife
//
// A live coding tool. Desktop shaders are `#version 150` and read the block `VertexData` from the
// vertex shader; mobile shaders are GLSL ES.
//
// `spectrum` holds the levels of low, middle and high frequencies; `prevFrame` is the previous
// frame.
//
// A project (`.klproj`) is compressed XML, in which parameters say which value a uniform has:
// `shaderport` renames these uniforms to the names `port_kl_*` below.
//
// source: its templates, from user projects; its manual; docs/KODELIFE_FILE_FORMAT.md of dreness/kodelife-generator
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
uniform float port_kl_CLOCK; // = time
uniform vec2 port_kl_FRAME_RESOLUTION; // = resolution
uniform int port_kl_FRAME_NUMBER; // = frame
uniform vec2 port_kl_INPUT_MOUSE_SIMPLE; // = pointer-unit
uniform vec4 port_kl_DATE; // = date
uniform float port_kl_AUDIO_SAMPLE_RATE; // = sample-rate
uniform vec3 port_kl_AUDIO_SPECTRUM_SPLIT; // = spectrum
uniform sampler2D port_kl_AUDIO_SPECTRUM_FULL; // = music
uniform sampler2D port_kl_FRAME_PREV_FRAME; // = last-frame
in vec4 v_position; // = vec4(port_pos, 0.0, 1.0), usual
in vec3 v_normal; // = vec3(0.0, 0.0, 1.0), usual
in vec2 v_texcoord; // = port_place, usual
#endif
