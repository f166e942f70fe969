// Each value of white noise is replaced by its rank among its neighbours, so nearby values differ.
vec4 texel(ivec2 p) {
    uint own = hash(p, 7u);
    uvec4 here = uvec4(own, own >> 8u, own >> 16u, own >> 24u) & 255u;
    ivec4 rank = ivec4(0);
    int count = 0;
    for (int y = -3; y <= 3; y++) {
        for (int x = -3; x <= 3; x++) {
            int near = 12 - x * x - y * y;
            if (near < 0 || near == 12) continue;
            uint n = hash(p + ivec2(x, y) & size - 1, 7u);
            uvec4 there = uvec4(n, n >> 8u, n >> 16u, n >> 24u) & 255u;
            rank += near * (ivec4(lessThan(there, here)) * 2 + ivec4(equal(there, here)));
            count += 2 * near;
        }
    }
    return (vec4(rank) + vec4(here) / 256.0) / float(count);
}
