void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = fragCoord / iResolution.xy;
    float k = if (uv.x > 0.5) 1.0 else 0.2;
    vec3 col = vec3(k);
    fragColor = vec4(col, 1.0);
}
