#version 300 es
precision highp float;
in int material;
out vec4 color;

void main() {
    color = vec4(float(material) / 8.0);
}
