void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = fragCoord / iResolution.xy;
    float a = 45°;
    vec3 col = vec3(sin(a) * uv, 0.5);
    fragColor = vec4(col, 1.0);
}
