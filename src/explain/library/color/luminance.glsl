// Brightness of a linear colour, with the weights of Rec. 709.
// SPDX-License-Identifier: 0BSD

// Of red, green and blue.
float luminance(vec3 rgb) {
    return dot(rgb, vec3(0.2126, 0.7152, 0.0722));
}

// Of a colour with an opacity, which does not count.
float luminance(vec4 color) {
    return dot(color.rgb, vec3(0.2126, 0.7152, 0.0722));
}
