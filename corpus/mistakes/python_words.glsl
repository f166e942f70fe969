float shape(vec2 p) {
    if (p.x < 0.0 and p.y < 0.0) {
        return 0.0;
    } elif (p.x < 0.0) {
        return 0.5;
    }
    return 1.0;
}

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    fragColor = vec4(vec3(shape(fragCoord - 0.5 * iResolution.xy)), 1.0);
}
