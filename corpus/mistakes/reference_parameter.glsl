void rotate(vec2& p, float angle) {
    p *= mat2(cos(angle), sin(angle), -sin(angle), cos(angle));
}

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = fragCoord / iResolution.xy;
    vec2 p = uv - 0.5;
    rotate(p, iTime);
    vec3 col = vec3(p, 0.5);
    fragColor = vec4(col, 1.0);
}
