// A long court between two palaces, open to the sky.
vec3 look(vec3 d) {
    vec3 sky = mix(vec3(0.92, 0.94, 0.97), vec3(0.45, 0.62, 0.88), max(d.y, 0.0));
    sky += vec3(0.9, 0.8, 0.6) * pow(max(0.0, dot(d, vec3(0.28, 0.85, 0.45))), 24.0);
    float wall = 1.0 / max(abs(d.x), 1e-4);
    float end = 5.0 / max(abs(d.z), 1e-4);
    float t = min(wall, end);
    vec3 p = d * t;
    if (p.y > 1.5) return sky;
    float floorAt = -0.42 / min(d.y, -1e-4);
    if (floorAt < t) {
        vec2 q = d.xz * floorAt;
        vec2 joint = smoothstep(0.0, 0.06, abs(fract(vec2(4.0, 2.0) * q) - 0.5));
        float shade = 0.55 + 0.45 * (1.0 - smoothstep(0.2, 1.0, abs(q.x - 0.15)));
        return vec3(0.55, 0.52, 0.48) * (0.75 + 0.25 * joint.x * joint.y) * shade;
    }
    bool isSide = wall < end;
    float along = isSide ? p.z : p.x;
    float bay = abs(fract(1.6 * along) - 0.5);
    vec3 stone = mix(vec3(0.58, 0.52, 0.42), vec3(0.80, 0.75, 0.64), 0.5 + 0.33 * p.y);
    if (isSide && d.x < 0.0) stone *= 0.62;
    float arch = 1.0 - smoothstep(-0.02, 0.02, max(bay - 0.3, p.y - 0.18 + 1.2 * max(0.0, bay - 0.1)));
    float window = 1.0 - smoothstep(-0.015, 0.015, max(bay - 0.16, abs(p.y - 0.62) - 0.17));
    float small = 1.0 - smoothstep(-0.015, 0.015, max(bay - 0.12, abs(p.y - 1.12) - 0.11));
    stone *= 1.0 - 0.35 * (1.0 - smoothstep(0.005, 0.015, min(min(abs(p.y - 0.3), abs(p.y - 0.92)), abs(p.y - 1.4))));
    vec3 c = mix(stone, vec3(0.13, 0.11, 0.10), arch);
    c = mix(c, vec3(0.20, 0.22, 0.26), max(window, small));
    return mix(c, vec3(0.82, 0.85, 0.88), 0.12 * smoothstep(1.0, 5.0, t));
}
