// Signed distance to a capsule: all points within a radius of a segment, negative inside.
// SPDX-License-Identifier: 0BSD

// From a to b.
float sdCapsule(vec3 p, vec3 a, vec3 b, float radius) {
    vec3 edge = b - a;
    float t = dot(p - a, edge) / max(dot(edge, edge), 1e-12);
    return distance(p, a + clamp(t, 0.0, 1.0) * edge) - radius;
}
