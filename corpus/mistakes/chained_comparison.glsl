void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = fragCoord / iResolution.xy;
    float inside = 0.0;
    if (0.25 < uv.x < 0.75) inside = 1.0;
    fragColor = vec4(vec3(inside), 1.0);
}
