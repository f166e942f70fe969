#version 300 es
precision highp float;
layout(std430, binding = 0) buffer Particles {
    vec4 first;
} particles;
out vec4 color;

void main() {
    color = particles.first;
}
