// Hyperbolic tangent, which GLSL ES 1.00 lacks.
// SPDX-License-Identifier: 0BSD

// One number; beyond 9 the result differs from 1 by less than a float can tell.
float tanh(float x) {
    float e = exp(2.0 * clamp(x, -9.0, 9.0));
    return (e - 1.0) / (e + 1.0);
}

// Two numbers.
vec2 tanh(vec2 x) {
    vec2 e = exp(2.0 * clamp(x, -9.0, 9.0));
    return (e - 1.0) / (e + 1.0);
}

// Three numbers.
vec3 tanh(vec3 x) {
    vec3 e = exp(2.0 * clamp(x, -9.0, 9.0));
    return (e - 1.0) / (e + 1.0);
}

// Four numbers.
vec4 tanh(vec4 x) {
    vec4 e = exp(2.0 * clamp(x, -9.0, 9.0));
    return (e - 1.0) / (e + 1.0);
}
