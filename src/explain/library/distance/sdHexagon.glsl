// Signed distance to a regular hexagon, negative inside.
// SPDX-License-Identifier: 0BSD

// Around the origin, with flat sides at this distance above and below.
float sdHexagon(vec2 p, float radius) {
    vec2 mirror = vec2(-0.8660254, 0.5);
    vec2 q = abs(p);
    q -= 2.0 * min(dot(mirror, q), 0.0) * mirror;
    float above = q.y - radius;
    float beside = max(abs(q.x) - 0.5773503 * radius, 0.0);
    return above > 0.0 ? length(vec2(beside, above)) : above;
}
