// Pseudo-random numbers in [0, 1), the same for equal arguments.
// SPDX-License-Identifier: 0BSD

// Four numbers by a point of space.
vec4 hash43(vec3 p) {
    vec4 q = fract(p.xyzx * vec4(0.4271, 0.3307, 0.5639, 0.2913));
    for (int i = 0; i < 4; i++) {
        vec4 k = q.yzwx + vec4(53.29, 61.83, 47.11, 57.71);
        q = fract((q + vec4(31.17, 43.61, 37.93, 29.47)) * k);
    }
    return q;
}
