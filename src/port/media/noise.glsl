// White noise. Green is red, and alpha is blue, moved by 37 texels and 17 rows, as in the site's own
// files: shaders take three-dimensional noise from it with one lookup.
vec4 texel(ivec2 p) {
    uint here = hash(p, uint(size.x));
    uint there = hash((p - ivec2(37, 17)) & (size - 1), uint(size.x));
    return vec4(here & 255u, there & 255u, here >> 8u & 255u, there >> 8u & 255u) / 255.0;
}
