// Boards of reddish wood, side by side.
vec4 texel(ivec2 p) {
    vec2 uv = (vec2(p) + 0.5) / vec2(size);
    float boards = uv.x * 4.0;
    int board = int(boards);
    float f = fract(boards);
    float shift = random(ivec2(board, 0), 3u);
    vec2 q = fract(vec2(uv.x, uv.y + shift));
    float bend = fbm(q, ivec2(3, 2), 13u + uint(board));
    float rings = fract(7.0 * bend + 2.0 * f);
    float ring = smoothstep(0.0, 0.75, rings) * (1.0 - smoothstep(0.85, 1.0, rings));
    float fiber = fbm(q, ivec2(120, 6), 23u);
    vec3 c = mix(vec3(0.33, 0.17, 0.09), vec3(0.66, 0.42, 0.25), 0.35 + 0.5 * ring * fiber + 0.35 * (shift - 0.5));
    c *= 0.6 + 0.75 * fiber;
    float joint = smoothstep(0.0, 0.02, min(f, 1.0 - f));
    return vec4(c * mix(0.25, 1.0, joint), 1.0);
}
