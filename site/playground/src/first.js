/** What a visitor sees first: an image, and a warning about it. */
export const FIRST = `// Errors and warnings appear as you type: write 8 for 8.0.
float wave(vec2 p) {
    return 0.5 + 0.5 * sin(p.x * 8.0 + iTime) * cos(p.y * 8.0);
}

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = (2.0 * fragCoord - iResolution.xy) / iResolution.y;
    float height = wave(uv) - 0.5 * length(uv);
    vec3 color = mix(vec3(0.05, 0.2, 0.4), vec3(1.0, 0.8, 0.5), sqrt(height));
    fragColor = vec4(color, 1.0);
}
`;
