// The ball is near.
const vec3 BALL = vec3(0.0, 0.0, 4.0);

float map(vec3 p) {
    return length(p - BALL) - 1.0;
}

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = (2.0 * fragCoord - iResolution.xy) / iResolution.y;
    vec3 direction = normalize(vec3(uv, 1.0));
    float t = 0.0;
    for (int i = 0; i < 80; i++) {
        float d = map(direction * t);
        if (d < 0.001) break;
        t += d;
        if (t > 100.0) break;
    }
    vec3 color = mix(vec3(0.2, 0.4, 0.8), vec3(0.8, 0.9, 1.0), 0.5 * uv.y + 0.5);
    if (t < 100.0) {
        vec3 normal = normalize(direction * t - BALL);
        vec3 sun = normalize(vec3(sin(iTime), 1.0, cos(iTime) - 1.5));
        color = vec3(1.0, 0.3, 0.2) * (0.3 + 0.7 * max(dot(normal, sun), 0.0));
    }
    fragColor = vec4(color, 1.0);
}
