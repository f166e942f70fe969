// Bricks with colours that are almost gray.
float hash(ivec2 p) {
    uint h = uint(p.x) * 1597334677u ^ uint(p.y) * 3812015801u;
    h = (h ^ (h >> 15u)) * 1103515245u;
    return float(h >> 8u) / 16777216.0;
}

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = fragCoord / iResolution.y * 8.0;
    uv.x += mod(floor(uv.y), 2.0) * 0.5;
    float brick = step(0.05, fract(uv.x)) * step(0.08, fract(uv.y));
    vec3 stone = mix(vec3(0.80, 0.79, 0.78), vec3(0.84, 0.83, 0.81), hash(ivec2(floor(uv))));
    fragColor = vec4(mix(vec3(0.60, 0.59, 0.58), stone, brick), 1.0);
}
