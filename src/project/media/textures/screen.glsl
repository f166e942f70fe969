// A terminal with some lines of text, four letters in a number.
#undef texel
const uint LINES[132] = uint[](
    // $ ls shaders
    0x736c2024u, 0x61687320u, 0x73726564u, 0x20202020u, 0x20202020u, 0x20202020u, 0x20202020u, 0x20202020u, 0x20202020u, 0x20202020u, 0x20202020u,
    // clouds.glsl  ocean.glsl  terrain.glsl
    0x756f6c63u, 0x672e7364u, 0x206c736cu, 0x65636f20u, 0x672e6e61u, 0x206c736cu, 0x72657420u, 0x6e696172u, 0x736c672eu, 0x2020206cu, 0x20202020u,
    // plasma.frag  rings.frag  tunnel.frag
    0x73616c70u, 0x662e616du, 0x20676172u, 0x6e697220u, 0x662e7367u, 0x20676172u, 0x6e757420u, 0x2e6c656eu, 0x67617266u, 0x20202020u, 0x20202020u,
    // $ head -4 shaders/rings.frag
    0x65682024u, 0x2d206461u, 0x68732034u, 0x72656461u, 0x69722f73u, 0x2e73676eu, 0x67617266u, 0x20202020u, 0x20202020u, 0x20202020u, 0x20202020u,
    // void main() {
    0x64696f76u, 0x69616d20u, 0x2029286eu, 0x2020207bu, 0x20202020u, 0x20202020u, 0x20202020u, 0x20202020u, 0x20202020u, 0x20202020u, 0x20202020u,
    // float d = length(place);
    0x20202020u, 0x616f6c66u, 0x20642074u, 0x656c203du, 0x6874676eu, 0x616c7028u, 0x3b296563u, 0x20202020u, 0x20202020u, 0x20202020u, 0x20202020u,
    // color = vec4(0.5 + 0.5 * sin(20.0 * d));
    0x20202020u, 0x6f6c6f63u, 0x203d2072u, 0x34636576u, 0x352e3028u, 0x30202b20u, 0x2a20352eu, 0x6e697320u, 0x2e303228u, 0x202a2030u, 0x3b292964u,
    // }
    0x2020207du, 0x20202020u, 0x20202020u, 0x20202020u, 0x20202020u, 0x20202020u, 0x20202020u, 0x20202020u, 0x20202020u, 0x20202020u, 0x20202020u,
    // $ make test
    0x616d2024u, 0x7420656bu, 0x20747365u, 0x20202020u, 0x20202020u, 0x20202020u, 0x20202020u, 0x20202020u, 0x20202020u, 0x20202020u, 0x20202020u,
    // compiling 42 shaders ... done in 0.7 s
    0x706d6f63u, 0x6e696c69u, 0x32342067u, 0x61687320u, 0x73726564u, 0x2e2e2e20u, 0x6e6f6420u, 0x6e692065u, 0x372e3020u, 0x20207320u, 0x20202020u,
    // 42 passed, 0 failed
    0x70203234u, 0x65737361u, 0x30202c64u, 0x69616620u, 0x2064656cu, 0x20202020u, 0x20202020u, 0x20202020u, 0x20202020u, 0x20202020u, 0x20202020u,
    // $
    0x20202024u, 0x20202020u, 0x20202020u, 0x20202020u, 0x20202020u, 0x20202020u, 0x20202020u, 0x20202020u, 0x20202020u, 0x20202020u, 0x20202020u
);
vec4 texel(ivec2 p) {
    ivec2 cell = ivec2(size.x / 48, size.y / 16);
    ivec2 at = p / cell - ivec2(2, 2);
    vec3 paper = vec3(0.07, 0.09, 0.13) + 0.03 * vec3(p.yyx) / vec3(size.yyx);
    if (at.x < 0 || at.y < 0 || at.x >= 44 || at.y >= 12) return vec4(paper, 1.0);
    uint letter = LINES[at.y * 11 + at.x / 4] >> 8 * (at.x % 4) & 255u;
    // A glyph of the font texture is twice as wide as its letter.
    int side = size.x / 16;
    ivec2 inside = ivec2((vec2(p % cell) + 0.5) / vec2(cell) * vec2(0.5, 1.0) * float(side));
    ivec2 corner = ivec2(int(letter) % 16, int(letter) / 16) * side;
    float ink = letter == 32u ? 0.0 : glyph(corner + inside + ivec2(side / 4, 0)).x;
    vec3 pen = letter == 36u ? vec3(0.45, 0.9, 0.55) : vec3(0.8, 0.84, 0.88);
    return vec4(mix(paper, pen, ink), 1.0);
}
