// Gamma correction of a value that cannot be negative.
void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = (2.0 * fragCoord - iResolution.xy) / iResolution.y;
    vec3 color = vec3(0.6, 0.4, 0.2) * (0.5 + sin(uv.x * 5.0 + iTime));
    fragColor = vec4(pow(max(color, 0.0), vec3(0.4545)), 1.0);
}
