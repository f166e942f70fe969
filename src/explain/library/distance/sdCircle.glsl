// Signed distance to a circle, negative inside.
// SPDX-License-Identifier: 0BSD

// Around the origin.
float sdCircle(vec2 p, float radius) {
    return length(p) - radius;
}
