// Approximate 1 / sqrt(r) near r = 0.7: the tangent there.
// SPDX-License-Identifier: 0BSD

// One number.
float taylorInvSqrt(float r) {
    return 1.7928429 - 0.8537347 * r;
}

// Two numbers.
vec2 taylorInvSqrt(vec2 r) {
    return 1.7928429 - 0.8537347 * r;
}

// Three numbers.
vec3 taylorInvSqrt(vec3 r) {
    return 1.7928429 - 0.8537347 * r;
}

// Four numbers.
vec4 taylorInvSqrt(vec4 r) {
    return 1.7928429 - 0.8537347 * r;
}
