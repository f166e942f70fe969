// Displaces a position by noise, and wraps it to 0..1.
vec2 warped(vec2 p, ivec2 period, float by, uint seed) {
    vec2 near = vec2(noise(p, period, seed), noise(p, period, seed + 1u));
    vec2 fine = vec2(noise(p, period * 3, seed + 2u), noise(p, period * 3, seed + 3u));
    return fract(p + by * (0.7 * near + 0.3 * fine - 0.5));
}
