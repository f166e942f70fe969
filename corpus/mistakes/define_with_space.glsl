#define SQUARE (x) ((x) * (x))

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = fragCoord / iResolution.xy - 0.5;
    float d = SQUARE(uv.x) + SQUARE(uv.y);
    fragColor = vec4(vec3(step(d, 0.1)), 1.0);
}
