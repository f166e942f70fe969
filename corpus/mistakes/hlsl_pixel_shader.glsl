float3 palette(float t) {
    return lerp(float3(0.1, 0.2, 0.5), float3(1.0, 0.8, 0.4), saturate(t));
}

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = fragCoord / iResolution.xy;
    fragColor = vec4(palette(frac(uv.x + iTime)), 1.0);
}
