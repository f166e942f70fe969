// Colour from hue, saturation and value.
// SPDX-License-Identifier: 0BSD

// All are in [0, 1]; the hue repeats.
vec3 hsv2rgb(vec3 hsv) {
    vec3 wheel = abs(6.0 * fract(hsv.x + vec3(0.0, 2.0, 1.0) / 3.0) - 3.0);
    return hsv.z * mix(vec3(1.0), clamp(wheel - 1.0, 0.0, 1.0), hsv.y);
}
