void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = fragCoord / iResolution.xy;
    float light = uv.x;
    if (light > 0.5) then
        light = 0.5;
    end
    fragColor = vec4(vec3(light), 1.0);
}
