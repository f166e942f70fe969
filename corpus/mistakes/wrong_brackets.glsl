void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec3 color = vec3(0.2, 0.4, 0.8);
    float wave = sin[fragCoord.x * 0.1 + iTime];
    fragColor = vec4(vec3(color(0) + wave), 1.0);
}
