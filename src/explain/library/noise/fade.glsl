// Smooth step from 0 to 1 for t in [0, 1], with zero first and second derivatives at both ends.
// SPDX-License-Identifier: 0BSD

// One number.
float fade(float t) {
    return t * t * t * (t * (6.0 * t - 15.0) + 10.0);
}

// Two numbers.
vec2 fade(vec2 t) {
    return t * t * t * (t * (6.0 * t - 15.0) + 10.0);
}

// Three numbers.
vec3 fade(vec3 t) {
    return t * t * t * (t * (6.0 * t - 15.0) + 10.0);
}

// Four numbers.
vec4 fade(vec4 t) {
    return t * t * t * (t * (6.0 * t - 15.0) + 10.0);
}
