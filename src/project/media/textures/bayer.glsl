// The matrix for ordered dithering: the interleaved bits of x xor y and of y, in reverse order.
vec4 texel(ivec2 p) {
    int n = 0;
    for (int bit = 0; bit < 3; bit++) {
        int x = p.x >> bit & 1;
        int y = p.y >> bit & 1;
        n = n << 2 | (x ^ y) << 1 | y;
    }
    return vec4(float(n) * 4.0 / 255.0);
}
