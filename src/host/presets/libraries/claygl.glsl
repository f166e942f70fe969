// ClayGL
//
// ClayGL compiles a shader as GLSL ES 1.00 on a WebGL 1 context, after a default precision and the macros
// that the material, the lights and the textures set (`POINT_LIGHT_COUNT`, `DIFFUSEMAP_ENABLED`).
//
// `@import clay.util.rgbm` inserts the chunk between `@export clay.util.rgbm` and `@end`, which may be in
// any file or string of the program. ClayGL removes what follows a name in the declaration of a uniform or
// attribute, as in `uniform mat4 world : WORLD;` and `uniform vec2 at = vec2(0.0, 0.0);`.
//
// Not declared here: the uniforms and attributes of these semantics. The shader declares them.
//
// source: claygl 1.3.0, src/Shader.js, src/gpu/ProgramManager.js
// package: claygl qtek
// global: clay
// takes: annotations
// version: 100
// context: webgl1
// names: some
// entry: main

precision highp float;
precision highp int;
precision highp sampler2D;
