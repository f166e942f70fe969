// Encodes linear light for the screen, with the transfer function of sRGB.
// SPDX-License-Identifier: 0BSD

// One channel.
float sRGB(float linear) {
    float x = max(linear, 0.0);
    return x <= 0.0031308 ? 12.92 * x : 1.055 * pow(x, 1.0 / 2.4) - 0.055;
}

// Red, green and blue.
vec3 sRGB(vec3 linear) {
    vec3 x = max(linear, 0.0);
    vec3 bright = 1.055 * pow(x, vec3(1.0 / 2.4)) - 0.055;
    return mix(bright, 12.92 * x, step(x, vec3(0.0031308)));
}
