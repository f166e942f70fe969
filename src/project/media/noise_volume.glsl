vec4 texel(ivec3 p) {
    uint n = hash(p.xy, 3u + uint(p.z));
    return vec4(n & 255u, n >> 8u & 255u, n >> 16u & 255u, n >> 24u) / 255.0;
}
