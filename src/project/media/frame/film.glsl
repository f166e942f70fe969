#version 300 es
precision highp float;
precision highp int;
uniform ivec2 size;
uniform bool flip;
uniform float time;
out vec4 color;
// A texel of the video; rows are counted from the top.
vec4 texel(ivec2 p);
void main() {
    ivec2 p = ivec2(gl_FragCoord.xy);
    color = texel(flip ? ivec2(p.x, size.y - 1 - p.y) : p);
}
