// Reddish-brown bark: long plates with deep cracks.
vec4 texel(ivec2 p) {
    vec2 uv = (vec2(p) + 0.5) / vec2(size);
    vec2 q = warped(uv, ivec2(4, 3), 0.09, 3u);
    vec3 plate = cells(q, ivec2(13, 5), 13u);
    float deep = smoothstep(0.03, 0.32, plate.y - plate.x);
    float layers = fbm(q, ivec2(10, 30), 23u);
    float grain = fbm(uv, ivec2(90, 60), 33u);
    vec3 c = mix(vec3(0.36, 0.22, 0.15), vec3(0.68, 0.50, 0.38), layers * 0.7 + 0.3 * plate.z);
    c = mix(vec3(0.10, 0.06, 0.05), c, deep) * (0.6 + 0.8 * grain);
    return vec4(c, 1.0);
}
