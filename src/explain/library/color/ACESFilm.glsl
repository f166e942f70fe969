// Filmic tone mapping: a rational fit of the ACES curve.
// SPDX-License-Identifier: 0BSD

// From linear colours without a limit to [0, 1].
vec3 ACESFilm(vec3 color) {
    vec3 x = max(color, 0.0);
    vec3 over = x * (2.51 * x + 0.03);
    return clamp(over / (x * (2.43 * x + 0.59) + 0.14), 0.0, 1.0);
}
