float hash(vec2 p) {
    return fract(dot(p, vec2(0.3, 0.7)) * 43.0);
}

float hash(vec2 p) {
    return fract(dot(p, vec2(0.3, 0.7)) * 43.0);
}

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = fragCoord / iResolution.xy;
    vec3 col = vec3(hash(uv));
    fragColor = vec4(col, 1.0);
}
