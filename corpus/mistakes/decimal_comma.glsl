void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    float speed = 1,5;
    fragColor = vec4(vec3(fract(iTime * speed)), 1.0);
}
