// Pseudo-random numbers in [0, 1), the same for equal arguments.
// SPDX-License-Identifier: 0BSD

// Two numbers by a point of space.
vec2 hash23(vec3 p) {
    vec3 q = fract(p * vec3(0.4271, 0.3307, 0.5639));
    for (int i = 0; i < 4; i++) {
        q = fract((q + vec3(31.17, 43.61, 37.93)) * (q.yzx + vec3(53.29, 61.83, 47.11)));
    }
    return q.xy;
}
