// Sums octaves of noise up to the resolution of the texture.
float fbm(vec2 p, ivec2 period, uint seed) {
    float sum = 0.0;
    float weight = 0.5;
    for (int i = 0; i < 6; i++) {
        if (2 * max(period.x, period.y) > size.x) break;
        sum += weight * noise(p, period, seed + uint(i));
        period *= 2;
        weight *= 0.5;
    }
    return sum + weight;
}
