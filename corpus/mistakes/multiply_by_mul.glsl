mat2 turn(float a) {
    return mat2(cos(a), -sin(a), sin(a), cos(a));
}

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = mul(turn(iTime), fragCoord / iResolution.xy - 0.5);
    fragColor = vec4(step(0.0, uv), 0.0, 1.0);
}
