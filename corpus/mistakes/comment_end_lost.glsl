/* Distance to the disc
float disc(vec2 p) {
    return length(p - 0.5) - 0.3;
}

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = fragCoord / iResolution.xy;
    vec3 col = vec3(disc(uv));
    fragColor = vec4(col, 1.0);
}
