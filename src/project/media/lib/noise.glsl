// Value noise with smooth interpolation between cell corners; `p` in 0..1.
float noise(vec2 p, ivec2 period, uint seed) {
    vec2 q = p * vec2(period);
    ivec2 i = ivec2(floor(q));
    vec2 f = q - vec2(i);
    f = f * f * (3.0 - 2.0 * f);
    i = wrapped(i, period);
    ivec2 j = wrapped(i + 1, period);
    return mix(mix(random(i, seed), random(ivec2(j.x, i.y), seed), f.x),
        mix(random(ivec2(i.x, j.y), seed), random(j, seed), f.x), f.y);
}
