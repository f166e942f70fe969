// Product of two complex numbers, each as its real and its imaginary part.
// SPDX-License-Identifier: 0BSD

// Multiplies the lengths and adds the angles.
vec2 cmul(vec2 a, vec2 b) {
    return vec2(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x);
}
