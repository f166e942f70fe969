// Rotation of space about the x axis by an angle in radians.
// SPDX-License-Identifier: 0BSD

// A matrix m for `p * m`, which turns counterclockwise seen from the positive x axis.
mat3 rotX(float angle) {
    float c = cos(angle);
    float s = sin(angle);
    return mat3(1.0, 0.0, 0.0, 0.0, c, -s, 0.0, s, c);
}
