// Patterns that repeat after `period` cells in both directions.
float random(ivec2 p, uint seed) {
    return float(hash(p, seed) >> 8u) / 16777216.0;
}
ivec2 wrapped(ivec2 p, ivec2 period) {
    return ivec2(p.x < 0 ? p.x + period.x : p.x >= period.x ? p.x - period.x : p.x,
        p.y < 0 ? p.y + period.y : p.y >= period.y ? p.y - period.y : p.y);
}
