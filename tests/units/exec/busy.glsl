float map(vec3 p) { return length(p) - 1.0 + 0.1 * sin(8.0 * p.x); }
float march(vec3 o, vec3 d) {
    float t = 0.0;
    for (int i = 0; i < 40; i++) { float h = map(o + d * t); if (h < 0.001) return t; t += h; if (t > 9.0) break; }
    return -1.0;
}
void main() {
    vec2 uv = gl_FragCoord.xy / 20.0 - 1.0;
    float t = march(vec3(0, 0, -3), normalize(vec3(uv, 1.5)));
    vec3 c = vec3(0.1, 0.2, 0.3) * (1.0 + fwidth(t));
    if (t > 0.0) { vec3 p = vec3(uv, t); c = fract(p * 3.7) + (mod(float(n), 2.0) > 0.5 ? 0.1 : 0.0); }
    color = vec4(c, t);
}
