// Processing
//
// A shader with its own `#version` is compiled unchanged. Any other PShader is written for GLSL ES
// 1.00 or GLSL 1.20; on a newer OpenGL, Processing replaces its syntax: `attribute` and `varying`
// become `in` and `out`, texture2D() and similar become texture(), the name `texture` (a uniform)
// becomes texMap, and gl_FragColor becomes the output _fragColor. No other names are declared, and
// no precision is added (the shaders have one within `#ifdef GL_ES`).
//
// If the shader declares them, the host sets these names: uniforms `mat4 transform` (or
// transformMatrix), `modelview`, `projection`, `mat3 normalMatrix`, `mat4 texMatrix`, `sampler2D
// texture`, `vec2 texOffset`, `vec4 viewport`, `vec2 resolution`, `sampler2D ppixels`, `int
// lightCount`, `vec4 lightPosition[8]`, `vec3 lightNormal[8]`, `lightAmbient[8]`,
// `lightDiffuse[8]`, `lightSpecular[8]`, `lightFalloff[8]`, `vec2 lightSpot[8]`; attributes `vec4
// position` (or vertex), `color`, `vec3 normal`, `vec2 texCoord`, `vec4 ambient`, `specular`,
// `emissive`, `float shininess`, and for lines and points `vec4 direction`, `vec2 offset`; varyings
// of its own vertex shaders `vec4 vertColor`, `vertTexCoord`.
//
// A line `#define PROCESSING_TEXTURE_SHADER` (or COLOR, LIGHT, TEXLIGHT, LINE, POINT) states the
// type of the shader and is part of its text.
//
// source: documentation of PShader (no npm package); copies of PGL.java (replacements) and PShader.java (names) of processing
// version: 100
// names: all
// entry: main
