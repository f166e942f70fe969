// Rotation of space about the z axis by an angle in radians.
// SPDX-License-Identifier: 0BSD

// A matrix m for `p * m`, which turns counterclockwise seen from the positive z axis.
mat3 rotateZ(float angle) {
    float c = cos(angle);
    float s = sin(angle);
    return mat3(c, -s, 0.0, s, c, 0.0, 0.0, 0.0, 1.0);
}

// Turns a point counterclockwise, seen from the positive z axis.
vec3 rotateZ(vec3 p, float angle) {
    float c = cos(angle);
    float s = sin(angle);
    return vec3(c * p.x - s * p.y, s * p.x + c * p.y, p.z);
}
