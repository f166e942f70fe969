#version 3.00 es
precision highp float;
in vec2 uv;
out vec4 color;

void main() {
    color = vec4(uv, 0.5, 1.0);
}
