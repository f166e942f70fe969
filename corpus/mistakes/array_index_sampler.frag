#version 300 es
precision highp float;
uniform sampler2D textures[4];
uniform int layer;
in vec2 uv;
out vec4 color;

void main() {
    color = texture(textures[layer], uv);
}
