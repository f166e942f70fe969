// White noise. Green is red, and alpha is blue, shifted by 37 texels and 17 rows, as in ShaderToy's own
// files: shaders use this for three-dimensional noise with one lookup.
vec4 texel(ivec2 p) {
    uint here = hash(p, uint(size.x));
    uint there = hash((p - ivec2(37, 17)) & (size - 1), uint(size.x));
    return vec4(here & 255u, there & 255u, here >> 8u & 255u, there >> 8u & 255u) / 255.0;
}
