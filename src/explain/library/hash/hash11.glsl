// Pseudo-random numbers in [0, 1), the same for equal arguments.
// SPDX-License-Identifier: 0BSD

// A number by a number.
float hash11(float x) {
    vec2 q = fract(x * vec2(0.4271, 0.3307));
    for (int i = 0; i < 4; i++) {
        q = fract((q + vec2(31.17, 43.61)) * (q.yx + vec2(53.29, 61.83)));
    }
    return q.x;
}
