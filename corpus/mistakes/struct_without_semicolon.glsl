struct Ray {
    vec3 origin;
    vec3 direction;
}

Ray camera(vec2 uv) {
    return Ray(vec3(0.0, 0.0, -3.0), normalize(vec3(uv, 2.0)));
}

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    Ray ray = camera(fragCoord / iResolution.xy - 0.5);
    fragColor = vec4(ray.direction, 1.0);
}
