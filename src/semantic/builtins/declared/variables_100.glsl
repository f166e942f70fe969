// Built-in constants and uniforms of GLSL ES 1.00 (7.4, 7.5); see variables_300.glsl.
const mediump int gl_MaxVertexAttribs = 16;
const mediump int gl_MaxVertexUniformVectors = 4096;
const mediump int gl_MaxVaryingVectors = 31;
const mediump int gl_MaxVertexTextureImageUnits = 32;
const mediump int gl_MaxCombinedTextureImageUnits = 64;
const mediump int gl_MaxTextureImageUnits = 32;
const mediump int gl_MaxFragmentUniformVectors = 4096;
const mediump int gl_MaxDrawBuffers = 8;
uniform struct { highp float near; highp float far; highp float diff; } gl_DepthRange;
