//# Functions
//: refused 1 int-float-mix: a function of floats given ints
float a = sin(1);
//: refused 1 vector-size: a function of one size given two
vec3 a = max(vec3(1.), vec2(1.));
//: accepted: the greater of a vector and a number
vec3 a = max(vec3(1.), 1.);
//: refused 1 vector-size: the greater of a number and a vector
vec3 a = max(1., vec3(1.));
//: refused 1 vector-size: a power of a vector by a number
vec3 a = pow(vec3(2.), 2.);
//: accepted: a mix by a number
vec3 a = mix(vec3(1.), vec3(2.), .5);
//: accepted: a mix by booleans
vec3 a = mix(vec3(1.), vec3(2.), bvec3(true));
//: refused 1 int-float-mix: a mix of ints by a boolean
int a = mix(1, 2, true);
//: accepted: clamping ints
int a = clamp(1, 2, 3);
//: refused 1 int-float-mix: clamping an int by floats
int a = clamp(1, 2., 3.);
//: accepted: the size of an int
int a = abs(-1) + sign(-1) + min(1, 2);
//: refused 1 int-float-mix: the size of an unsigned number
uint a = abs(1u);
//: accepted: rounding
float a = round(1.5) + roundEven(2.5) + trunc(1.5);
//: refused 1 int-float-mix: a remainder of ints by the function
int a = mod(5, 2);
//: accepted: the fractional and integer part of `modf`
float a, b; void f() { a = modf(1.5, b); }
//: refused 1 not-assignable: the integer part of `modf` stored to a constant
const float b = 1.; float f() { return modf(1.5, b); }
//: accepted: the bits of a float
int a = floatBitsToInt(1.); uint b = floatBitsToUint(1.); float c = intBitsToFloat(1);
//: refused 1 int-float-mix: a float of unsigned bits by the wrong function
float c = intBitsToFloat(1u);
//: accepted: packing
uint a = packHalf2x16(vec2(1.)) + packSnorm2x16(vec2(1.)) + packUnorm2x16(vec2(1.));
//: refused 1 undeclared-name: packing of GLSL ES 3.10
uint a = packUnorm4x8(vec4(1.));
//: refused 1 undeclared-name: fused operations of GLSL ES 3.10
float a = fma(1., 2., 3.);
//: refused 1 undeclared-name: counting bits, as GLSL ES 3.10 does
int a = bitCount(7);
//: refused 1 vector-size: the cross product has three dimensions
vec2 a = cross(vec2(1.), vec2(2.));
//: accepted: a dot product of numbers
float a = dot(1., 2.);
//: refused 1 int-float-mix: a dot product of ints
int a = dot(ivec2(1), ivec2(2));
//: accepted: the length of a number
float a = length(-1.) + distance(1., 2.) + normalize(3.);
//: accepted: an outer product
mat2x3 a = outerProduct(vec3(1.), vec2(1.));
//: refused 1 vector-size: an outer product the other way round
mat2x3 a = outerProduct(vec2(1.), vec3(1.));
//: accepted: a transposed matrix
mat3x2 a = transpose(mat2x3(1.));
//: accepted: the inverse of a square matrix
mat2 a = inverse(mat2(2.)); float b = determinant(mat3(1.));
//: refused 1 argument-mismatch: the inverse of a matrix that is not square
mat2x3 a = inverse(mat2x3(1.));
//: accepted: components multiplied one by one
mat2 a = matrixCompMult(mat2(1.), mat2(2.));
//: accepted: comparisons of vectors
bvec2 a = lessThan(vec2(1.), vec2(2.)); bvec2 b = equal(bvec2(true), bvec2(false));
//: refused 1 vector-size: comparisons of numbers by the vectors' function
bool a = lessThan(1., 2.);
//: refused 1 argument-mismatch: booleans are not ordered
bvec2 a = lessThan(bvec2(true), bvec2(false));
//: refused 1 argument-mismatch: `not` of a boolean
bool a = not(true);
//: refused 1 argument-mismatch: `any` of floats
bool a = any(vec2(1.));
//: accepted: an arc of two arguments and of one
float a = atan(1.) + atan(1., 2.);
//: refused 1 undeclared-name: an arc by the name of C
float a = atan2(1., 2.);
//: accepted: hyperbolic functions
float a = sinh(1.) + acosh(2.) + atanh(.5);
//: refused 1 needs-webgl2, 100: hyperbolic functions in GLSL ES 1.00
void main() { sinh(1.); }
//: refused 1 needs-webgl2, 100: rounding in GLSL ES 1.00
void main() { round(1.); }
//: refused 1 needs-webgl2, 100: a transposed matrix in GLSL ES 1.00
void main() { transpose(mat2(1.)); }
//: refused 1 undeclared-name: the names of HLSL
float a = saturate(1.) + lerp(1., 2., .5);
//: refused 1 undeclared-name: a logarithm of base ten
float a = log10(1.);
//: refused 1 undeclared-name: noise
float a = noise1(1.);
//: refused 1 undeclared-name: a fraction by the name of HLSL
float a = frac(1.5);
//: accepted: a derivative
in float a; float f() { return dFdx(a) + fwidth(a); }
//: refused 1 undeclared-name, vertex: a derivative in a vertex shader
in float a; float f() { return dFdx(a); }
//: refused 1 needs-webgl2, 100: a derivative in GLSL ES 1.00
varying float a; float f() { return dFdx(a); }
//: refused 4 needs-webgl2, 100: an extension that WebGL2 does not provide: derivatives
#version 100
#extension GL_OES_standard_derivatives : enable
precision mediump float;
varying float a; float f() { return dFdx(a); }
void main() {}
//: refused 1 int-float-mix: a derivative of an int
flat in int a; int f() { return dFdx(a); }

//# Lookups
//: accepted: a lookup in two dimensions
uniform sampler2D s; vec4 f() { return texture(s, vec2(0.)); }
//: refused 1 vector-size: a lookup in two dimensions by three
uniform sampler2D s; vec4 f() { return texture(s, vec3(0.)); }
//: refused 1 integer-length: a lookup by ints
uniform sampler2D s; vec4 f() { return texture(s, ivec2(0)); }
//: accepted: a lookup with a bias
uniform sampler2D s; vec4 f() { return texture(s, vec2(0.), 1.); }
//: refused 1 int-float-mix: a lookup with a bias that is an int
uniform sampler2D s; vec4 f() { return texture(s, vec2(0.), 1); }
//: refused 1 argument-mismatch, vertex: a lookup with a bias in a vertex shader
uniform sampler2D s; vec4 f() { return texture(s, vec2(0.), 1.); }
//: accepted: a lookup in a cube
uniform samplerCube s; vec4 f() { return texture(s, vec3(0.)); }
//: accepted: a lookup in a shadow gives a number
uniform highp sampler2DShadow s; float f() { return texture(s, vec3(0.)); }
//: refused 1 vector-size: a shadow lookup does not return a color
uniform highp sampler2DShadow s; vec4 f() { return texture(s, vec3(0.)); }
//: refused 1 argument-mismatch: a lookup in an array of shadow textures has no bias
uniform highp sampler2DArrayShadow s; float f() { return texture(s, vec4(0.), 1.); }
//: accepted: a lookup of ints
uniform highp isampler2D s; ivec4 f() { return texture(s, vec2(0.)); }
//: refused 1 int-float-mix: an integer lookup does not return floats
uniform highp isampler2D s; vec4 f() { return texture(s, vec2(0.)); }
//: accepted: a texel
uniform sampler2D s; vec4 f() { return texelFetch(s, ivec2(0), 0); }
//: refused 1 argument-mismatch: a texel without a level
uniform sampler2D s; vec4 f() { return texelFetch(s, ivec2(0)); }
//: refused 1 argument-mismatch: a texel of a cube
uniform samplerCube s; vec4 f() { return texelFetch(s, ivec3(0), 0); }
//: refused 1 int-float-mix: a texel by floats
uniform sampler2D s; vec4 f() { return texelFetch(s, vec2(0.), 0); }
//: accepted: the size of a texture
uniform sampler2D s; ivec2 f() { return textureSize(s, 0); }
//: refused 1 argument-mismatch: the size of a texture without a level
uniform sampler2D s; ivec2 f() { return textureSize(s); }
//: refused 1 int-float-mix: the size of a texture in floats
uniform sampler2D s; vec2 f() { return textureSize(s, 0); }
//: accepted: an offset
uniform sampler2D s; vec4 f() { return textureOffset(s, vec2(0.), ivec2(1)); }
//: refused 1 not-constant: an offset that is not constant
uniform sampler2D s; uniform ivec2 o; vec4 f() { return textureOffset(s, vec2(0.), o); }
//: accepted: the least offset
uniform sampler2D s; vec4 f() { return textureOffset(s, vec2(0.), ivec2(-8, 7)); }
//: refused 1 index-out-of-range: an offset too small
uniform sampler2D s; vec4 f() { return textureOffset(s, vec2(0.), ivec2(-9, 0)); }
//: refused 1 index-out-of-range: an offset too large
uniform sampler2D s; vec4 f() { return textureOffset(s, vec2(0.), ivec2(0, 8)); }
//: accepted: an offset by a constant
uniform sampler2D s; const ivec2 o = ivec2(1); vec4 f() { return textureOffset(s, vec2(0.), o); }
//: refused 1 argument-mismatch: an offset in a cube
uniform samplerCube s; vec4 f() { return textureOffset(s, vec3(0.), ivec3(1)); }
//: accepted: a projected lookup by three and by four
uniform sampler2D s; vec4 f() { return textureProj(s, vec3(1.)) + textureProj(s, vec4(1.)); }
//: refused 1 argument-mismatch: a projected lookup by two
uniform sampler2D s; vec4 f() { return textureProj(s, vec2(1.)); }
//: accepted: gradients
uniform sampler2D s; vec4 f() { return textureGrad(s, vec2(0.), vec2(1.), vec2(1.)); }
//: refused 1 legacy-glsl: the lookups of GLSL ES 1.00
uniform sampler2D s; vec4 f() { return texture2D(s, vec2(0.)); }
//: refused 1 needs-webgl2, 100: the lookups of GLSL ES 3.00 in GLSL ES 1.00
uniform sampler2D s; vec4 f() { return texture(s, vec2(0.)); }
//: refused 1 undeclared-name, 100: a level in a fragment shader of GLSL ES 1.00
uniform sampler2D s; vec4 f() { return texture2DLod(s, vec2(0.), 0.); }
//: accepted, 100 vertex: a level in a vertex shader of GLSL ES 1.00
uniform sampler2D s; vec4 f() { return texture2DLod(s, vec2(0.), 0.); }
//: refused 4 missing-extension, 100: an extension that WebGL2 does not provide: levels
#version 100
#extension GL_EXT_shader_texture_lod : enable
precision mediump float;
uniform sampler2D s; vec4 f() { return texture2DLodEXT(s, vec2(0.), 0.); }
void main() {}
//: refused 1 argument-mismatch, 100 vertex: a bias in a vertex shader of GLSL ES 1.00
uniform sampler2D s; vec4 f() { return texture2D(s, vec2(0.), 1.); }
//: refused 1 undeclared-name: gathering, as GLSL ES 3.10 does
uniform sampler2D s; vec4 f() { return textureGather(s, vec2(0.)); }

//# Variables and constants
//: accepted: what a fragment shader has
vec4 f() { return gl_FragCoord + vec4(gl_PointCoord, gl_FrontFacing, 0.); }
//: refused 1 not-assignable: gl_FragCoord is written
void main() { gl_FragCoord.x = 1.; }
//: accepted: gl_FragDepth is written and read
void main() { gl_FragDepth = .5; gl_FragDepth += .1; }
//: refused 1 needs-webgl2, 100: gl_FragDepth in GLSL ES 1.00
void main() { gl_FragDepth = .5; }
//: refused 4 missing-extension, 100: an extension that WebGL2 does not provide: depth
#version 100
#extension GL_EXT_frag_depth : enable
precision mediump float;
void main() { gl_FragDepthEXT = .5; }
//: accepted, vertex: what a vertex shader has
void main() { gl_Position = vec4(gl_VertexID, gl_InstanceID, 0, 1); gl_PointSize = 1.; }
//: refused 1 not-assignable, vertex: gl_VertexID is written
void main() { gl_VertexID = 1; }
//: refused 1 undeclared-name, vertex: gl_FragCoord in a vertex shader
void main() { gl_Position = gl_FragCoord; }
//: refused 1 undeclared-name: gl_Position in a fragment shader
void main() { gl_Position = vec4(1.); }
//: refused 1 needs-webgl2, 100 vertex: gl_VertexID in GLSL ES 1.00
void main() { gl_Position = vec4(gl_VertexID); }
//: accepted, vertex: gl_Position is read
void main() { gl_Position = vec4(1.); gl_Position.x += gl_Position.y; }
//: accepted: gl_DepthRange
float a() { return gl_DepthRange.near + gl_DepthRange.diff; }
//: refused 1 not-assignable: gl_DepthRange is written
void main() { gl_DepthRange.near = 1.; }
//: accepted: constants are constant
const int a = gl_MaxTextureImageUnits + gl_MaxVertexAttribs;
//: refused 1 undeclared-name: a constant that GLSL ES 1.00 alone has
int a = gl_MaxVaryingVectors;
//: accepted, 100: a constant of GLSL ES 1.00
const int a = gl_MaxVaryingVectors;
//: accepted: offsets of texels
int a = gl_MinProgramTexelOffset;
//: refused 1 not-assignable: a constant is written
void main() { gl_MaxDrawBuffers = 1; }
//: accepted: limits of GLSL ES 3.00
int a = gl_MaxFragmentUniformVectors + gl_MaxVertexOutputVectors + gl_MaxFragmentInputVectors;
//: refused 1 undeclared-name: matrices of desktop GLSL
vec4 a() { return gl_ModelViewProjectionMatrix * vec4(1.); }
//: refused 1 undeclared-name: gl_Vertex of desktop GLSL
vec4 a() { return gl_Vertex; }
//: accepted: gl_FrontFacing is a boolean
float a() { return gl_FrontFacing ? 1. : 0.; }
//: refused 1 swizzle-out-of-range: gl_PointCoord has two components
float a() { return gl_PointCoord.z; }
