float box(vec2 p, vec2 b) {
    vec2 d = abs(p) - b;
    retrun length(max(d, 0.0)) + min(max(d.x, d.y), 0.0);
}

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = fragCoord / iResolution.xy - 0.5;
    fragColor = vec4(vec3(step(box(uv, vec2(0.2)), 0.0)), 1.0);
}
