// Slows the clock down.
void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = fragCoord / iResolution.xy;
    iTime *= 0.5;
    fragColor = vec4(uv, 0.5 + 0.5 * sin(iTime), 1.0);
}
