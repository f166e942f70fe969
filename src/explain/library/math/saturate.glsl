// Clamps to [0, 1].
// SPDX-License-Identifier: 0BSD

// One number.
float saturate(float x) {
    return clamp(x, 0.0, 1.0);
}

// Two numbers.
vec2 saturate(vec2 x) {
    return clamp(x, 0.0, 1.0);
}

// Three numbers.
vec3 saturate(vec3 x) {
    return clamp(x, 0.0, 1.0);
}

// Four numbers.
vec4 saturate(vec4 x) {
    return clamp(x, 0.0, 1.0);
}
