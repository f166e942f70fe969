void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = fragCoord / iResolution.xy;
    float light = 1.0;
    if (not (uv.x > 0.5)) {
        light = 0.5;
    }
    fragColor = vec4(vec3(light), 1.0);
}
