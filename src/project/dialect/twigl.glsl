#define F4 0.309016994374947451
const float PI = 3.141592653589793;
const float PI2 = 6.283185307179586;
float mod289(float x) { return x - floor(x / 289.0) * 289.0; }
vec2 mod289(vec2 x) { return x - floor(x / 289.0) * 289.0; }
vec3 mod289(vec3 x) { return x - floor(x / 289.0) * 289.0; }
vec4 mod289(vec4 x) { return x - floor(x / 289.0) * 289.0; }
float permute(float x) { return mod289((34.0 * x + 1.0) * x); }
vec3 permute(vec3 x) { return mod289((34.0 * x + 1.0) * x); }
vec4 permute(vec4 x) { return mod289((34.0 * x + 1.0) * x); }
float taylorInvSqrt(float x) { return 1.79284291400159 - 0.85373472095314 * x; }
vec4 taylorInvSqrt(vec4 x) { return 1.79284291400159 - 0.85373472095314 * x; }
vec2 port_gradient(vec2 cell) {
    float turn = 6.283185307179586 * permute(permute(mod289(cell.x)) + mod289(cell.y)) / 41.0;
    return vec2(cos(turn), sin(turn));
}
vec3 port_gradient(vec3 cell) {
    float h = permute(permute(permute(mod289(cell.x)) + mod289(cell.y)) + mod289(cell.z));
    float z = 2.0 * fract(h / 7.0) - 1.0;
    float turn = 6.283185307179586 * fract(h / 49.0);
    return vec3(sqrt(1.0 - z * z) * vec2(cos(turn), sin(turn)), z);
}
// Noise on triangles: the corners of the cell that holds the place add what their gradients give.
float snoise2D(vec2 v) {
    vec2 cell = floor(v + 0.366025403784439 * (v.x + v.y));
    vec2 a = v - cell + 0.211324865405187 * (cell.x + cell.y);
    vec2 way = a.x > a.y ? vec2(1.0, 0.0) : vec2(0.0, 1.0);
    vec2 b = a - way + 0.211324865405187;
    vec2 c = a - 0.577350269189626;
    vec3 near = max(0.5 - vec3(dot(a, a), dot(b, b), dot(c, c)), 0.0);
    near *= near;
    near *= near;
    vec3 slope = vec3(dot(a, port_gradient(cell)), dot(b, port_gradient(cell + way)), dot(c, port_gradient(cell + 1.0)));
    return 99.0 * dot(near, slope);
}
float snoise3D(vec3 v) {
    vec3 cell = floor(v + (v.x + v.y + v.z) / 3.0);
    vec3 a = v - cell + (cell.x + cell.y + cell.z) / 6.0;
    vec3 over = step(a.yzx, a);
    vec3 first = min(over, 1.0 - over.zxy);
    vec3 second = max(over, 1.0 - over.zxy);
    vec3 b = a - first + 1.0 / 6.0;
    vec3 c = a - second + 1.0 / 3.0;
    vec3 d = a - 0.5;
    vec4 near = max(0.6 - vec4(dot(a, a), dot(b, b), dot(c, c), dot(d, d)), 0.0);
    near *= near;
    vec4 slope = vec4(dot(a, port_gradient(cell)), dot(b, port_gradient(cell + first)),
        dot(c, port_gradient(cell + second)), dot(d, port_gradient(cell + 1.0)));
    return 32.0 * dot(near * near, slope);
}
// The fourth place fades from one noise of three to the next.
float snoise4D(vec4 v) {
    float low = floor(v.w);
    float part = smoothstep(0.0, 1.0, v.w - low);
    vec3 step = vec3(17.3, 31.7, 5.9);
    return mix(snoise3D(v.xyz + step * low), snoise3D(v.xyz + step * (low + 1.0)), part);
}
float fsnoise(vec2 p) { return fract(43758.5453 * sin(dot(p, vec2(12.9898, 78.233)))); }
float fsnoiseDigits(vec2 p) { return fract(437.585453 * sin(dot(p, vec2(0.129898, 0.78233)))); }
vec3 hsv(float h, float s, float v) {
    vec3 hue = clamp(abs(6.0 * fract(h + vec3(1.0, 2.0 / 3.0, 1.0 / 3.0)) - 3.0) - 1.0, 0.0, 1.0);
    return v * mix(vec3(1.0), hue, s);
}
mat2 rotate2D(float turn) { return mat2(cos(turn), sin(turn), -sin(turn), cos(turn)); }
mat3 rotate3D(float turn, vec3 axis) {
    vec3 a = normalize(axis);
    vec3 s = sin(turn) * a;
    float c = cos(turn);
    vec3 rest = (1.0 - c) * a;
    return mat3(rest.x * a + vec3(c, s.z, -s.y), rest.y * a + vec3(-s.z, c, s.x), rest.z * a + vec3(s.y, -s.x, c));
}
