void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = fragCoord / iResolution.xy;
    float d = uv.x ** 2.0;
    vec3 col = vec3(d);
    fragColor = vec4(col, 1.0);
}
