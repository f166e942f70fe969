#version 300 es
precision highp float;

void main() {
    fragColor = vec4(1.0, 0.5, 0.0, 1.0);
}
