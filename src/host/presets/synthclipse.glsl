// Synthclipse
//
// A tool that runs complete fragment shaders, in desktop GLSL and GLSL ES. Comments such as `//!
// slider[min, value, max]` after a uniform declaration define its control; other comments define
// presets, groups and post-processing.
//
// source: the user guide of Synthclipse, fragx: commands, uniform_controls, build_in_uniforms, file_types
// version: own
// names: some
// entry: main
#ifdef SHADER_DECLARES
uniform vec4 synth_Mouse; // = mouse, own
uniform vec4 synth_LMouse; // = mouse, own
uniform vec4 synth_RMouse; // = nothing, own
uniform vec4 synth_MMouse; // = nothing, own
uniform vec2 synth_Resolution; // = resolution, own
uniform float synth_Time; // = time, own
uniform vec2 synth_Center; // = nothing, own
uniform float synth_Zoom; // = aspect, usual
uniform mat4 synth_ViewMatrix; // = identity, own
uniform mat4 synth_ProjectionMatrix; // = identity, own
uniform mat3 synth_NormalMatrix; // = identity, own
uniform vec2 pixelSize; // = pixel
uniform float time; // = time
uniform float iGlobalTime; // = time
#endif
