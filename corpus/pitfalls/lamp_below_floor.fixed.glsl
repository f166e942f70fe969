// The lamp hangs above the floor.
const vec3 LAMP = vec3(-3.0, 6.0, -4.0);

float map(vec3 p) {
    return min(length(p) - 1.0, p.y + 1.0);
}

vec3 normalAt(vec3 p) {
    const vec2 e = vec2(1.0, -1.0) * 0.0005;
    return normalize(e.xyy * map(p + e.xyy) + e.yyx * map(p + e.yyx)
        + e.yxy * map(p + e.yxy) + e.xxx * map(p + e.xxx));
}

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = (2.0 * fragCoord - iResolution.xy) / iResolution.y;
    vec3 origin = vec3(0.3 * sin(iTime), 0.6, -4.0);
    vec3 direction = normalize(vec3(uv.x, uv.y - 0.2, 1.6));
    float t = 0.0;
    for (int i = 0; i < 90; i++) {
        float d = map(origin + direction * t);
        if (d < 0.001 || t > 30.0) break;
        t += d;
    }
    vec3 color = vec3(0.0);
    if (t < 30.0) {
        vec3 p = origin + direction * t;
        color = vec3(0.9, 0.6, 0.3) * max(dot(normalAt(p), normalize(LAMP - p)), 0.0);
    }
    fragColor = vec4(sqrt(color), 1.0);
}
