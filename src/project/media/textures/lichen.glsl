// Bark with spots of lichen.
vec4 texel(ivec2 p) {
    vec2 uv = (vec2(p) + 0.5) / vec2(size);
    vec2 q = warped(uv, ivec2(5), 0.06, 3u);
    float ridge = 1.0 - 2.0 * abs(fbm(q, ivec2(14, 4), 13u) - 0.5);
    float grain = fbm(uv, ivec2(72), 23u);
    vec3 c = mix(vec3(0.17, 0.13, 0.10), vec3(0.50, 0.42, 0.34), ridge * ridge) * (0.5 + grain);
    vec3 cell = cells(warped(uv, ivec2(9), 0.05, 33u), ivec2(11), 43u);
    float spot = (1.0 - smoothstep(0.3, 0.42, cell.x + 0.35 * (fbm(uv, ivec2(24), 53u) - 0.5))) * step(0.35, cell.z);
    float rim = 0.8 + 0.4 * smoothstep(0.1, 0.35, cell.x);
    vec3 growth = mix(vec3(0.50, 0.53, 0.42), vec3(0.66, 0.62, 0.36), step(0.75, cell.z));
    c = mix(c, growth * rim * (0.6 + 0.8 * grain), 0.85 * spot);
    return vec4(c, 1.0);
}
