// Moss: tufts of green over dark ground.
vec4 texel(ivec2 p) {
    vec2 uv = (vec2(p) + 0.5) / vec2(size);
    vec2 q = warped(uv, ivec2(8), 0.05, 3u);
    vec3 tuft = cells(q, ivec2(16), 13u);
    vec3 blade = cells(q, ivec2(70), 23u);
    float light = (1.0 - tuft.x) * (0.45 + 0.75 * (1.0 - blade.x));
    float dry = fbm(uv, ivec2(4), 33u);
    vec3 c = mix(vec3(0.10, 0.12, 0.06), vec3(0.52, 0.56, 0.28), light * 0.9);
    c = mix(c, vec3(0.58, 0.50, 0.34) * light, smoothstep(0.5, 0.7, dry));
    return vec4(c * (0.7 + 0.6 * fbm(uv, ivec2(40), 43u)), 1.0);
}
