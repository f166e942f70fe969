void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = fragCoord / iResolution.xy;
    vec3 col = mix(#ff8800, vec3(0.0), uv.y);
    fragColor = vec4(col, 1.0);
}
