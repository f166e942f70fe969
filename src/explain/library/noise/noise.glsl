// Value noise in [0, 1]: smooth, with features of about the size 1.
// SPDX-License-Identifier: 0BSD

// Along a line.
float noise(float x) {
    float cell = floor(x);
    float f = x - cell;
    return mix(hash11(cell), hash11(cell + 1.0), f * f * (3.0 - 2.0 * f));
}

// In the plane.
float noise(vec2 p) {
    vec2 cell = floor(p);
    vec2 f = p - cell;
    vec2 w = f * f * (3.0 - 2.0 * f);
    float low = mix(hash12(cell), hash12(cell + vec2(1.0, 0.0)), w.x);
    float high = mix(hash12(cell + vec2(0.0, 1.0)), hash12(cell + vec2(1.0, 1.0)), w.x);
    return mix(low, high, w.y);
}

// In space.
float noise(vec3 p) {
    vec3 cell = floor(p);
    vec3 f = p - cell;
    vec3 w = f * f * (3.0 - 2.0 * f);
    float sum = 0.0;
    for (int i = 0; i < 4; i++) {
        float upper = floor(float(i) / 2.0);
        vec3 corner = vec3(0.0, float(i) - 2.0 * upper, upper);
        float edge = mix(hash13(cell + corner), hash13(cell + corner + vec3(1.0, 0.0, 0.0)), w.x);
        vec2 share = mix(1.0 - w.yz, w.yz, corner.yz);
        sum += edge * share.x * share.y;
    }
    return sum;
}
