// A street: sky, houses with windows, a pavement, and a red bus.
float box(vec2 p, vec2 low, vec2 high) {
    vec2 d = max(low - p, p - high);
    return 1.0 - smoothstep(-0.002, 0.002, max(d.x, d.y));
}
vec4 texel(ivec2 p) {
    vec2 uv = (vec2(p.x, size.y - 1 - p.y) + 0.5) / vec2(size);
    float grain = fbm(uv, ivec2(90), 3u);
    float cloud = smoothstep(0.45, 0.75, fbm(uv, ivec2(3, 6), 13u));
    vec3 c = mix(mix(vec3(0.80, 0.84, 0.88), vec3(0.52, 0.63, 0.78), uv.y), vec3(0.92), cloud);
    for (int row = 0; row < 2; row++) {
        float x = uv.x * (row == 0 ? 9.0 : 6.0);
        ivec2 house = ivec2(int(x), row);
        float f = fract(x);
        float top = (row == 0 ? 0.62 : 0.46) + 0.26 * random(house, 23u);
        float gable = random(house, 33u) > 0.5 ? 0.07 * (1.0 - abs(2.0 * f - 1.0)) : 0.0;
        if (uv.y > top + gable) continue;
        vec3 wall = mix(vec3(0.47, 0.30, 0.23), vec3(0.74, 0.68, 0.58), random(house, 43u));
        wall = mix(wall, vec3(0.62, 0.66, 0.72), row == 0 ? 0.45 : 0.0) * (0.7 + 0.6 * grain);
        vec2 w = fract(vec2(f * 4.0, uv.y * 22.0)) - 0.5;
        float glass = box(w, vec2(-0.26, -0.34), vec2(0.26, 0.3)) * step(uv.y, top - 0.02) * step(0.2, uv.y);
        float lit = random(ivec2(int(x * 4.0), int(uv.y * 22.0)), 53u);
        wall = mix(wall, mix(vec3(0.13, 0.16, 0.20), vec3(0.85, 0.74, 0.48), step(0.85, lit)), glass);
        c = mix(wall, vec3(0.22, 0.20, 0.21), step(top, uv.y)) * mix(0.7, 1.0, smoothstep(0.0, 0.05, min(f, 1.0 - f)));
    }
    if (uv.y < 0.17) c = mix(vec3(0.30, 0.30, 0.32), vec3(0.52, 0.51, 0.50), step(0.12, uv.y)) * (0.6 + 0.8 * grain);
    if (uv.y < 0.12) c += 0.35 * box(vec2(fract(uv.x * 8.0), uv.y), vec2(0.2, 0.045), vec2(0.7, 0.055));
    vec2 b = uv - vec2(0.30, 0.08);
    c = mix(c, vec3(0.72, 0.09, 0.09) * (0.8 + 0.4 * grain), box(b, vec2(0.0, 0.02), vec2(0.40, 0.26)));
    vec2 g = vec2(fract(b.x * 14.0) - 0.5, b.y);
    float panes = box(g, vec2(-0.4, 0.18), vec2(0.4, 0.235)) + box(g, vec2(-0.4, 0.08), vec2(0.4, 0.14));
    c = mix(c, vec3(0.16, 0.19, 0.23), panes * box(b, vec2(0.015, 0.0), vec2(0.385, 0.3)));
    float wheel = min(distance(b, vec2(0.08, 0.02)), distance(b, vec2(0.32, 0.02)));
    c = mix(c, vec3(0.06), 1.0 - smoothstep(0.03, 0.034, wheel));
    return vec4(mix(c, vec3(0.5), 1.0 - smoothstep(0.01, 0.014, wheel)), 1.0);
}
