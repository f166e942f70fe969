// A blue sky with a sun and a few clouds over level ground.
vec3 look(vec3 d) {
    vec3 sun = vec3(0.55, 0.45, -0.70);
    float s = max(0.0, dot(d, sun));
    vec3 c = mix(vec3(0.78, 0.86, 0.94), vec3(0.20, 0.42, 0.78), pow(max(d.y, 0.0), 0.6));
    vec2 q = 4.0 * d.xz / (abs(d.y) + 0.12);
    float cloud = sin(q.x + 1.7 * sin(0.6 * q.y)) + sin(1.3 * q.y + 1.4 * sin(0.8 * q.x)) + 0.5 * sin(2.7 * q.x + 1.9 * q.y);
    c = mix(c, vec3(0.97), smoothstep(0.4, 2.2, cloud) * smoothstep(0.0, 0.25, d.y));
    c += vec3(1.0, 0.85, 0.6) * (0.35 * pow(s, 12.0) + smoothstep(0.9985, 0.9993, s));
    vec3 ground = mix(vec3(0.42, 0.40, 0.34), vec3(0.62, 0.62, 0.60), exp(4.0 * min(d.y, 0.0)));
    return mix(ground, c, smoothstep(-0.012, 0.012, d.y));
}
