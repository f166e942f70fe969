#version 300 es
precision highp float;
uniform Light {
    vec3 direction;
    vec3 tint;
};
in vec3 normal;
out vec4 color;

void main() {
    color = vec4(light.tint * dot(normal, light.direction), 1.0);
}
