// Signed distance to a hexagonal prism, negative inside.
// SPDX-License-Identifier: 0BSD

// Along the z axis: `size.x` is the distance of its sides, `size.y` half its length.
float sdHexPrism(vec3 p, vec2 size) {
    vec2 mirror = vec2(-0.8660254, 0.5);
    vec2 q = abs(p.xy);
    q -= 2.0 * min(dot(mirror, q), 0.0) * mirror;
    float above = q.y - size.x;
    float beside = max(abs(q.x) - 0.5773503 * size.x, 0.0);
    float side = above > 0.0 ? length(vec2(beside, above)) : above;
    vec2 d = vec2(side, abs(p.z) - size.y);
    return length(max(d, 0.0)) + min(max(d.x, d.y), 0.0);
}
