// Simplex noise in [-1, 1]: random slopes at the corners of triangles or tetrahedra.
// SPDX-License-Identifier: 0BSD

// In the plane.
float snoise(vec2 p) {
    const float UNSKEW = 0.21132487;
    vec2 cell = floor(p + 0.36602540 * (p.x + p.y));
    vec2 f = p - cell + UNSKEW * (cell.x + cell.y);
    vec2 rank = f.x > f.y ? vec2(1.0, 0.0) : vec2(0.0, 1.0);
    float sum = 0.0;
    for (int i = 0; i < 3; i++) {
        float k = float(i);
        vec2 corner = step(1.5 - k, rank);
        vec2 d = f - corner + UNSKEW * k;
        float angle = 6.2831853 * hash12(cell + corner);
        float share = max(0.5 - dot(d, d), 0.0);
        share *= share;
        sum += share * share * dot(vec2(cos(angle), sin(angle)), d);
    }
    return 99.204 * sum;
}

// In space.
float snoise(vec3 p) {
    vec3 cell = floor(p + (p.x + p.y + p.z) / 3.0);
    vec3 f = p - cell + (cell.x + cell.y + cell.z) / 6.0;
    // Of x over y, x over z, y over z.
    vec3 wins = step(f.yzz, f.xxy);
    vec3 rank = vec3(wins.x + wins.y, 1.0 - wins.x + wins.z, 2.0 - wins.y - wins.z);
    float sum = 0.0;
    for (int i = 0; i < 4; i++) {
        float k = float(i);
        vec3 corner = step(2.5 - k, rank);
        vec3 d = f - corner + k / 6.0;
        vec2 h = hash23(cell + corner) * vec2(2.0, 6.2831853) - vec2(1.0, 0.0);
        float r = sqrt(1.0 - h.x * h.x);
        float share = max(0.5 - dot(d, d), 0.0);
        share *= share;
        sum += share * share * dot(vec3(r * cos(h.y), r * sin(h.y), h.x), d);
    }
    return 107.653 * sum;
}
