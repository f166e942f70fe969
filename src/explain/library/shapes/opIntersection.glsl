// Intersection of two shapes by their distances.
// SPDX-License-Identifier: 0BSD

// Negative where both distances are.
float opIntersection(float d1, float d2) {
    return max(d1, d2);
}
