float circle(vec2 p, float r)
    return length(p) - r;
}

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = (2.0 * fragCoord - iResolution.xy) / iResolution.y;
    fragColor = vec4(vec3(step(circle(uv, 0.5), 0.0)), 1.0);
}
