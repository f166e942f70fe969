// Built-in functions of GLSL ES 3.00, chapter 8.
//
// genType stands for float, vec2, vec3, vec4 in turn; genIType, genUType and genBType likewise.
// vec, ivec, uvec and bvec stand for 2 to 4 components, mat for every matrix. gsampler2D and its
// kin stand for the float, int and uint sampler, gvec4 for what it yields. A `const` parameter
// takes constant expressions only.

// 8.1 Angle and trigonometry
genType radians(genType degrees);
genType degrees(genType radians);
genType sin(genType angle);
genType cos(genType angle);
genType tan(genType angle);
genType asin(genType x);
genType acos(genType x);
genType atan(genType y, genType x);
genType atan(genType y_over_x);
genType sinh(genType x);
genType cosh(genType x);
genType tanh(genType x);
genType asinh(genType x);
genType acosh(genType x);
genType atanh(genType x);

// 8.2 Exponential
genType pow(genType x, genType y);
genType exp(genType x);
genType log(genType x);
genType exp2(genType x);
genType log2(genType x);
genType sqrt(genType x);
genType inversesqrt(genType x);

// 8.3 Common
genType abs(genType x);
genIType abs(genIType x);
genType sign(genType x);
genIType sign(genIType x);
genType floor(genType x);
genType trunc(genType x);
genType round(genType x);
genType roundEven(genType x);
genType ceil(genType x);
genType fract(genType x);
genType mod(genType x, float y);
genType mod(genType x, genType y);
genType modf(genType x, out genType i);
genType min(genType x, genType y);
genType min(genType x, float y);
genIType min(genIType x, genIType y);
genIType min(genIType x, int y);
genUType min(genUType x, genUType y);
genUType min(genUType x, uint y);
genType max(genType x, genType y);
genType max(genType x, float y);
genIType max(genIType x, genIType y);
genIType max(genIType x, int y);
genUType max(genUType x, genUType y);
genUType max(genUType x, uint y);
genType clamp(genType x, genType minVal, genType maxVal);
genType clamp(genType x, float minVal, float maxVal);
genIType clamp(genIType x, genIType minVal, genIType maxVal);
genIType clamp(genIType x, int minVal, int maxVal);
genUType clamp(genUType x, genUType minVal, genUType maxVal);
genUType clamp(genUType x, uint minVal, uint maxVal);
genType mix(genType x, genType y, genType a);
genType mix(genType x, genType y, float a);
genType mix(genType x, genType y, genBType a);
genType step(genType edge, genType x);
genType step(float edge, genType x);
genType smoothstep(genType edge0, genType edge1, genType x);
genType smoothstep(float edge0, float edge1, genType x);
genBType isnan(genType x);
genBType isinf(genType x);
genIType floatBitsToInt(genType value);
genUType floatBitsToUint(genType value);
genType intBitsToFloat(genIType value);
genType uintBitsToFloat(genUType value);

// 8.4 Packing
uint packSnorm2x16(vec2 v);
vec2 unpackSnorm2x16(uint p);
uint packUnorm2x16(vec2 v);
vec2 unpackUnorm2x16(uint p);
uint packHalf2x16(vec2 v);
vec2 unpackHalf2x16(uint v);

// 8.5 Geometry
float length(genType x);
float distance(genType p0, genType p1);
float dot(genType x, genType y);
vec3 cross(vec3 x, vec3 y);
genType normalize(genType x);
genType faceforward(genType N, genType I, genType Nref);
genType reflect(genType I, genType N);
genType refract(genType I, genType N, float eta);

// 8.6 Matrices
mat matrixCompMult(mat x, mat y);
mat2 outerProduct(vec2 c, vec2 r);
mat3 outerProduct(vec3 c, vec3 r);
mat4 outerProduct(vec4 c, vec4 r);
mat2x3 outerProduct(vec3 c, vec2 r);
mat3x2 outerProduct(vec2 c, vec3 r);
mat2x4 outerProduct(vec4 c, vec2 r);
mat4x2 outerProduct(vec2 c, vec4 r);
mat3x4 outerProduct(vec4 c, vec3 r);
mat4x3 outerProduct(vec3 c, vec4 r);
mat2 transpose(mat2 m);
mat3 transpose(mat3 m);
mat4 transpose(mat4 m);
mat2x3 transpose(mat3x2 m);
mat3x2 transpose(mat2x3 m);
mat2x4 transpose(mat4x2 m);
mat4x2 transpose(mat2x4 m);
mat3x4 transpose(mat4x3 m);
mat4x3 transpose(mat3x4 m);
float determinant(mat2 m);
float determinant(mat3 m);
float determinant(mat4 m);
mat2 inverse(mat2 m);
mat3 inverse(mat3 m);
mat4 inverse(mat4 m);

// 8.7 Vector relations
bvec lessThan(vec x, vec y);
bvec lessThan(ivec x, ivec y);
bvec lessThan(uvec x, uvec y);
bvec lessThanEqual(vec x, vec y);
bvec lessThanEqual(ivec x, ivec y);
bvec lessThanEqual(uvec x, uvec y);
bvec greaterThan(vec x, vec y);
bvec greaterThan(ivec x, ivec y);
bvec greaterThan(uvec x, uvec y);
bvec greaterThanEqual(vec x, vec y);
bvec greaterThanEqual(ivec x, ivec y);
bvec greaterThanEqual(uvec x, uvec y);
bvec equal(vec x, vec y);
bvec equal(ivec x, ivec y);
bvec equal(uvec x, uvec y);
bvec equal(bvec x, bvec y);
bvec notEqual(vec x, vec y);
bvec notEqual(ivec x, ivec y);
bvec notEqual(uvec x, uvec y);
bvec notEqual(bvec x, bvec y);
bool any(bvec x);
bool all(bvec x);
bvec not(bvec x);

// 8.8 Texture lookup
ivec2 textureSize(gsampler2D s, int lod);
ivec3 textureSize(gsampler3D s, int lod);
ivec2 textureSize(gsamplerCube s, int lod);
ivec3 textureSize(gsampler2DArray s, int lod);
ivec2 textureSize(sampler2DShadow s, int lod);
ivec2 textureSize(samplerCubeShadow s, int lod);
ivec3 textureSize(sampler2DArrayShadow s, int lod);
gvec4 texture(gsampler2D s, vec2 P);
gvec4 texture(gsampler3D s, vec3 P);
gvec4 texture(gsamplerCube s, vec3 P);
gvec4 texture(gsampler2DArray s, vec3 P);
float texture(sampler2DShadow s, vec3 P);
float texture(samplerCubeShadow s, vec4 P);
float texture(sampler2DArrayShadow s, vec4 P);
gvec4 textureProj(gsampler2D s, vec3 P);
gvec4 textureProj(gsampler2D s, vec4 P);
gvec4 textureProj(gsampler3D s, vec4 P);
float textureProj(sampler2DShadow s, vec4 P);
gvec4 textureLod(gsampler2D s, vec2 P, float lod);
gvec4 textureLod(gsampler3D s, vec3 P, float lod);
gvec4 textureLod(gsamplerCube s, vec3 P, float lod);
gvec4 textureLod(gsampler2DArray s, vec3 P, float lod);
float textureLod(sampler2DShadow s, vec3 P, float lod);
gvec4 textureOffset(gsampler2D s, vec2 P, const ivec2 offset);
gvec4 textureOffset(gsampler3D s, vec3 P, const ivec3 offset);
gvec4 textureOffset(gsampler2DArray s, vec3 P, const ivec2 offset);
float textureOffset(sampler2DShadow s, vec3 P, const ivec2 offset);
gvec4 texelFetch(gsampler2D s, ivec2 P, int lod);
gvec4 texelFetch(gsampler3D s, ivec3 P, int lod);
gvec4 texelFetch(gsampler2DArray s, ivec3 P, int lod);
gvec4 texelFetchOffset(gsampler2D s, ivec2 P, int lod, const ivec2 offset);
gvec4 texelFetchOffset(gsampler3D s, ivec3 P, int lod, const ivec3 offset);
gvec4 texelFetchOffset(gsampler2DArray s, ivec3 P, int lod, const ivec2 offset);
gvec4 textureProjOffset(gsampler2D s, vec3 P, const ivec2 offset);
gvec4 textureProjOffset(gsampler2D s, vec4 P, const ivec2 offset);
gvec4 textureProjOffset(gsampler3D s, vec4 P, const ivec3 offset);
float textureProjOffset(sampler2DShadow s, vec4 P, const ivec2 offset);
gvec4 textureLodOffset(gsampler2D s, vec2 P, float lod, const ivec2 offset);
gvec4 textureLodOffset(gsampler3D s, vec3 P, float lod, const ivec3 offset);
gvec4 textureLodOffset(gsampler2DArray s, vec3 P, float lod, const ivec2 offset);
float textureLodOffset(sampler2DShadow s, vec3 P, float lod, const ivec2 offset);
gvec4 textureProjLod(gsampler2D s, vec3 P, float lod);
gvec4 textureProjLod(gsampler2D s, vec4 P, float lod);
gvec4 textureProjLod(gsampler3D s, vec4 P, float lod);
float textureProjLod(sampler2DShadow s, vec4 P, float lod);
gvec4 textureProjLodOffset(gsampler2D s, vec3 P, float lod, const ivec2 offset);
gvec4 textureProjLodOffset(gsampler2D s, vec4 P, float lod, const ivec2 offset);
gvec4 textureProjLodOffset(gsampler3D s, vec4 P, float lod, const ivec3 offset);
float textureProjLodOffset(sampler2DShadow s, vec4 P, float lod, const ivec2 offset);
gvec4 textureGrad(gsampler2D s, vec2 P, vec2 dPdx, vec2 dPdy);
gvec4 textureGrad(gsampler3D s, vec3 P, vec3 dPdx, vec3 dPdy);
gvec4 textureGrad(gsamplerCube s, vec3 P, vec3 dPdx, vec3 dPdy);
gvec4 textureGrad(gsampler2DArray s, vec3 P, vec2 dPdx, vec2 dPdy);
float textureGrad(sampler2DShadow s, vec3 P, vec2 dPdx, vec2 dPdy);
float textureGrad(samplerCubeShadow s, vec4 P, vec3 dPdx, vec3 dPdy);
float textureGrad(sampler2DArrayShadow s, vec4 P, vec2 dPdx, vec2 dPdy);
gvec4 textureGradOffset(gsampler2D s, vec2 P, vec2 dPdx, vec2 dPdy, const ivec2 offset);
gvec4 textureGradOffset(gsampler3D s, vec3 P, vec3 dPdx, vec3 dPdy, const ivec3 offset);
gvec4 textureGradOffset(gsampler2DArray s, vec3 P, vec2 dPdx, vec2 dPdy, const ivec2 offset);
float textureGradOffset(sampler2DShadow s, vec3 P, vec2 dPdx, vec2 dPdy, const ivec2 offset);
float textureGradOffset(sampler2DArrayShadow s, vec4 P, vec2 dPdx, vec2 dPdy, const ivec2 offset);
gvec4 textureProjGrad(gsampler2D s, vec3 P, vec2 dPdx, vec2 dPdy);
gvec4 textureProjGrad(gsampler2D s, vec4 P, vec2 dPdx, vec2 dPdy);
gvec4 textureProjGrad(gsampler3D s, vec4 P, vec3 dPdx, vec3 dPdy);
float textureProjGrad(sampler2DShadow s, vec4 P, vec2 dPdx, vec2 dPdy);
gvec4 textureProjGradOffset(gsampler2D s, vec3 P, vec2 dPdx, vec2 dPdy, const ivec2 offset);
gvec4 textureProjGradOffset(gsampler2D s, vec4 P, vec2 dPdx, vec2 dPdy, const ivec2 offset);
gvec4 textureProjGradOffset(gsampler3D s, vec4 P, vec3 dPdx, vec3 dPdy, const ivec3 offset);
float textureProjGradOffset(sampler2DShadow s, vec4 P, vec2 dPdx, vec2 dPdy, const ivec2 offset);
