// OGL
//
// Program of OGL compiles both texts as they are written, on a WebGL 2 context unless the Renderer
// is made with `webgl: 1`: GLSL ES 3.00 when the text begins with `#version 300 es`, else GLSL ES
// 1.00. Nothing is put before them, no precision either. Uniforms that the host sets when the text
// declares them: `mat4 modelMatrix`, `viewMatrix`, `modelViewMatrix`, `projectionMatrix`, `mat3
// normalMatrix`, `vec3 cameraPosition`; attributes of its shapes: `vec3 position`, `vec3 normal`,
// `vec2 uv`. A Post pass gives `uniform sampler2D tMap` and `varying vec2 vUv`.
//
// source: ogl 1.0.11, src/core/Program.js, src/core/Renderer.js, src/extras/Post.js
// package: ogl react-ogl
// version: own
// names: all
// entry: main
