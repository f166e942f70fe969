float disc(vec2 p, float r) {
    return length(p - 0.5) - r;
}

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = fragCoord / iResolution.xy;
    vec3 col = vec3(disc(vec2 uv, float 0.3));
    fragColor = vec4(col, 1.0);
}
