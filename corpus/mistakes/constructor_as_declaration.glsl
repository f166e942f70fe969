void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = fragCoord / iResolution.xy;
    vec3 light(0.4, 0.8, 0.2);
    vec3 col = light * uv.x;
    fragColor = vec4(col, 1.0);
}
