// The second shape without the first, by their distances, with a smooth blend of the width k.
// SPDX-License-Identifier: 0BSD

// Blends where `-d1` and `d2` differ by less than `k`.
float opSmoothSubtraction(float d1, float d2, float k) {
    float h = max(k - abs(d1 + d2), 0.0);
    return max(-d1, d2) + h * h / max(4.0 * k, 1e-6);
}
