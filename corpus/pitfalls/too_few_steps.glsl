// A march that ends before it reaches the sphere.
float map(vec3 p) {
    return length(p) - 1.0;
}

vec3 normal(vec3 p) {
    vec2 e = vec2(0.001, 0.0);
    return normalize(vec3(
        map(p + e.xyy) - map(p - e.xyy),
        map(p + e.yxy) - map(p - e.yxy),
        map(p + e.yyx) - map(p - e.yyx)));
}

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = (2.0 * fragCoord - iResolution.xy) / iResolution.y;
    vec3 origin = vec3(sin(iTime), 0.0, -3.0);
    vec3 direction = normalize(vec3(uv, 1.5));
    float t = 0.0;
    float d = 1.0;
    for (int i = 0; i < 12; i++) {
        d = map(origin + direction * t);
        if (d < 0.001 || t > 20.0) break;
        t += 0.4 * d;
    }
    vec3 color = mix(vec3(0.5, 0.7, 1.0), vec3(0.2, 0.4, 0.8), uv.y);
    if (d < 0.001) {
        vec3 n = normal(origin + direction * t);
        float sun = max(0.0, dot(n, normalize(vec3(1.0, 2.0, -1.0))));
        color = vec3(0.9, 0.5, 0.2) * (0.2 + sun);
    }
    fragColor = vec4(color, 1.0);
}
