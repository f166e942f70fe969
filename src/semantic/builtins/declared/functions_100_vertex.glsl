// Built-in functions of GLSL ES 1.00 that only vertex shaders have: the lookups with a level.
vec4 texture2DLod(sampler2D s, vec2 coord, float lod);
vec4 texture2DProjLod(sampler2D s, vec3 coord, float lod);
vec4 texture2DProjLod(sampler2D s, vec4 coord, float lod);
vec4 textureCubeLod(samplerCube s, vec3 coord, float lod);
