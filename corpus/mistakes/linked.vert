#version 300 es
in vec3 position;
uniform mat4 projection;
out vec2 vUv;

void main() {
    vUv = position.xy;
    gl_Position = projection * vec4(position, 1.0);
}
