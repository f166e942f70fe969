// Letters as strokes. A stroke is a curve of three points, encoded as digits: 0x29263f goes from
// (2, 9) via (2, 6) to (3, 15); if the first two points are equal, it is a straight line. The
// baseline is row 4; lower-case letters reach up to row 11, capitals to row 15.
const uint STROKES[378] = uint[](
    // !
    0x6f6f68u, 0x646464u,
    // "
    0x5f5f5cu, 0x7f7f7cu,
    // #
    0x45455eu, 0x75758eu, 0x2b2babu, 0x2828a8u,
    // $
    0x9c9e6eu, 0x6e3e3cu, 0x3c3a6au, 0x6a9a97u, 0x979565u, 0x653537u, 0x6f6f64u,
    // %
    0xafaf24u, 0x4f2f2du, 0x2d2b4bu, 0x4b6b6du, 0x6d6f4fu, 0x886866u, 0x666484u, 0x84a4a6u, 0xa6a888u,
    // &
    0xa4a44bu, 0x4b3c3du, 0x3d3f5fu, 0x5f7f7du, 0x7d7b4au, 0x4a2a27u, 0x272454u, 0x5484a9u,
    // '
    0x6f6f6cu,
    // (
    0x8f5c58u, 0x585481u,
    // )
    0x4f7c78u, 0x787441u,
    // *
    0x6f6f69u, 0x3d3d9bu, 0x9d9d3bu,
    // +
    0x66666cu, 0x393999u,
    // ,
    0x646452u,
    // -
    0x383898u,
    // .
    0x646464u,
    // /
    0xafaf23u,
    // 0
    0x3b3f6fu, 0x6f9f9bu, 0x9b9b98u, 0x989464u, 0x643438u, 0x38383bu, 0x58587bu,
    // 1
    0x3d3d6fu, 0x6f6f64u, 0x343494u,
    // 2
    0x3c3f6fu, 0x6f9f9cu, 0x9c9934u, 0x343494u,
    // 3
    0x3d4f6fu, 0x6f9f9cu, 0x9c9a6au, 0x5a5a6au, 0x6a9a97u, 0x979464u, 0x644436u,
    // 4
    0x84848fu, 0x8f8f27u, 0x2727a7u,
    // 5
    0x9f9f4fu, 0x4f4f3au, 0x3a5b6bu, 0x6b9b98u, 0x989464u, 0x644436u,
    // 6
    0x9d8f6fu, 0x6f3f3au, 0x3a3a37u, 0x373464u, 0x649497u, 0x979a6au, 0x6a3a37u,
    // 7
    0x3f3f9fu, 0x9f9f54u,
    // 8
    0x6f3f3cu, 0x3c3a6au, 0x6a9a9cu, 0x9c9f6fu, 0x6a2a27u, 0x272464u, 0x64a4a7u, 0xa7aa6au,
    // 9
    0x364464u, 0x649499u, 0x99999cu, 0x9c9f6fu, 0x6f3f3cu, 0x3c3969u, 0x69999cu,
    // :
    0x6a6a6au, 0x646464u,
    // ;
    0x6a6a6au, 0x646452u,
    // <
    0x9c9c38u, 0x383894u,
    // =
    0x3a3a9au, 0x373797u,
    // >
    0x3c3c98u, 0x989834u,
    // ?
    0x3c3f6fu, 0x6f9f9cu, 0x9c9a69u, 0x696967u, 0x646464u,
    // @
    0x6b4b49u, 0x494666u, 0x668689u, 0x898b6bu, 0x8b8b88u, 0x888696u, 0x96b6b9u, 0xb9b9bbu, 0xbbbf6fu, 0x6f1f1au, 0x1a1a18u, 0x181363u, 0x636383u,
    // A
    0x24246fu, 0x6f6fa4u, 0x383898u,
    // B
    0x24242fu, 0x2f2f6fu, 0x6f9f9cu, 0x9c9a6au, 0x2a2a6au, 0x6aaaa7u, 0xa7a464u, 0x646424u,
    // C
    0xacaf6fu, 0x6f2f2bu, 0x2b2b28u, 0x282464u, 0x64a4a7u,
    // D
    0x24242fu, 0x2f2f5fu, 0x5fafabu, 0xababa8u, 0xa8a454u, 0x545424u,
    // E
    0x9f9f2fu, 0x2f2f24u, 0x242494u, 0x2a2a8au,
    // F
    0x9f9f2fu, 0x2f2f24u, 0x292989u,
    // G
    0xacaf6fu, 0x6f2f2bu, 0x2b2b28u, 0x282464u, 0x64a4a7u, 0xa7a7a9u, 0xa9a979u,
    // H
    0x2f2f24u, 0xafafa4u, 0x2a2aaau,
    // I
    0x6f6f64u, 0x4f4f8fu, 0x444484u,
    // J
    0x9f9f98u, 0x989464u, 0x643437u,
    // K
    0x2f2f24u, 0x9f9f28u, 0x5b5ba4u,
    // L
    0x2f2f24u, 0x242494u,
    // M
    0x14141fu, 0x1f1f69u, 0x6969bfu, 0xbfbfb4u,
    // N
    0x24242fu, 0x2f2fa4u, 0xa4a4afu,
    // O
    0x2b2f6fu, 0x6fafabu, 0xababa8u, 0xa8a464u, 0x642428u, 0x28282bu,
    // P
    0x24242fu, 0x2f2f6fu, 0x6fafacu, 0xaca969u, 0x696929u,
    // Q
    0x2b2f6fu, 0x6fafabu, 0xababa8u, 0xa8a464u, 0x642428u, 0x28282bu, 0x7777b3u,
    // R
    0x24242fu, 0x2f2f6fu, 0x6fafacu, 0xaca969u, 0x696929u, 0x6969a4u,
    // S
    0xad9f6fu, 0x6f2f2cu, 0x2c2a6au, 0x6aaaa7u, 0xa7a464u, 0x643426u,
    // T
    0x1f1fbfu, 0x6f6f64u,
    // U
    0x2f2f28u, 0x282464u, 0x64a4a8u, 0xa8a8afu,
    // V
    0x2f2f64u, 0x6464afu,
    // W
    0x1f1f34u, 0x34346du, 0x6d6d94u, 0x9494bfu,
    // X
    0x2f2fa4u, 0xafaf24u,
    // Y
    0x2f2f6au, 0xafaf6au, 0x6a6a64u,
    // Z
    0x2f2fafu, 0xafaf24u, 0x2424a4u,
    // [
    0x8f8f5fu, 0x5f5f51u, 0x515181u,
    // backslash
    0x2f2fa3u,
    // ]
    0x4f4f7fu, 0x7f7f71u, 0x717141u,
    // ^
    0x3b3b6fu, 0x6f6f9bu,
    // _
    0x1212b2u,
    // `
    0x5f5f7du,
    // a
    0x3a4b6bu, 0x6b9b98u, 0x989894u, 0x989868u, 0x683836u, 0x363454u, 0x548497u,
    // b
    0x3f3f34u, 0x383b6bu, 0x6b9b98u, 0x989897u, 0x979464u, 0x643437u,
    // c
    0x9a8b6bu, 0x6b3b38u, 0x383837u, 0x373464u, 0x648495u,
    // d
    0x9f9f94u, 0x989b6bu, 0x6b3b38u, 0x383837u, 0x373464u, 0x649497u,
    // e
    0x383898u, 0x989b6bu, 0x6b3b38u, 0x383837u, 0x373464u, 0x648495u,
    // f
    0x9f9f8fu, 0x8f6f6cu, 0x6c6c64u, 0x4b4b8bu,
    // g
    0x9b9b93u, 0x939161u, 0x614132u, 0x989b6bu, 0x6b3b38u, 0x383837u, 0x373464u, 0x649497u,
    // h
    0x3f3f34u, 0x383b6bu, 0x6b9b98u, 0x989894u,
    // i
    0x6b6b64u, 0x6e6e6eu,
    // j
    0x7b7b73u, 0x737151u, 0x515141u, 0x7e7e7eu,
    // k
    0x3f3f34u, 0x8b8b37u, 0x595994u,
    // l
    0x5f5f57u, 0x575474u, 0x747484u,
    // m
    0x1b1b14u, 0x181b4bu, 0x4b6b69u, 0x696964u, 0x696b9bu, 0x9bbbb9u, 0xb9b9b4u,
    // n
    0x3b3b34u, 0x383b6bu, 0x6b9b98u, 0x989894u,
    // o
    0x383b6bu, 0x6b9b98u, 0x989897u, 0x979464u, 0x643437u, 0x373738u,
    // p
    0x3b3b31u, 0x383b6bu, 0x6b9b98u, 0x989897u, 0x979464u, 0x643437u,
    // q
    0x9b9b91u, 0x989b6bu, 0x6b3b38u, 0x383837u, 0x373464u, 0x649497u,
    // r
    0x4b4b44u, 0x484b8bu,
    // s
    0x9a8b6bu, 0x6b3b39u, 0x393868u, 0x689896u, 0x969464u, 0x644435u,
    // t
    0x5e5e57u, 0x575474u, 0x747484u, 0x3b3b8bu,
    // u
    0x3b3b37u, 0x373464u, 0x649497u, 0x9b9b94u,
    // v
    0x3b3b64u, 0x64649bu,
    // w
    0x1b1b34u, 0x34346au, 0x6a6a94u, 0x9494bbu,
    // x
    0x3b3b94u, 0x9b9b34u,
    // y
    0x3b3b64u, 0x9b9b51u, 0x515131u,
    // z
    0x3b3b9bu, 0x9b9b34u, 0x343494u,
    // {
    0x8f6f6cu, 0x6c6c6au, 0x6a6848u, 0x486866u, 0x666664u, 0x646181u,
    // |
    0x6f6f61u,
    // }
    0x4f6f6cu, 0x6c6c6au, 0x6a6888u, 0x886866u, 0x666664u, 0x646141u,
    // ~
    0x384b69u, 0x69879au
);
// Index of the first stroke of each character, starting with the exclamation mark.
const int FIRST[95] = int[](
    0, 2, 4, 8, 15, 24, 32, 33, 35, 37, 40, 42, 43, 44, 45, 46,
    53, 56, 60, 67, 70, 76, 83, 85, 93, 100, 102, 104, 106, 108, 110, 115,
    128, 131, 139, 144, 150, 154, 157, 164, 167, 170, 173, 176, 178, 182, 185, 191,
    196, 203, 209, 215, 217, 221, 223, 227, 229, 232, 235, 238, 239, 242, 244, 245,
    246, 253, 259, 264, 270, 276, 280, 288, 292, 294, 298, 301, 304, 311, 315, 321,
    327, 333, 335, 341, 345, 349, 351, 355, 357, 360, 363, 369, 370, 376, 378
);
const float WEIGHT = 0.037;
vec2 place(uint digits) {
    return vec2(float(digits >> 4u & 15u) - 6.0, float(digits & 15u) - 8.0) * vec2(0.04, 0.045);
}
// The vector from the nearest point of a line to a position.
vec2 fromLine(vec2 p, vec2 a, vec2 b) {
    vec2 ab = b - a;
    return p - a - ab * clamp(dot(p - a, ab) / max(dot(ab, ab), 1e-6), 0.0, 1.0);
}
vec2 fromStroke(vec2 p, uint stroke) {
    vec2 a = place(stroke >> 16u);
    vec2 b = place(stroke >> 8u);
    vec2 c = place(stroke);
    if ((stroke >> 16u & 255u) == (stroke >> 8u & 255u)) return fromLine(p, a, c);
    vec2 best = vec2(1.0);
    vec2 last = a;
    for (int i = 1; i <= 6; i++) {
        float t = float(i) / 6.0;
        vec2 next = mix(mix(a, b, t), mix(b, c, t), t);
        vec2 away = fromLine(p, last, next);
        if (dot(away, away) < dot(best, best)) best = away;
        last = next;
    }
    return best;
}
// 16 by 16 cells, by character code. Red is the coverage, alpha the signed distance to the edge in
// cells plus 0.5, green and blue the direction to it.
vec4 texel(ivec2 p) {
    int side = size.x / 16;
    int glyph = p.x / side + p.y / side * 16 - 33;
    vec2 q = (vec2(p.x % side, p.y % side) + 0.5) / float(side) - 0.5;
    vec2 best = vec2(1.0);
    if (glyph >= 0 && glyph < FIRST.length() - 1) {
        for (int i = FIRST[glyph]; i < FIRST[glyph + 1]; i++) {
            vec2 away = fromStroke(vec2(q.x, -q.y), STROKES[i]);
            if (dot(away, away) < dot(best, best)) best = away;
        }
    }
    float d = length(best) - WEIGHT;
    vec2 way = best / max(length(best), 1e-4) * 0.5 + 0.5;
    return vec4(clamp(0.5 - d * float(side), 0.0, 1.0), way, clamp(d + 127.0 / 255.0, 0.0, 1.0));
}
