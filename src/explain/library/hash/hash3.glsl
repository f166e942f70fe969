// Triples of pseudo-random numbers in [0, 1), the same for equal arguments.
// SPDX-License-Identifier: 0BSD

// Three numbers by a number.
vec3 hash3(float x) {
    vec3 q = fract(x * vec3(0.4271, 0.3307, 0.5639));
    for (int i = 0; i < 4; i++) {
        q = fract((q + vec3(31.17, 43.61, 37.93)) * (q.yzx + vec3(53.29, 61.83, 47.11)));
    }
    return q;
}

// Three numbers by a point of the plane.
vec3 hash3(vec2 p) {
    vec3 q = fract(p.xyx * vec3(0.4271, 0.3307, 0.5639));
    for (int i = 0; i < 4; i++) {
        q = fract((q + vec3(31.17, 43.61, 37.93)) * (q.yzx + vec3(53.29, 61.83, 47.11)));
    }
    return q;
}

// Three numbers by a point of space.
vec3 hash3(vec3 p) {
    vec3 q = fract(p * vec3(0.4271, 0.3307, 0.5639));
    for (int i = 0; i < 4; i++) {
        q = fract((q + vec3(31.17, 43.61, 37.93)) * (q.yzx + vec3(53.29, 61.83, 47.11)));
    }
    return q;
}
