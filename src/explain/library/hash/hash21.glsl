// Pseudo-random numbers in [0, 1), the same for equal arguments.
// SPDX-License-Identifier: 0BSD

// Two numbers by a number.
vec2 hash21(float x) {
    vec2 q = fract(x * vec2(0.4271, 0.3307));
    for (int i = 0; i < 4; i++) {
        q = fract((q + vec2(31.17, 43.61)) * (q.yx + vec2(53.29, 61.83)));
    }
    return q;
}

// A number by a point of the plane.
float hash21(vec2 p) {
    vec2 q = fract(p * vec2(0.4271, 0.3307));
    for (int i = 0; i < 4; i++) {
        q = fract((q + vec2(31.17, 43.61)) * (q.yx + vec2(53.29, 61.83)));
    }
    return q.x;
}
