// Moves a value from one interval to another, linearly and without clamping.
// SPDX-License-Identifier: 0BSD

// From `inMin` .. `inMax`, which differ, to `outMin` .. `outMax`.
float map(float value, float inMin, float inMax, float outMin, float outMax) {
    return mix(outMin, outMax, (value - inMin) / (inMax - inMin));
}
