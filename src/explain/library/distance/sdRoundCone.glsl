// Signed distance to two spheres and the cone that touches both, negative inside.
// SPDX-License-Identifier: 0BSD

// A sphere at the origin with radius r1, one at the given height on the y axis with radius r2.
float sdRoundCone(vec3 p, float r1, float r2, float height) {
    vec2 q = vec2(length(p.xz), p.y);
    float slope = (r2 - r1) / max(height, 1e-6);
    float t = q.y + q.x * slope / sqrt(max(1.0 - slope * slope, 1e-6));
    t = clamp(t, 0.0, height);
    return length(q - vec2(0.0, t)) - r1 - slope * t;
}

// A sphere at a with radius r1, one at b with radius r2.
float sdRoundCone(vec3 p, vec3 a, vec3 b, float r1, float r2) {
    float height = max(distance(a, b), 1e-6);
    vec3 axis = (b - a) / height;
    float y = dot(p - a, axis);
    float x = distance(p, a + y * axis);
    float slope = (r2 - r1) / height;
    float t = y + x * slope / sqrt(max(1.0 - slope * slope, 1e-6));
    t = clamp(t, 0.0, height);
    return length(vec2(x, y - t)) - r1 - slope * t;
}
