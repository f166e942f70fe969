// Repeats space: a point relative to the centre of its cell; one cell is around the origin.
// SPDX-License-Identifier: 0BSD

// Along a line, by the positive width of a cell.
float opRep(float x, float period) {
    return mod(x + 0.5 * period, period) - 0.5 * period;
}

// In the plane, by the positive size of a cell.
vec2 opRep(vec2 p, vec2 period) {
    return mod(p + 0.5 * period, period) - 0.5 * period;
}

// In space, by the positive size of a cell.
vec3 opRep(vec3 p, vec3 period) {
    return mod(p + 0.5 * period, period) - 0.5 * period;
}

// In space, by the positive width of a cell in all directions.
vec3 opRep(vec3 p, float period) {
    return mod(p + 0.5 * period, period) - 0.5 * period;
}
