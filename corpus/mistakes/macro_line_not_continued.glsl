#define REPEAT(p, size) \
    p = mod(p + size * 0.5, size)
    - size * 0.5;

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = fragCoord / iResolution.y;
    REPEAT(uv, 0.25)
    fragColor = vec4(vec3(step(length(uv), 0.1)), 1.0);
}
