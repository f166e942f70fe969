void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = fragCoord / iResolution.xy;
    float scale = 1.5.0;
    vec3 col = vec3(uv * scale, 0.5);
    fragColor = vec4(col, 1.0);
}
