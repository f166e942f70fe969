// Streaks of gray and ochre, as on stone that water has run over.
vec4 texel(ivec2 p) {
    vec2 uv = (vec2(p) + 0.5) / vec2(size);
    vec2 q = warped(uv, ivec2(3), 0.25, 5u);
    float bands = fbm(q, ivec2(2, 9), 15u);
    float veins = abs(fbm(q, ivec2(5), 25u) - 0.5);
    float grain = fbm(uv, ivec2(48), 35u);
    vec3 c = mix(vec3(0.20, 0.19, 0.20), vec3(0.74, 0.68, 0.60), smoothstep(0.25, 0.75, bands));
    c = mix(c, vec3(0.55, 0.36, 0.20), 0.55 * smoothstep(0.5, 0.72, fbm(q, ivec2(4), 45u)));
    c *= (0.7 + 0.6 * grain) * (0.55 + 0.45 * smoothstep(0.0, 0.06, veins));
    return vec4(c, 1.0);
}
