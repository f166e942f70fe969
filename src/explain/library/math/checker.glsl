// Checkerboard with fields of the size 1: 0 or 1.
// SPDX-License-Identifier: 0BSD

// In the plane.
float checker(vec2 p) {
    vec2 field = floor(p);
    return mod(field.x + field.y, 2.0);
}

// In space.
float checker(vec3 p) {
    vec3 field = floor(p);
    return mod(field.x + field.y + field.z, 2.0);
}
