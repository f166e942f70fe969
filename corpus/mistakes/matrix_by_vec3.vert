#version 300 es
uniform mat4 modelViewProjection;
in vec3 position;

void main() {
    gl_Position = modelViewProjection * position;
}
