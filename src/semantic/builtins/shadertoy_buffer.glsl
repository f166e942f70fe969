void mainImage(out vec4 c, in vec2 f);
out vec4 outColor;
void main(void) {
    vec4 color = vec4(0.0, 0.0, 0.0, 1.0); mainImage(color, gl_FragCoord.xy);
    outColor = color;
}
