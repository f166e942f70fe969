// The nearest integer, which GLSL ES 1.00 lacks.
// SPDX-License-Identifier: 0BSD

// One number.
float round(float x) {
    return floor(x + 0.5);
}

// Two numbers.
vec2 round(vec2 x) {
    return floor(x + 0.5);
}

// Three numbers.
vec3 round(vec3 x) {
    return floor(x + 0.5);
}

// Four numbers.
vec4 round(vec4 x) {
    return floor(x + 0.5);
}
