// Union of two shapes by their distances.
// SPDX-License-Identifier: 0BSD

// The distance to the nearer shape.
float opUnion(float d1, float d2) {
    return min(d1, d2);
}

// Of two pairs of a distance and a material: the pair with the smaller distance.
vec2 opUnion(vec2 d1, vec2 d2) {
    return d1.x < d2.x ? d1 : d2;
}
