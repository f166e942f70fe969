void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    float light = fragCoord.x / iResolution.x;
    If (light > 0.9) {
        light = 0.9;
    }
    for (int i = 0; i < 8; i++) {
        if (light < 0.1) braek;
        light *= 0.9;
    }
    fragColor = vec4(vec3(light), 1.0);
}
