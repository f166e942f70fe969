// Leaves on the ground.
vec4 texel(ivec2 p) {
    vec2 uv = (vec2(p) + 0.5) / vec2(size);
    vec2 q = warped(uv, ivec2(10), 0.05, 3u);
    vec3 leaf = cells(q, ivec2(13), 13u);
    vec3 lower = cells(q, ivec2(22), 23u);
    float edge = smoothstep(0.0, 0.18, leaf.y - leaf.x);
    float vein = smoothstep(0.02, 0.08, abs(fract(7.0 * leaf.x + 3.0 * leaf.z) - 0.5));
    vec3 c = mix(vec3(0.32, 0.22, 0.14), vec3(0.62, 0.48, 0.30), leaf.z);
    c = mix(c, vec3(0.40, 0.41, 0.22), step(0.78, leaf.z)) * mix(0.8, 1.0, vein) * (1.1 - 0.5 * leaf.x);
    c = mix(vec3(0.14, 0.10, 0.07) * (1.3 - lower.x), c, edge);
    return vec4(c * (0.6 + 0.8 * fbm(uv, ivec2(48), 33u)), 1.0);
}
