#version 300 es
precision highp float; out vec4 color; uniform float x;
float g = 2.0;
float half_of(float a) {
    if (a > 3.0) return a * 0.5;
    g += 1.0;
    return a + x;
}
void main() {
    float p = gl_FragCoord.x;
    float sum = 0.0, old = sum;
    for (int i = 0; i < 3; i++) {
        if (i == 1 && p < 1.0) continue;
        float d = half_of(p + float(i));
        sum += d; old = sum;
    }
    vec2 v = vec2(sum, g);
    v.yx = v;
    color = vec4(v, old, half_of(sum) + half_of(p));
}