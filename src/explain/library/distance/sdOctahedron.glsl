// Signed distance to a regular octahedron, negative inside.
// SPDX-License-Identifier: 0BSD

// Around the origin, with corners at this distance on the axes.
float sdOctahedron(vec3 p, float size) {
    vec3 q = abs(p);
    // The smallest coordinate becomes the last one.
    if (q.x <= min(q.y, q.z)) {
        q = q.yzx;
    } else if (q.y <= q.z) {
        q = q.zxy;
    }
    float above = (q.x + q.y + q.z - size) / 3.0;
    if (q.z >= above) {
        return 1.7320508 * above;
    }
    float t = clamp(0.5 * (size + q.x - q.y), 0.0, size);
    return distance(q, vec3(t, size - t, 0.0));
}
