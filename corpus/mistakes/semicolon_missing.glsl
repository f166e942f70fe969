void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = fragCoord / iResolution.xy
    float d = length(uv - 0.5);
    fragColor = vec4(vec3(step(d, 0.25)), 1.0);
}
