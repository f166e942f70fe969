#version 300 es
in vec3 position;
layout(location = 1) uniform mat4 view;

void main() {
    gl_Position = view * vec4(position, 1.0);
}
