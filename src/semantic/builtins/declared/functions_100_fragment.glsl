// Built-in functions of GLSL ES 1.00 that only fragment shaders have: the lookups with a bias.
vec4 texture2D(sampler2D s, vec2 coord, float bias);
vec4 texture2DProj(sampler2D s, vec3 coord, float bias);
vec4 texture2DProj(sampler2D s, vec4 coord, float bias);
vec4 textureCube(samplerCube s, vec3 coord, float bias);
