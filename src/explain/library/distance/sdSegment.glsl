// Distance to a line segment.
// SPDX-License-Identifier: 0BSD

// From a to b, in the plane.
float sdSegment(vec2 p, vec2 a, vec2 b) {
    vec2 edge = b - a;
    float t = dot(p - a, edge) / max(dot(edge, edge), 1e-12);
    return distance(p, a + clamp(t, 0.0, 1.0) * edge);
}

// From a to b, in space.
float sdSegment(vec3 p, vec3 a, vec3 b) {
    vec3 edge = b - a;
    float t = dot(p - a, edge) / max(dot(edge, edge), 1e-12);
    return distance(p, a + clamp(t, 0.0, 1.0) * edge);
}
