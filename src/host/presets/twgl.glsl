// TWGL
//
// TWGL compiles a text as it is written, or as it stands in a <script> element; only blank lines
// before `#version 300 es` are taken away. Nothing is put before it: it declares all uniforms,
// attributes and the precision of float itself.
//
// source: twgl.js 7.0.0, dist/7.x/twgl-full.module.js (createProgramNoCheck, prepShaderSource)
// package: twgl.js
// version: own
// names: all
// entry: main
