// The nave of a great church: pillars, a vault of gold, light from high windows.
vec3 look(vec3 d) {
    float wall = 1.0 / max(abs(d.x), 1e-4);
    float end = 4.0 / max(abs(d.z), 1e-4);
    float level = (d.y > 0.0 ? 1.3 : 0.45) / max(abs(d.y), 1e-4);
    float t = min(min(wall, end), level);
    vec3 p = d * t;
    float far = smoothstep(0.5, 4.5, t);
    if (level <= t && d.y < 0.0) {
        vec2 q = fract(1.5 * p.xz) - 0.5;
        float ring = 1.0 - smoothstep(0.01, 0.03, abs(length(q) - 0.34));
        vec3 marble = mix(vec3(0.36, 0.27, 0.20), vec3(0.60, 0.52, 0.42), step(0.0, q.x * q.y));
        return mix(marble, vec3(0.42, 0.30, 0.20), ring) * (1.0 - 0.35 * far);
    }
    if (level <= t) {
        vec2 q = abs(fract(vec2(3.0, 2.5) * p.xz) - 0.5);
        float coffer = smoothstep(0.34, 0.40, max(q.x, q.y));
        float dome = 1.0 - smoothstep(0.6, 0.75, length(p.xz - vec2(0.0, -1.6)));
        vec3 gold = mix(vec3(0.26, 0.17, 0.09), vec3(0.66, 0.48, 0.24), coffer);
        return mix(gold, vec3(1.0, 0.95, 0.82), dome * smoothstep(0.05, 0.15, abs(fract(1.9 * atan(p.x, p.z + 1.6)) - 0.5)));
    }
    bool isSide = wall < end;
    float x = abs(fract((isSide ? 0.8 : 1.0) * (isSide ? p.z : p.x) + (isSide ? 0.0 : 0.5)) - 0.5);
    vec3 stone = mix(vec3(0.34, 0.25, 0.18), vec3(0.60, 0.48, 0.35), smoothstep(-0.45, 1.3, p.y));
    stone *= 0.85 + 0.15 * smoothstep(0.01, 0.03, abs(fract(24.0 * x) - 0.5));
    float arch = 1.0 - smoothstep(-0.02, 0.02, max(x - 0.27, length(vec2(x, max(0.0, p.y - 0.25))) - 0.27));
    float window = 1.0 - smoothstep(-0.02, 0.02, length(vec2(x, 0.8 * max(0.0, abs(p.y - 0.95) - 0.08))) - 0.12);
    float ledge = 1.0 - smoothstep(0.03, 0.05, abs(p.y - 0.66));
    vec3 c = mix(stone, vec3(0.10, 0.07, 0.05) + 0.10 * max(0.0, p.y + 0.3), arch);
    c = mix(c, vec3(0.74, 0.58, 0.36), 0.8 * ledge);
    c = mix(c, vec3(1.0, 0.96, 0.86), window);
    return c * (1.0 - 0.25 * far) + vec3(0.30, 0.24, 0.15) * exp(-8.0 * x * x) * max(0.0, p.y - 0.4);
}
