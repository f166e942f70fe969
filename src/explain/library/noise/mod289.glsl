// Remainder after division by 289, in [0, 289).
// SPDX-License-Identifier: 0BSD

// One number.
float mod289(float x) {
    return mod(x, 289.0);
}

// Two numbers.
vec2 mod289(vec2 x) {
    return mod(x, 289.0);
}

// Three numbers.
vec3 mod289(vec3 x) {
    return mod(x, 289.0);
}

// Four numbers.
vec4 mod289(vec4 x) {
    return mod(x, 289.0);
}
