void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = fragCoord / iResolution.xy;
    <<<<<<< HEAD
    vec3 col = vec3(uv, 0.0);
    =======
    vec3 col = vec3(uv, 1.0);
    >>>>>>> feature/blue
    fragColor = vec4(col, 1.0);
}
