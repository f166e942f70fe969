// Gradient noise in [-1, 1]: zero at whole coordinates, with random slopes.
// SPDX-License-Identifier: 0BSD

// In the plane.
float gnoise(vec2 p) {
    vec2 cell = floor(p);
    vec2 f = p - cell;
    vec2 w = f * f * f * (f * (6.0 * f - 15.0) + 10.0);
    float sum = 0.0;
    for (int i = 0; i < 4; i++) {
        float upper = floor(float(i) / 2.0);
        vec2 corner = vec2(float(i) - 2.0 * upper, upper);
        float angle = 6.2831853 * hash12(cell + corner);
        vec2 share = mix(1.0 - w, w, corner);
        sum += share.x * share.y * dot(vec2(cos(angle), sin(angle)), f - corner);
    }
    return 1.4142135 * sum;
}

// In space.
float gnoise(vec3 p) {
    vec3 cell = floor(p);
    vec3 f = p - cell;
    vec3 w = f * f * f * (f * (6.0 * f - 15.0) + 10.0);
    float sum = 0.0;
    for (int i = 0; i < 8; i++) {
        float k = float(i);
        vec3 corner = vec3(mod(k, 2.0), mod(floor(k / 2.0), 2.0), floor(k / 4.0));
        vec2 h = hash23(cell + corner) * vec2(2.0, 6.2831853) - vec2(1.0, 0.0);
        float r = sqrt(1.0 - h.x * h.x);
        vec3 slope = vec3(r * cos(h.y), r * sin(h.y), h.x);
        vec3 share = mix(1.0 - w, w, corner);
        sum += share.x * share.y * share.z * dot(slope, f - corner);
    }
    return 1.1547005 * sum;
}
