// Signed distance to a torus, negative inside.
// SPDX-License-Identifier: 0BSD

// Around the y axis, by the radius of the ring and the radius of the tube.
float sdTorus(vec3 p, vec2 radii) {
    return length(vec2(length(p.xz) - radii.x, p.y)) - radii.y;
}
