float noise(vec2 p) {
    float n = fract(sin(dot(p, vec2(12.9898, 78.233))) * 43758.5453);
}

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    fragColor = vec4(vec3(noise(fragCoord)), 1.0);
}
