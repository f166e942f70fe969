float cast(vec3 origin, vec3 direction) {
    float t = 0.0;
    for (int i = 0; i < 64; i++) {
        float d = length(origin + t * direction) - 1.0;
        if (d < 0.001) return t;
        t += d;
    }
    return -1.0;
}

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = (2.0 * fragCoord - iResolution.xy) / iResolution.y;
    float t = cast(vec3(0.0, 0.0, -3.0), normalize(vec3(uv, 2.0)));
    fragColor = vec4(vec3(t < 0.0 ? 0.0 : 1.0 - 0.2 * t), 1.0);
}
