float stripes(vec2 uv) {
    float s = 0.0;
    for (int i = 0; i < 4; i++) {
        s += step(0.5, fract(uv.x * float(i + 1)));
        }
    }
    return s / 4.0;
}

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    fragColor = vec4(vec3(stripes(fragCoord / iResolution.xy)), 1.0);
}
