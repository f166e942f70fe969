// Worn paint on plaster: gray-blue over brown.
vec4 texel(ivec2 p) {
    vec2 uv = (vec2(p) + 0.5) / vec2(size);
    vec2 q = warped(uv, ivec2(4), 0.12, 11u);
    float base = fbm(q, ivec2(4), 21u);
    float paint = smoothstep(0.44, 0.56, fbm(q, ivec2(6), 31u) + 0.25 * (base - 0.5));
    float grain = fbm(uv, ivec2(64), 41u);
    float stain = fbm(warped(uv, ivec2(3), 0.3, 61u), ivec2(2), 71u);
    vec3 below = mix(vec3(0.24, 0.16, 0.11), vec3(0.62, 0.47, 0.33), base);
    vec3 above = mix(vec3(0.38, 0.42, 0.44), vec3(0.72, 0.70, 0.64), stain);
    vec3 c = mix(below, above, paint) * (0.62 + 0.75 * grain);
    float edge = 1.0 - smoothstep(0.0, 0.4, abs(paint - 0.5));
    c *= 1.0 - 0.4 * edge * fbm(uv, ivec2(30), 81u);
    return vec4(c, 1.0);
}
