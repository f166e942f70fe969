void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = fragCoord / iResolution.xy;
    float weights[3] = float[3](0.2, 0.5, 0.3);
    float sum = 0.0;
    for (float w : weights) {
        sum += w * uv.x;
    }
    vec3 col = vec3(sum);
    fragColor = vec4(col, 1.0);
}
