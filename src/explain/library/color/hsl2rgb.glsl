// Colour from hue, saturation and lightness.
// SPDX-License-Identifier: 0BSD

// All are in [0, 1]; the hue repeats.
vec3 hsl2rgb(vec3 hsl) {
    vec3 wheel = abs(6.0 * fract(hsl.x + vec3(0.0, 2.0, 1.0) / 3.0) - 3.0);
    float chroma = hsl.y * (1.0 - abs(2.0 * hsl.z - 1.0));
    return hsl.z + chroma * (clamp(wheel - 1.0, 0.0, 1.0) - 0.5);
}
