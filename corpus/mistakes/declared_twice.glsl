void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = fragCoord / iResolution.xy;
    float d = length(uv - 0.5);
    float d = smoothstep(0.3, 0.31, d);
    fragColor = vec4(vec3(d), 1.0);
}
