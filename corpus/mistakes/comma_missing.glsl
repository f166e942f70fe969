void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = fragCoord / iResolution.xy;
    vec3 sky = mix(vec3(0.8, 0.9, 1.0) vec3(0.2, 0.4, 0.8), uv.y);
    fragColor = vec4(sky, 1.0);
}
