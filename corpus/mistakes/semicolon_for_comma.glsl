void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = fragCoord / iResolution.xy;
    float glow = clamp(0.1 / length(uv - 0.5); 0.0, 1.0);
    fragColor = vec4(vec3(glow), 1.0);
}
