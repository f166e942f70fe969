// A time that is not rounded.
void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = fragCoord / iResolution.xy;
    float phase = fract(iTime * 0.25) * 6.2832;
    fragColor = vec4(0.5 + 0.5 * cos(phase + uv.xyx * 6.0 + vec3(0.0, 2.0, 4.0)), 1.0);
}
