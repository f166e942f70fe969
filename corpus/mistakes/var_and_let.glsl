void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    var uv = fragCoord / iResolution.xy;
    let radius = 0.25;
    fragColor = vec4(vec3(step(length(uv - 0.5), radius)), 1.0);
}
