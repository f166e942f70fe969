#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#define saturate(a) clamp(a, 0.0, 1.0)
#define whiteComplement(a) (1.0 - saturate(a))
float luminance(const in vec3 c) { return dot(c, vec3(0.2126729, 0.7151522, 0.072175)); }
vec4 sRGBTransferOETF(in vec4 c) { return vec4(mix(1.055 * pow(c.rgb, vec3(1.0 / 2.4)) - 0.055, 12.92 * c.rgb, vec3(lessThanEqual(c.rgb, vec3(0.0031308)))), c.a); }
vec4 sRGBTransferEOTF(in vec4 c) { return vec4(mix(pow((c.rgb + 0.055) / 1.055, vec3(2.4)), c.rgb / 12.92, vec3(lessThanEqual(c.rgb, vec3(0.04045)))), c.a); }
vec4 linearToOutputTexel(vec4 c) { return sRGBTransferOETF(c); }
float pow2(float x) { return x * x; }
vec3 pow2(vec3 x) { return x * x; }
float pow3(float x) { return x * x * x; }
float pow4(float x) { return pow2(pow2(x)); }
float max3(vec3 v) { return max(v.x, max(v.y, v.z)); }
float average(vec3 v) { return dot(v, vec3(1.0 / 3.0)); }
float rand(vec2 p) { return fract(sin(mod(dot(p, vec2(12.9898, 78.233)), 3.141592653589793)) * 43758.5453); }
vec3 transformDirection(vec3 v, mat4 m) { return normalize(mat3(m) * v); }
vec3 inverseTransformDirection(vec3 v, mat4 m) { return normalize(v * mat3(m)); }
vec2 equirectUv(vec3 v) { return vec2(atan(v.z, v.x) / 6.283185307179586 + 0.5, asin(clamp(v.y, -1.0, 1.0)) / 3.141592653589793 + 0.5); }
vec3 packNormalToRGB(vec3 n) { return 0.5 * normalize(n) + 0.5; }
vec3 unpackRGBToNormal(vec3 c) { return 2.0 * c - 1.0; }
vec4 packDepthToRGBA(float d) { vec4 p = fract(clamp(d, 0.0, 0.999999) * vec4(1.0, 256.0, 65536.0, 16777216.0)); return p - p.yzww * vec4(vec3(1.0 / 256.0), 0.0); }
float unpackRGBAToDepth(vec4 c) { return dot(c, vec4(1.0, 1.0 / 256.0, 1.0 / 65536.0, 1.0 / 16777216.0)); }
vec2 packDepthToRG(float d) { return packDepthToRGBA(d).rg; }
float unpackRGToDepth(vec2 c) { return unpackRGBAToDepth(vec4(c, 0.0, 0.0)); }
vec4 pack2HalfToRGBA(vec2 v) { vec4 p = vec4(v.x, fract(255.0 * v.x), v.y, fract(255.0 * v.y)); return p - p.yyww * vec4(1.0 / 255.0, 0.0, 1.0 / 255.0, 0.0); }
vec2 unpackRGBATo2Half(vec4 c) { return c.xz + c.yw / 255.0; }
float viewZToOrthographicDepth(float z, float near, float far) { return (z + near) / (near - far); }
float orthographicDepthToViewZ(float d, float near, float far) { return d * (near - far) - near; }
float viewZToPerspectiveDepth(float z, float near, float far) { return (near + z) * far / ((far - near) * z); }
float perspectiveDepthToViewZ(float d, float near, float far) { return near * far / ((far - near) * d - far); }
