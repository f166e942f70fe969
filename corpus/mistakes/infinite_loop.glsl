float decay(float x) {
    while (true) {
        x *= 0.5;
    }
    return x;
}

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    fragColor = vec4(vec3(decay(fragCoord.x)), 1.0);
}
