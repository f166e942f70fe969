float ring(vec2 p) {
    returnabs(length(p) - 0.3);
}

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = fragCoord / iResolution.xy;
    vec3 col = vec3(ring(uv - 0.5));
    fragColor = vec4(col, 1.0);
}
