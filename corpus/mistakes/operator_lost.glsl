void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = fragCoord / iResolution.xy;
    float r = 2.0(uv.x + uv.y);
    vec3 col = vec3(r);
    fragColor = vec4(col, 1.0);
}
