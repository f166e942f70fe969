// Rotation of space about the x axis by an angle in radians.
// SPDX-License-Identifier: 0BSD

// A matrix m for `p * m`, which turns counterclockwise seen from the positive x axis.
mat3 rotateX(float angle) {
    float c = cos(angle);
    float s = sin(angle);
    return mat3(1.0, 0.0, 0.0, 0.0, c, -s, 0.0, s, c);
}

// Turns a point counterclockwise, seen from the positive x axis.
vec3 rotateX(vec3 p, float angle) {
    float c = cos(angle);
    float s = sin(angle);
    return vec3(p.x, c * p.y - s * p.z, s * p.y + c * p.z);
}
