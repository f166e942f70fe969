// Distance to the nearest of random points, one in each unit cell; at most 1.
// SPDX-License-Identifier: 0BSD

// In the plane.
float voronoi(vec2 p) {
    vec2 cell = floor(p);
    float nearest = 1.0;
    for (int y = -1; y <= 1; y++) {
        for (int x = -1; x <= 1; x++) {
            vec2 other = cell + vec2(float(x), float(y));
            nearest = min(nearest, distance(p, other + hash22(other)));
        }
    }
    return nearest;
}

// In space.
float voronoi(vec3 p) {
    vec3 cell = floor(p);
    float nearest = 1.0;
    for (int z = -1; z <= 1; z++) {
        for (int y = -1; y <= 1; y++) {
            for (int x = -1; x <= 1; x++) {
                vec3 other = cell + vec3(float(x), float(y), float(z));
                nearest = min(nearest, distance(p, other + hash33(other)));
            }
        }
    }
    return nearest;
}
