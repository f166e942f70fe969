// Signed distance to a sphere, negative inside.
// SPDX-License-Identifier: 0BSD

// Around the origin.
float sdSphere(vec3 p, float radius) {
    return length(p) - radius;
}
