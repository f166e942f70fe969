#define AA 2

vec3 render(vec2 p) {
    return 0.5 + 0.5 * cos(iTime + p.xyx + vec3(0.0, 2.0, 4.0));
}

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec3 total = vec3(0.0);
#if AA > 1
    for (int y = 0; y < AA; y++)
    for (int x = 0; x < AA; x++)
        total += render((fragCoord + vec2(x, y) / float(AA)) / iResolution.xy);
    total /= float(AA * AA);
#else
    total = render(fragCoord / iResolution.xy);

    fragColor = vec4(total, 1.0);
}
