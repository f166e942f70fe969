void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = fragCoord / iResolution.xy;
    int key = 'w';
    vec3 col = vec3(texelFetch(iChannel0, ivec2(key, 0), 0).x);
    fragColor = vec4(col, 1.0);
}
