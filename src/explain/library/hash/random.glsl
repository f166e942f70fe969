// Pseudo-random numbers in [0, 1), the same for equal arguments.
// SPDX-License-Identifier: 0BSD

// A number by a number.
float random(float x) {
    vec2 q = fract(x * vec2(0.4271, 0.3307));
    for (int i = 0; i < 4; i++) {
        q = fract((q + vec2(31.17, 43.61)) * (q.yx + vec2(53.29, 61.83)));
    }
    return q.x;
}

// A number by a point of the plane.
float random(vec2 p) {
    vec2 q = fract(p * vec2(0.4271, 0.3307));
    for (int i = 0; i < 4; i++) {
        q = fract((q + vec2(31.17, 43.61)) * (q.yx + vec2(53.29, 61.83)));
    }
    return q.x;
}

// A number by a point of space.
float random(vec3 p) {
    vec3 q = fract(p * vec3(0.4271, 0.3307, 0.5639));
    for (int i = 0; i < 4; i++) {
        q = fract((q + vec3(31.17, 43.61, 37.93)) * (q.yzx + vec3(53.29, 61.83, 47.11)));
    }
    return q.x;
}
