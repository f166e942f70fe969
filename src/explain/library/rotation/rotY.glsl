// Rotation of space about the y axis by an angle in radians.
// SPDX-License-Identifier: 0BSD

// A matrix m for `p * m`, which turns counterclockwise seen from the positive y axis.
mat3 rotY(float angle) {
    float c = cos(angle);
    float s = sin(angle);
    return mat3(c, 0.0, s, 0.0, 1.0, 0.0, -s, 0.0, c);
}
