// Uses only integers, so the values are the same on every device.
uint mixed(uint n) {
    n = (n ^ (n >> 16u)) * 0x7feb352du;
    n = (n ^ (n >> 15u)) * 0x846ca68bu;
    return n ^ (n >> 16u);
}
uint hash(ivec2 p, uint seed) {
    return mixed(uint(p.x) + mixed(uint(p.y) + mixed(seed)));
}
