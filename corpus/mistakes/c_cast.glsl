void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    float frames = (float)iFrame;
    fragColor = vec4(vec3(fract(frames / 60.0)), 1.0);
}
