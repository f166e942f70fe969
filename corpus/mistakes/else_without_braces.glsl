void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = fragCoord / iResolution.xy;
    vec3 col = vec3(0.0);
    if (uv.x < 0.5)
        col.r = 1.0;
        col.g = 0.5;
    else
        col.b = 1.0;
    fragColor = vec4(col, 1.0);
}
