float fbm(vec2 p, int octaves) {
    if (octaves == 0) return 0.0;
    return sin(p.x) * cos(p.y) + 0.5 * fbm(p * 2.0, octaves - 1);
}

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    fragColor = vec4(vec3(fbm(fragCoord * 0.01, 5)), 1.0);
}
