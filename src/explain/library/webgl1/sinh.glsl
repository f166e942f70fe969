// Hyperbolic sine, which GLSL ES 1.00 lacks.
// SPDX-License-Identifier: 0BSD

// One number.
float sinh(float x) {
    return 0.5 * (exp(x) - exp(-x));
}

// Two numbers.
vec2 sinh(vec2 x) {
    return 0.5 * (exp(x) - exp(-x));
}

// Three numbers.
vec3 sinh(vec3 x) {
    return 0.5 * (exp(x) - exp(-x));
}

// Four numbers.
vec4 sinh(vec4 x) {
    return 0.5 * (exp(x) - exp(-x));
}
