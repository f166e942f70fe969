// Six frames of 40 texels of a running cat, as in ShaderToy's sprite strip, without the
// background.
vec4 texel(ivec2 p) {
    int frame = p.x / 40;
    ivec2 q = ivec2(p.x % 40, p.y);
    if (frame > 5) return vec4(0.0);
    int hop = frame == 1 || frame == 2 ? 1 : 0;
    q.y -= hop;
    int leg = frame < 3 ? frame : 5 - frame;
    vec4 none = vec4(0.0);
    vec3 gray = vec3(0.6);
    vec3 black = vec3(0.0);
    vec4 c = none;
    // The tail, then the legs.
    int wag = frame % 3 - 1;
    if (q.x >= 4 && q.x < 11 && abs(q.y - 16 - wag * (11 - q.x) / 3) <= 2) c = vec4(q.x == 4 || abs(q.y - 16 - wag * (11 - q.x) / 3) == 2 ? black : gray, 1.0);
    for (int i = 0; i < 4; i++) {
        ivec2 d = q - ivec2(12 + leg + i * 5 + (i > 1 ? 3 : 0), 24);
        if (d.x >= 0 && d.x < 4 && d.y >= 0 && d.y < 4) c = vec4(d.x == 0 || d.x == 3 || d.y == 3 ? black : gray, 1.0);
    }
    // The body.
    ivec2 b = abs(2 * q - ivec2(39, 31)) / 2;
    if (b.x <= 10 && b.y <= 9 && b.x + b.y < 19) {
        bool isDot = (q.x * 7 + q.y * 5) % 17 < 2 && b.x < 7 && b.y < 6;
        vec3 inner = isDot ? vec3(1.0, 0.2, 0.6) : b.x < 8 && b.y < 7 ? vec3(1.0, 0.6, 1.0) : vec3(1.0, 0.8, 0.6);
        c = vec4(b.x == 10 || b.y == 9 || b.x + b.y == 18 ? black : inner, 1.0);
    }
    // The head, with ears, eyes and cheeks.
    ivec2 h = q - ivec2(29, 17);
    ivec2 a = abs(h);
    bool isEar = a.x > 3 && a.x < 8 && h.y < 0 && h.y >= -9 && h.y > -10 + abs(a.x - 6);
    if (a.x <= 8 && a.y <= 6 && a.x + a.y < 13 || isEar) {
        bool isEdge = a.x == 8 || a.y == 6 && !isEar || a.x + a.y == 12 && h.y > 0;
        c = vec4(isEdge ? black : gray, 1.0);
        if (a.x >= 3 && a.x <= 4 && h.y >= -1 && h.y <= 0) c.rgb = black;
        if (a.x >= 5 && a.x <= 6 && h.y >= 1 && h.y <= 2) c.rgb = vec3(1.0, 0.6, 0.6);
        if (h.y == 3 && a.x < 4 || h.y == 2 && (a.x == 0 || a.x == 3)) c.rgb = black;
    }
    return c;
}
