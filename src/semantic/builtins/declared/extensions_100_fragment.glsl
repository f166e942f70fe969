// What extensions of WebGL1 add to fragment shaders.
genType dFdx(genType p);
genType dFdy(genType p);
genType fwidth(genType p);
vec4 texture2DLodEXT(sampler2D s, vec2 coord, float lod);
vec4 texture2DProjLodEXT(sampler2D s, vec3 coord, float lod);
vec4 texture2DProjLodEXT(sampler2D s, vec4 coord, float lod);
vec4 textureCubeLodEXT(samplerCube s, vec3 coord, float lod);
out highp float gl_FragDepthEXT;
