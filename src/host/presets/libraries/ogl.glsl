// OGL
//
// OGL's Program compiles both shaders unchanged, as GLSL ES 3.00 if the text starts with `#version
// 300 es`, otherwise as GLSL ES 1.00. The context is WebGL 2 unless the Renderer is created with
// `webgl: 1`. Nothing is added, not even a precision.
//
// If the shader declares them, the host sets the uniforms `mat4 modelMatrix`, `viewMatrix`,
// `modelViewMatrix`, `projectionMatrix`, `mat3 normalMatrix`, `vec3 cameraPosition`, and the
// attributes of its shapes `vec3 position`, `vec3 normal`, `vec2 uv`. A Post pass provides `uniform
// sampler2D tMap` and `varying vec2 vUv`.
//
// source: ogl 1.0.11, src/core/Program.js, src/core/Renderer.js, src/extras/Post.js
// package: ogl react-ogl
// version: own
// names: all
// entry: main
