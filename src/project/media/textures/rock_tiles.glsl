// A wall of cut stones in rows.
vec4 texel(ivec2 p) {
    vec2 uv = (vec2(p) + 0.5) / vec2(size);
    vec2 q = warped(uv, ivec2(9), 0.018, 3u) * vec2(5.0, 8.0);
    int row = int(q.y);
    q.x += 0.5 * float(row & 1) + 0.3 * random(ivec2(row, 0), 7u);
    ivec2 stone = ivec2(int(floor(q.x)) % 5, row);
    vec2 f = min(fract(q), 1.0 - fract(q)) * vec2(1.6, 1.0);
    float joint = smoothstep(0.03, 0.16, min(f.x, f.y) + 0.1 * (fbm(uv, ivec2(20), 13u) - 0.5));
    float relief = fbm(uv, ivec2(16), 23u);
    float up = fbm(fract(uv + vec2(0.004)), ivec2(16), 23u);
    vec3 c = mix(vec3(0.38, 0.33, 0.28), vec3(0.66, 0.59, 0.50), random(stone, 33u));
    c *= (0.85 + 5.0 * (relief - up)) * (0.65 + 0.7 * fbm(uv, ivec2(64), 43u));
    return vec4(mix(vec3(0.15, 0.13, 0.11), c, joint), 1.0);
}
