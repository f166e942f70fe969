void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = fragCoord / iResolution.xy;
    float sum = 0.0;
    for (int i = 0, i < 5, i++) {
        sum += sin(uv.x * float(i) + iTime);
    }
    fragColor = vec4(vec3(sum * 0.2), 1.0);
}
