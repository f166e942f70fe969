#version 300 es
precision highp float;
uniform vec2 size;

vec4 main(vec2 p) {
    return vec4(p / size, 0.5, 1.0);
}
