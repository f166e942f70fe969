// The second shape without the first, by their distances.
// SPDX-License-Identifier: 0BSD

// Negative inside of the second shape and outside of the first.
float opSubtraction(float d1, float d2) {
    return max(-d1, d2);
}
