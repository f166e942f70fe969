// Built-in functions of GLSL ES 3.00 that only fragment shaders have: the lookups with a bias
// (8.8) and the derivatives (8.9).
gvec4 texture(gsampler2D s, vec2 P, float bias);
gvec4 texture(gsampler3D s, vec3 P, float bias);
gvec4 texture(gsamplerCube s, vec3 P, float bias);
gvec4 texture(gsampler2DArray s, vec3 P, float bias);
float texture(sampler2DShadow s, vec3 P, float bias);
float texture(samplerCubeShadow s, vec4 P, float bias);
gvec4 textureProj(gsampler2D s, vec3 P, float bias);
gvec4 textureProj(gsampler2D s, vec4 P, float bias);
gvec4 textureProj(gsampler3D s, vec4 P, float bias);
float textureProj(sampler2DShadow s, vec4 P, float bias);
gvec4 textureOffset(gsampler2D s, vec2 P, const ivec2 offset, float bias);
gvec4 textureOffset(gsampler3D s, vec3 P, const ivec3 offset, float bias);
gvec4 textureOffset(gsampler2DArray s, vec3 P, const ivec2 offset, float bias);
float textureOffset(sampler2DShadow s, vec3 P, const ivec2 offset, float bias);
gvec4 textureProjOffset(gsampler2D s, vec3 P, const ivec2 offset, float bias);
gvec4 textureProjOffset(gsampler2D s, vec4 P, const ivec2 offset, float bias);
gvec4 textureProjOffset(gsampler3D s, vec4 P, const ivec3 offset, float bias);
float textureProjOffset(sampler2DShadow s, vec4 P, const ivec2 offset, float bias);
genType dFdx(genType p);
genType dFdy(genType p);
genType fwidth(genType p);
