#version 300 es
precision highp float;
in vec3 vUv;
out vec4 color;

void main() {
    color = vec4(vUv, 1.0);
}
