#version 300 es
uniform float time;
out vec4 color;

void main() {
    color = vec4(fract(time), 0.0, 0.0, 1.0);
}
