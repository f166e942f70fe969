float ring(vec2 p) -> float {
    return abs(length(p) - 0.5);
}

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = (2.0 * fragCoord - iResolution.xy) / iResolution.y;
    fragColor = vec4(vec3(ring(uv)), 1.0);
}
