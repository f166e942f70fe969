// What extensions of WebGL1 add to shaders of both stages.
vec4 texture2DGradEXT(sampler2D s, vec2 coord, vec2 dPdx, vec2 dPdy);
vec4 texture2DProjGradEXT(sampler2D s, vec3 coord, vec2 dPdx, vec2 dPdy);
vec4 texture2DProjGradEXT(sampler2D s, vec4 coord, vec2 dPdx, vec2 dPdy);
vec4 textureCubeGradEXT(samplerCube s, vec3 coord, vec3 dPdx, vec3 dPdy);
