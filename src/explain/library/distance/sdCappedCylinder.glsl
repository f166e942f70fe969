// Signed distance to a cylinder with flat ends, negative inside.
// SPDX-License-Identifier: 0BSD

// Around the y axis.
float sdCappedCylinder(vec3 p, float radius, float halfHeight) {
    vec2 d = vec2(length(p.xz) - radius, abs(p.y) - halfHeight);
    return length(max(d, 0.0)) + min(max(d.x, d.y), 0.0);
}

// Around the y axis, by the radius and half the height.
float sdCappedCylinder(vec3 p, vec2 size) {
    vec2 d = vec2(length(p.xz) - size.x, abs(p.y) - size.y);
    return length(max(d, 0.0)) + min(max(d.x, d.y), 0.0);
}

// From a to b.
float sdCappedCylinder(vec3 p, vec3 a, vec3 b, float radius) {
    float height = max(distance(a, b), 1e-6);
    vec3 axis = (b - a) / height;
    float t = dot(p - a, axis);
    vec2 d = vec2(distance(p, a + t * axis) - radius, abs(t - 0.5 * height) - 0.5 * height);
    return length(max(d, 0.0)) + min(max(d.x, d.y), 0.0);
}
