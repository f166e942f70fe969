void boost(float *value) {
    *value = 1.5 * *value + 0.1;
}

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = fragCoord / iResolution.xy;
    float level = uv.x;
    boost(&level);
    vec3 col = vec3(level);
    fragColor = vec4(col, 1.0);
}
