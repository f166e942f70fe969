// Rough earth-brown rock.
vec4 texel(ivec2 p) {
    vec2 uv = (vec2(p) + 0.5) / vec2(size);
    vec2 q = warped(uv, ivec2(6), 0.1, 3u);
    float relief = fbm(q, ivec2(7), 13u);
    float up = fbm(fract(q + vec2(0.003, 0.004)), ivec2(7), 13u);
    vec3 block = cells(q, ivec2(9), 23u);
    float crack = smoothstep(0.0, 0.09, block.y - block.x);
    float grain = fbm(uv, ivec2(80), 33u);
    vec3 c = mix(vec3(0.30, 0.24, 0.18), vec3(0.66, 0.58, 0.47), fbm(uv, ivec2(3), 43u) * 0.6 + 0.4 * relief);
    c *= (0.75 + 6.0 * (relief - up)) * (0.6 + 0.8 * grain) * mix(0.6, 1.0, crack);
    return vec4(c, 1.0);
}
