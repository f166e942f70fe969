#define STEPS 64;
#define FAR 20.0

float march(vec3 ro, vec3 rd) {
    float t = 0.0;
    for (int i = 0; i < STEPS; i++) {
        float d = length(mod(ro + t * rd, 4.0) - 2.0) - 0.5;
        if (d < 0.001 || t > FAR) break;
        t += d;
    }
    return t;
}

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = (2.0 * fragCoord - iResolution.xy) / iResolution.y;
    float t = march(vec3(0.0, 0.0, iTime), normalize(vec3(uv, 1.5)));
    fragColor = vec4(vec3(1.0 - t / FAR), 1.0);
}
