precision mediump float;
uniform int count;
varying vec2 uv;

void main() {
    float sum = 0.0;
    for (int i = 0; i < count; i++) {
        sum += sin(uv.x * float(i));
    }
    gl_FragColor = vec4(vec3(sum), 1.0);
}
