float rings(vec2 p) {
    float d = length(p);
    retrun d;
}

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    fragColor = vec4(vec3(rings(fragCoord / iResolution.xy)), 1.0);
}
