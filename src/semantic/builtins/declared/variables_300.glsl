// Built-in constants and uniforms of GLSL ES 3.00 (7.3, 7.4), with the values of Chromium on
// SwiftShader; only the last three are the same everywhere.
const mediump int gl_MaxVertexAttribs = 16;
const mediump int gl_MaxVertexUniformVectors = 4096;
const mediump int gl_MaxVertexOutputVectors = 32;
const mediump int gl_MaxFragmentInputVectors = 32;
const mediump int gl_MaxVertexTextureImageUnits = 32;
const mediump int gl_MaxCombinedTextureImageUnits = 64;
const mediump int gl_MaxTextureImageUnits = 32;
const mediump int gl_MaxFragmentUniformVectors = 4096;
const mediump int gl_MaxDrawBuffers = 8;
const mediump int gl_MinProgramTexelOffset = -8;
const mediump int gl_MaxProgramTexelOffset = 7;
uniform struct { highp float near; highp float far; highp float diff; } gl_DepthRange;
