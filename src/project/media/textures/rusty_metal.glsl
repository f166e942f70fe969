// A plate of painted metal, rusting.
vec4 texel(ivec2 p) {
    vec2 uv = (vec2(p) + 0.5) / vec2(size);
    vec2 q = warped(uv, ivec2(4), 0.15, 3u);
    float rust = smoothstep(0.42, 0.62, fbm(q, ivec2(5), 13u));
    float run = fbm(uv, ivec2(40, 3), 23u);
    float grain = fbm(uv, ivec2(90), 33u);
    vec3 paint = mix(vec3(0.36, 0.39, 0.41), vec3(0.54, 0.56, 0.55), fbm(uv, ivec2(3, 20), 43u));
    paint *= mix(vec3(1.0), vec3(0.85, 0.7, 0.55), smoothstep(0.45, 0.7, run));
    vec3 red = mix(vec3(0.22, 0.13, 0.10), vec3(0.58, 0.36, 0.22), fbm(q, ivec2(18), 53u));
    vec3 c = mix(paint, red, rust) * (0.65 + 0.7 * grain);
    return vec4(c, 1.0);
}
