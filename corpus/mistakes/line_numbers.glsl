12: float wave(float x) {
13:     return sin(x * 6.0);
14: }

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = fragCoord / iResolution.xy;
    vec3 col = vec3(uv, 0.5);
    fragColor = vec4(col, 1.0);
}
