float height(vec2 p) {
    float y = sin(p.x) * cos(p.y);
    if (y < 0) y = 0;
    return 2 * y;
}

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    fragColor = vec4(vec3(height(fragCoord * 0.05)), 1.0);
}
