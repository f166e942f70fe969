void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    float sum = 0.0;
    for (int i in 0..4) {
        sum += sin(float(i) + iTime);
    }
    fragColor = vec4(vec3(sum * 0.25), 1.0);
}
