#version 300 es
precision highp float;
uniform vec2 size;
out vec4 color;

void main() {
    color = vec4(gl_FragCord.xy / size, 0.5, 1.0);
}
