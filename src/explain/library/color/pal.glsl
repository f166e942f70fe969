// Colours that change smoothly with a number, by a cosine in each channel.
// SPDX-License-Identifier: 0BSD

// All hues; repeats after 1.
vec3 pal(float t) {
    return 0.5 + 0.5 * cos(6.2831853 * (t + vec3(0.0, 1.0, 2.0) / 3.0));
}

// By the middle, the amplitude, the frequency and the phase of each channel.
vec3 pal(float t, vec3 middle, vec3 amplitude, vec3 frequency, vec3 phase) {
    return middle + amplitude * cos(6.2831853 * (frequency * t + phase));
}
