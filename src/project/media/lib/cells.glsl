// Cellular noise: distance to the nearest and to the second nearest point, and an id of the
// nearest.
vec3 cells(vec2 p, ivec2 period, uint seed) {
    vec2 q = p * vec2(period);
    ivec2 i = ivec2(floor(q));
    vec3 best = vec3(9.0, 9.0, 0.0);
    for (int y = -1; y <= 1; y++) {
        for (int x = -1; x <= 1; x++) {
            ivec2 c = i + ivec2(x, y);
            ivec2 w = wrapped(c, period);
            vec2 at = vec2(random(w, seed), random(w, seed + 1u));
            float d = distance(q, vec2(c) + 0.1 + 0.8 * at);
            if (d < best.x) best = vec3(d, best.x, random(w, seed + 2u));
            else if (d < best.y) best.y = d;
        }
    }
    return best;
}
