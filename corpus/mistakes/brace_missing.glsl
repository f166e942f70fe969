float sphere(vec3 p, float r) {
    return length(p) - r;
}

float scene(vec3 p) {
    float d = sphere(p, 1.0);
    if (p.y < 0.0) {
        d = min(d, p.y + 1.0);
    return d;
}

vec3 normal(vec3 p) {
    vec2 e = vec2(0.001, 0.0);
    return normalize(vec3(scene(p + e.xyy), scene(p + e.yxy), scene(p + e.yyx)) - scene(p));
}

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    fragColor = vec4(normal(vec3(fragCoord / iResolution.xy, 1.0)), 1.0);
}
