// The same lights, compressed to the displayable range.
void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = fragCoord / iResolution.xy;
    vec3 color = vec3(0.7, 0.6, 0.5) * (3.0 + uv.x) + 0.2 * sin(uv.y * 40.0 + iTime);
    fragColor = vec4(color / (1.0 + color), 1.0);
}
