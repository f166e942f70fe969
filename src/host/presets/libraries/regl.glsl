// regl
//
// regl compiles the shaders `vert` and `frag` of a command unchanged, as GLSL ES 1.00 on a WebGL 1
// context. Nothing is added: the shader declares the uniforms and attributes, with the names that
// the command uses, and the float precision.
//
// source: regl 2.1.1, lib/shader.js, lib/webgl.js
// package: regl react-regl
// version: 100
// names: all
// entry: main
