#version 300 es
precision highp float;
uniform vec2 size;

void main(out vec4 color, in vec2 p) {
    color = vec4(p / size, 0.5, 1.0);
}
