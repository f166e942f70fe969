float ground(vec3 p) {
    vec3 q = p.xz + vec3(0.0, iTime, 0.0);
    return p.y + 0.2 * sin(q.x);
}

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    fragColor = vec4(vec3(ground(vec3(fragCoord, 1.0))), 1.0);
}
