// Distances to the nearest and second nearest of random points, one per unit cell; at most 1.
// SPDX-License-Identifier: 0BSD

// In the plane.
vec2 cellular(vec2 p) {
    vec2 cell = floor(p);
    vec2 nearest = vec2(1.0);
    for (int y = -1; y <= 1; y++) {
        for (int x = -1; x <= 1; x++) {
            vec2 other = cell + vec2(float(x), float(y));
            float d = distance(p, other + hash22(other));
            nearest = vec2(min(nearest.x, d), min(nearest.y, max(nearest.x, d)));
        }
    }
    return nearest;
}

// In space.
vec2 cellular(vec3 p) {
    vec3 cell = floor(p);
    vec2 nearest = vec2(1.0);
    for (int z = -1; z <= 1; z++) {
        for (int y = -1; y <= 1; y++) {
            for (int x = -1; x <= 1; x++) {
                vec3 other = cell + vec3(float(x), float(y), float(z));
                float d = distance(p, other + hash33(other));
                nearest = vec2(min(nearest.x, d), min(nearest.y, max(nearest.x, d)));
            }
        }
    }
    return nearest;
}
