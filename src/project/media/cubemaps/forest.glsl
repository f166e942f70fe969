// Trunks all around, leaves above with the sky between them, ferns below.
float number(int i, uint seed) {
    return float(hash(ivec2(i, 0), seed) & 65535u) / 65536.0;
}
float leaves(vec2 q) {
    float sum = 0.0;
    float weight = 0.5;
    for (int i = 0; i < 4; i++) {
        sum += weight * abs(sin(q.x + 1.3 * sin(0.7 * q.y)) + sin(q.y + 1.1 * sin(0.9 * q.x)));
        q = mat2(1.6, -1.2, 1.2, 1.6) * q + 3.0;
        weight *= 0.6;
    }
    return sum;
}
vec3 look(vec3 d) {
    float turn = atan(d.x, d.z) / 6.2831853 + 0.5;
    float rise = d.y / max(length(d.xz), 1e-4);
    vec2 above = 3.0 * d.xz / (abs(d.y) + 0.35);
    float gap = smoothstep(0.55, 1.15, leaves(above * 2.0)) * smoothstep(-0.1, 0.5, d.y);
    vec3 sun = vec3(1.0, 0.95, 0.75) * pow(max(0.0, dot(d, vec3(0.36, 0.80, 0.48))), 16.0);
    vec3 c = mix(vec3(0.10, 0.16, 0.06), vec3(0.30, 0.40, 0.14), smoothstep(0.2, 1.2, leaves(above * 3.0 + 5.0)));
    c = mix(c, vec3(0.80, 0.88, 0.82) + sun, gap);
    c = mix(vec3(0.42, 0.50, 0.36), c, smoothstep(0.02, 0.45, abs(rise)));
    for (int row = 0; row < 3; row++) {
        int count = 40 - 12 * row;
        float x = turn * float(count);
        int i = int(x);
        float width = (0.10 + 0.16 * number(i, 3u + uint(row))) * (1.0 - 0.25 * clamp(rise, -1.0, 1.5));
        float at = fract(x) - 0.3 - 0.4 * number(i, 13u + uint(row)) - 0.05 * sin(3.0 * rise + float(i));
        float trunk = (1.0 - smoothstep(-0.02, 0.02, abs(at) - width)) * (1.0 - smoothstep(1.2, 2.4, rise));
        float light = 0.6 + 0.5 * at / width + 0.2 * sin(40.0 * at / width + 9.0 * rise);
        vec3 bark = mix(vec3(0.34, 0.40, 0.30), vec3(0.30, 0.22, 0.15), 0.5 * float(row)) * max(0.3, light);
        c = mix(c, bark, trunk);
    }
    vec3 ground = mix(vec3(0.16, 0.17, 0.07), vec3(0.36, 0.34, 0.17), 0.7 * leaves(above * 9.0));
    float edge = -0.22 - 0.05 * sin(37.0 * turn * 6.2831853) * number(int(turn * 64.0), 5u);
    return mix(ground, c, smoothstep(edge - 0.06, edge + 0.02, rise));
}
