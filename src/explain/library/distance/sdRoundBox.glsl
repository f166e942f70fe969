// Signed distance to a box with round edges, negative inside.
// SPDX-License-Identifier: 0BSD

// A box around the origin, by half its size, grown by the radius of the edges.
float sdRoundBox(vec3 p, vec3 halfSize, float radius) {
    vec3 d = abs(p) - halfSize;
    return length(max(d, 0.0)) + min(max(d.x, max(d.y, d.z)), 0.0) - radius;
}
