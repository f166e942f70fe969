// Brown woven cloth.
vec4 texel(ivec2 p) {
    vec2 uv = (vec2(p) + 0.5) / vec2(size);
    vec2 bend = 0.006 * (vec2(fbm(uv, ivec2(5), 3u), fbm(uv, ivec2(5), 7u)) - 0.5);
    vec2 q = fract(uv + bend) * 32.0;
    ivec2 i = ivec2(q);
    vec2 f = fract(q) - 0.5;
    bool isWarp = (i.x + i.y & 1) == 0;
    float across = isWarp ? f.x : f.y;
    float along = isWarp ? f.y : f.x;
    float height = sqrt(max(0.0, 1.0 - 4.2 * across * across)) * (0.72 + 0.28 * cos(3.1 * along));
    float fiber = noise(uv, isWarp ? ivec2(256, 48) : ivec2(48, 256), 9u);
    float tint = random(isWarp ? ivec2(i.x, 0) : ivec2(0, i.y), 5u);
    vec3 c = mix(vec3(0.30, 0.19, 0.11), vec3(0.62, 0.45, 0.28), tint * 0.5 + 0.5 * fbm(uv, ivec2(3), 17u));
    return vec4(c * height * (0.7 + 0.6 * fiber) + 0.03, 1.0);
}
