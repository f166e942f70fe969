// gl-react
//
// Shaders.create() compiles the text `frag` as it is written: GLSL ES 3.00 when its first line is
// `#version 300 es`, else GLSL ES 1.00. When there is no `vert`, a vertex shader with the attribute
// `vec2 _p` and the varying `vec2 uv` (0 to 1) is taken, so a fragment shader declares `varying
// vec2 uv` (or `in vec2 uv`) itself, and its uniforms and precision as well. The macro SHADER_NAME
// is defined only behind the text.
//
// source: gl-react 6.0.0, src/Shaders.ts, src/GLSL.ts
// package: gl-react gl-react-dom gl-react-expo gl-react-native
// version: own
// names: all
// entry: main
