// Round stones as a height map.
vec4 texel(ivec2 p) {
    vec2 uv = (vec2(p) + 0.5) / vec2(size);
    vec3 large = cells(warped(uv, ivec2(12), 0.03, 3u), ivec2(14), 13u);
    vec3 small = cells(uv, ivec2(34), 23u);
    float gap = large.y - large.x;
    float stone = sqrt(clamp(1.9 * gap, 0.0, 1.0)) * (1.05 - 0.75 * large.x * large.x) * (0.5 + 0.4 * large.z);
    float grit = 0.34 * smoothstep(0.0, 0.5, small.y - small.x);
    float h = max(stone, grit) * (0.82 + 0.36 * fbm(uv, ivec2(40), 33u));
    return vec4(vec3(h), 1.0);
}
