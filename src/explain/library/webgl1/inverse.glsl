// The inverse of a matrix, which GLSL ES 1.00 has no function for.
// SPDX-License-Identifier: 0BSD

// Two rows.
mat2 inverse(mat2 m) {
    float det = m[0].x * m[1].y - m[1].x * m[0].y;
    return mat2(m[1].y, -m[0].y, -m[1].x, m[0].x) / det;
}

// Three rows: the cross products of the columns are the rows of the adjugate.
mat3 inverse(mat3 m) {
    vec3 a = cross(m[1], m[2]), b = cross(m[2], m[0]), c = cross(m[0], m[1]);
    return mat3(a.x, b.x, c.x, a.y, b.y, c.y, a.z, b.z, c.z) / dot(m[0], a);
}

// Four rows (Lengyel, Foundations of Game Engine Development 1, section 1.7.5).
mat4 inverse(mat4 m) {
    vec3 a = m[0].xyz, b = m[1].xyz, c = m[2].xyz, d = m[3].xyz;
    vec4 w = vec4(m[0].w, m[1].w, m[2].w, m[3].w);
    vec3 s = cross(a, b), t = cross(c, d), u = a * w.y - b * w.x, v = c * w.w - d * w.z;
    float scale = 1.0 / (dot(s, v) + dot(t, u));
    s *= scale;
    t *= scale;
    u *= scale;
    v *= scale;
    vec3 p = cross(b, v) + t * w.y, q = cross(v, a) - t * w.x;
    vec3 r = cross(d, u) + s * w.w, o = cross(u, c) - s * w.z;
    return mat4(p.x, q.x, r.x, o.x, p.y, q.y, r.y, o.y, p.z, q.z, r.z, o.z,
                -dot(b, t), dot(a, t), -dot(d, s), dot(c, s));
}
