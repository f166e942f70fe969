void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = fragCoord / iResolution.xy;
    float wave = sin(uv.x * 6.0 + iTime};
    fragColor = vec4(vec3(wave), 1.0);
}
