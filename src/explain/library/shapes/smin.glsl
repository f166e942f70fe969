// Smooth minimum of two distances, by a polynomial.
// SPDX-License-Identifier: 0BSD

// Blends where the values differ by less than `k`; at most `k / 4` below min(a, b).
float smin(float a, float b, float k) {
    float h = max(k - abs(a - b), 0.0);
    return min(a, b) - h * h / max(4.0 * k, 1e-6);
}
