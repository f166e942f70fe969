// An abstract image: slowly varying colours and fine grain.
vec4 texel(ivec2 p) {
    vec2 uv = (vec2(p) + 0.5) / vec2(size);
    vec2 q = warped(uv, ivec2(3), 0.3, 11u);
    float a = fbm(q, ivec2(3), 21u);
    float b = fbm(q, ivec2(2), 31u);
    vec3 c = 0.5 + 0.5 * cos(6.283 * (a + vec3(0.0, 0.12, 0.25) + 0.6 * b));
    c = mix(c, vec3(a), 0.35) * (0.45 + 0.4 * fbm(uv, ivec2(24), 41u));
    return vec4(c, 1.0);
}
