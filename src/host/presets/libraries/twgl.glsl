// TWGL
//
// TWGL compiles a shader unchanged, from a string or from a `<script>` element; only blank lines
// before `#version 300 es` are removed. Nothing is added: the shader declares all uniforms,
// attributes and the float precision itself.
//
// source: twgl.js 7.0.0, dist/7.x/twgl-full.module.js (createProgramNoCheck, prepShaderSource)
// package: twgl.js
// version: own
// names: all
// entry: main
