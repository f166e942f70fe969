void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = fragCoord / iResolution.xy;
    float wave = smothstep(0.4, 0.6, sin(uv.x * 10.0 + itime));
    fragColor = vec4(vec3(wave), 1.0);
}
