// Hyperbolic cosine, which GLSL ES 1.00 lacks.
// SPDX-License-Identifier: 0BSD

// One number.
float cosh(float x) {
    return 0.5 * (exp(x) + exp(-x));
}

// Two numbers.
vec2 cosh(vec2 x) {
    return 0.5 * (exp(x) + exp(-x));
}

// Three numbers.
vec3 cosh(vec3 x) {
    return 0.5 * (exp(x) + exp(-x));
}

// Four numbers.
vec4 cosh(vec4 x) {
    return 0.5 * (exp(x) + exp(-x));
}
