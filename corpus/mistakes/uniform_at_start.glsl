float speed = 0.5 + iTime;

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    fragColor = vec4(vec3(fract(speed)), 1.0);
}
