float box(vec3 p, vec3 size, float radius) {
    vec3 q = abs(p) - size;
    return length(max(q, 0.0)) - radius;
}

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec3 p = vec3(fragCoord / iResolution.xy, 0.0);
    float d = box(p, 0.25, 0.1);
    fragColor = vec4(vec3(d), 1.0);
}
