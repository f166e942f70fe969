void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = fragCoord / iResolution.xy;
    # brighten the middle
    vec3 col = vec3(1.0 - length(uv - 0.5));
    fragColor = vec4(col, 1.0);
}
