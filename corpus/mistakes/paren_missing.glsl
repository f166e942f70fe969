void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = fragCoord / iResolution.xy;
    vec3 n = normalize(vec3(uv - 0.5, 1.0);
    fragColor = vec4(vec3(max(dot(n, vec3(0.0, 0.0, 1.0)), 0.0)), 1.0);
}
