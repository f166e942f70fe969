// Mountains 15 high, coloured as if they were 20 high.
float ridge(vec2 p) {
    return 7.5 + 7.5 * sin(p.x * 0.7) * cos(p.y * 0.9);
}

vec3 material(float height) {
    float ratio = height / 20.0;
    if (ratio < 0.35) return vec3(0.25, 0.55, 0.15);
    if (ratio < 0.8) return vec3(0.5, 0.45, 0.4);
    return vec3(0.95);
}

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = (2.0 * fragCoord - iResolution.xy) / iResolution.y;
    fragColor = vec4(material(ridge(uv * 6.0 + iTime)), 1.0);
}
