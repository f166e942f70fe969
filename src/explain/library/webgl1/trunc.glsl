// The integer part, which GLSL ES 1.00 lacks.
// SPDX-License-Identifier: 0BSD

// One number.
float trunc(float x) {
    return sign(x) * floor(abs(x));
}

// Two numbers.
vec2 trunc(vec2 x) {
    return sign(x) * floor(abs(x));
}

// Three numbers.
vec3 trunc(vec3 x) {
    return sign(x) * floor(abs(x));
}

// Four numbers.
vec4 trunc(vec4 x) {
    return sign(x) * floor(abs(x));
}
