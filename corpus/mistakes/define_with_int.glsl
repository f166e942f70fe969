#define TAU (2 * 3.14159265)

mat2 rotate(float turns) {
    float c = cos(turns * TAU), s = sin(turns * TAU);
    return mat2(c, -s, s, c);
}

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = rotate(iTime * 0.1) * (fragCoord / iResolution.xy - 0.5);
    fragColor = vec4(step(0.0, uv.x) * vec3(1.0, 0.5, 0.2), 1.0);
}
