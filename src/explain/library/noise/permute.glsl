// Whole numbers 0 to 288 in a shuffled order: a polynomial that permutes them, modulo 289.
// SPDX-License-Identifier: 0BSD

// One number.
float permute(float x) {
    return mod(x * (51.0 * x + 7.0), 289.0);
}

// Two numbers.
vec2 permute(vec2 x) {
    return mod(x * (51.0 * x + 7.0), 289.0);
}

// Three numbers.
vec3 permute(vec3 x) {
    return mod(x * (51.0 * x + 7.0), 289.0);
}

// Four numbers.
vec4 permute(vec4 x) {
    return mod(x * (51.0 * x + 7.0), 289.0);
}
