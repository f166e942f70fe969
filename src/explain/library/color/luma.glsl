// Brightness of a gamma-encoded colour, with the weights of Rec. 601.
// SPDX-License-Identifier: 0BSD

// Of red, green and blue.
float luma(vec3 rgb) {
    return dot(rgb, vec3(0.299, 0.587, 0.114));
}

// Of a colour with an opacity, which does not count.
float luma(vec4 color) {
    return dot(color.rgb, vec3(0.299, 0.587, 0.114));
}
