uniform vec4 unViewport; uniform vec3 unCorners[5];
void mainCubemap(out vec4 c, in vec2 f, in vec3 ro, in vec3 rd);
out vec4 outColor;
void main(void) {
    vec3 ro = unCorners[4]; vec2 uv = (gl_FragCoord.xy - unViewport.xy) / unViewport.zw;
    vec3 rd = normalize(mix(mix(unCorners[0], unCorners[1], uv.x), mix(unCorners[3], unCorners[2], uv.x), uv.y) - ro);
    vec4 color = vec4(0.0, 0.0, 0.0, 1.0); mainCubemap(color, gl_FragCoord.xy - unViewport.xy, ro, rd);
    outColor = color;
}
