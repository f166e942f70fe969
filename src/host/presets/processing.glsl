// Processing
//
// A text with its own `#version` is compiled as it is. Any other text of a PShader is written as
// for GLSL ES 1.00 or GLSL 1.20; on a newer OpenGL Processing replaces its words: `attribute` and
// `varying` by `in` and `out`, texture2D() and its like by texture(), the name `texture` (a
// uniform) by texMap, and gl_FragColor by an output of its own, _fragColor. No other names are
// declared and no precision is added (the texts have one within `#ifdef GL_ES`). Names that the
// host sets when the text declares them: uniforms `mat4 transform` (or transformMatrix),
// `modelview`, `projection`, `mat3 normalMatrix`, `mat4 texMatrix`, `sampler2D texture`, `vec2
// texOffset`, `vec4 viewport`, `vec2 resolution`, `sampler2D ppixels`, `int lightCount`, `vec4
// lightPosition[8]`, `vec3 lightNormal[8]`, `lightAmbient[8]`, `lightDiffuse[8]`,
// `lightSpecular[8]`, `lightFalloff[8]`, `vec2 lightSpot[8]`; attributes `vec4 position` (or
// vertex), `color`, `vec3 normal`, `vec2 texCoord`, `vec4 ambient`, `specular`, `emissive`, `float
// shininess`, and for lines and points `vec4 direction`, `vec2 offset`; varyings of its own vertex
// shaders `vec4 vertColor`, `vertTexCoord`. A line `#define PROCESSING_TEXTURE_SHADER` (or COLOR,
// LIGHT, TEXLIGHT, LINE, POINT) in the text tells its kind and is part of the text.
//
// source: documentation of PShader (no npm package); stored copies of PGL.java (replacements) and PShader.java (names) of processing
// version: 100
// names: all
// entry: main
