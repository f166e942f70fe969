// Hue, saturation and value of a colour.
// SPDX-License-Identifier: 0BSD

// All are in [0, 1]; greys have the hue 0, black has the saturation 0.
vec3 rgb2hsv(vec3 rgb) {
    float value = max(rgb.r, max(rgb.g, rgb.b));
    float chroma = value - min(rgb.r, min(rgb.g, rgb.b));
    if (chroma <= 0.0) {
        return vec3(0.0, 0.0, value);
    }
    float hue = 4.0 + (rgb.r - rgb.g) / chroma;
    if (rgb.r >= value) {
        hue = (rgb.g - rgb.b) / chroma;
    } else if (rgb.g >= value) {
        hue = 2.0 + (rgb.b - rgb.r) / chroma;
    }
    return vec3(fract(hue / 6.0), chroma / value, value);
}
