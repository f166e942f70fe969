// Moving hills of light behind a ball and a moving bar.
vec4 texel(ivec2 p) {
    vec2 uv = (vec2(p) + 0.5) / vec2(size);
    vec2 q = (2.0 * uv - 1.0) * vec2(1.3, 1.0);
    float a = sin(3.0 * q.x + time) + sin(2.5 * q.y - 1.3 * time) + sin(2.0 * (q.x + q.y) + 0.7 * time);
    vec3 c = 0.5 + 0.4 * cos(1.6 * a + vec3(0.0, 1.2, 2.4) + 0.5 * time);
    c *= 0.75 + 0.25 * smoothstep(0.0, 0.4, abs(sin(8.0 * (q.y + 0.1 * a))));
    vec2 at = vec2(0.9 * sin(0.9 * time), 0.75 - 1.2 * abs(sin(1.7 * time)));
    vec2 d = (q - at) / 0.28;
    float r = dot(d, d);
    vec3 n = vec3(d, sqrt(max(0.0, 1.0 - r)));
    float light = 0.25 + 0.75 * max(0.0, dot(n, vec3(-0.48, -0.6, 0.64)));
    c *= mix(0.5, 1.0, smoothstep(0.0, 0.4, distance(q, at + vec2(0.08, 0.12)) - 0.15));
    c = mix(c, vec3(0.95, 0.92, 0.85) * light, 1.0 - smoothstep(0.94, 1.0, r));
    c = mix(c, vec3(1.0), 0.8 * step(uv.x, fract(time / 10.0)) * step(0.97, uv.y));
    return vec4(c, 1.0);
}
