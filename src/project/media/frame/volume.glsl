#version 300 es
precision highp float;
precision highp int;
uniform int layer;
out vec4 color;
vec4 texel(ivec3 p);
void main() {
    color = texel(ivec3(gl_FragCoord.xy, layer));
}
