// A time that is rounded away.
void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = fragCoord / iResolution.xy;
    float phase = floor(fract(iTime * 0.25));
    fragColor = vec4(0.5 + 0.5 * cos(phase + uv.xyx * 6.0 + vec3(0.0, 2.0, 4.0)), 1.0);
}
