#define PI = 3.14159265

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = fragCoord / iResolution.xy;
    float a = sin(uv.x * 2.0 * PI);
    float b = cos(uv.y * 2.0 * PI);
    fragColor = vec4(a, b, 0.5, 1.0);
}
