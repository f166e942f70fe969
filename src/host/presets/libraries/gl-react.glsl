// gl-react
//
// Shaders.create() compiles the text `frag` unchanged: as GLSL ES 3.00 if its first line is
// `#version 300 es`, otherwise as GLSL ES 1.00. The fragment shader declares its uniforms and
// precision itself.
//
// Without a `vert`, the host uses a vertex shader with the attribute `vec2 _p` and the varying
// `vec2 uv` (0 to 1), so the fragment shader declares `varying vec2 uv` (or `in vec2 uv`). The
// macro SHADER_NAME is defined only after the text.
//
// source: gl-react 6.0.0, src/Shaders.ts, src/GLSL.ts
// package: gl-react gl-react-dom gl-react-expo gl-react-native
// version: own
// names: all
// entry: main
