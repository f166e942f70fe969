// regl
//
// regl compiles the texts `vert` and `frag` of a command as they are written, on a WebGL 1 context:
// GLSL ES 1.00. Nothing is put before them; uniforms and attributes have the names that the command
// gives them and are declared by the text, the precision of float too.
//
// source: regl 2.1.1, lib/shader.js, lib/webgl.js
// package: regl react-regl
// version: 100
// names: all
// entry: main
