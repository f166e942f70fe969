// Stars of several colours in front of thin clouds.
vec4 texel(ivec2 p) {
    vec2 uv = (vec2(p) + 0.5) / vec2(size);
    float cloud = fbm(warped(uv, ivec2(3), 0.3, 3u), ivec2(3), 13u);
    vec3 c = vec3(0.03, 0.03, 0.06) + vec3(0.22, 0.16, 0.30) * smoothstep(0.4, 0.8, cloud);
    for (int layer = 0; layer < 3; layer++) {
        ivec2 period = ivec2(20 << layer);
        vec3 star = cells(uv, period, 23u + 10u * uint(layer));
        float bright = star.z * star.z / float(1 + layer);
        vec3 tint = mix(vec3(1.0, 0.75, 0.5), vec3(0.6, 0.8, 1.0), fract(star.z * 7.0));
        float r = star.x * (9.0 - 2.0 * float(layer));
        c += bright * tint * exp(-r * r * 1.6) + 0.15 * bright * tint * exp(-1.4 * r);
    }
    return vec4(c, 1.0);
}
