#version 300 es
precision highp float;
in vec2 uv;

void main() {
    gl_FragColour = vec4(uv, 0.5, 1.0);
}
