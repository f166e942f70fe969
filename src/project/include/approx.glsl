// What tests may call: whether two values are equal up to `eps` in each component. Without `eps`, up to
// 1e-5, or 1e-5 times the larger value if it exceeds 1.

bool approx(highp float a, highp float b, highp float eps) { return a == b || abs(a - b) <= eps; }
bool approx(highp float a, highp float b) { return approx(a, b, 1e-5 * max(1.0, max(abs(a), abs(b)))); }
bool approx(highp vec2 a, highp vec2 b, highp float eps) { return approx(a.x, b.x, eps) && approx(a.y, b.y, eps); }
bool approx(highp vec2 a, highp vec2 b) { return approx(a.x, b.x) && approx(a.y, b.y); }
bool approx(highp vec3 a, highp vec3 b, highp float eps) { return approx(a.xy, b.xy, eps) && approx(a.z, b.z, eps); }
bool approx(highp vec3 a, highp vec3 b) { return approx(a.xy, b.xy) && approx(a.z, b.z); }
bool approx(highp vec4 a, highp vec4 b, highp float eps) { return approx(a.xyz, b.xyz, eps) && approx(a.w, b.w, eps); }
bool approx(highp vec4 a, highp vec4 b) { return approx(a.xyz, b.xyz) && approx(a.w, b.w); }
bool approx(highp mat2 a, highp mat2 b, highp float eps) { return approx(a[0], b[0], eps) && approx(a[1], b[1], eps); }
bool approx(highp mat2 a, highp mat2 b) { return approx(a[0], b[0]) && approx(a[1], b[1]); }
bool approx(highp mat3 a, highp mat3 b, highp float eps) { return approx(a[0], b[0], eps) && approx(a[1], b[1], eps) && approx(a[2], b[2], eps); }
bool approx(highp mat3 a, highp mat3 b) { return approx(a[0], b[0]) && approx(a[1], b[1]) && approx(a[2], b[2]); }
bool approx(highp mat4 a, highp mat4 b, highp float eps) { return approx(a[0], b[0], eps) && approx(a[1], b[1], eps) && approx(a[2], b[2], eps) && approx(a[3], b[3], eps); }
bool approx(highp mat4 a, highp mat4 b) { return approx(a[0], b[0]) && approx(a[1], b[1]) && approx(a[2], b[2]) && approx(a[3], b[3]); }
