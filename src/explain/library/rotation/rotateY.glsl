// Rotation of space about the y axis by an angle in radians.
// SPDX-License-Identifier: 0BSD

// A matrix m for `p * m`, which turns counterclockwise seen from the positive y axis.
mat3 rotateY(float angle) {
    float c = cos(angle);
    float s = sin(angle);
    return mat3(c, 0.0, s, 0.0, 1.0, 0.0, -s, 0.0, c);
}

// Turns a point counterclockwise, seen from the positive y axis.
vec3 rotateY(vec3 p, float angle) {
    float c = cos(angle);
    float s = sin(angle);
    return vec3(c * p.x + s * p.z, p.y, c * p.z - s * p.x);
}
