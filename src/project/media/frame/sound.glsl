#version 300 es
precision highp float;
precision highp int;
uniform ivec2 size;
out vec4 color;
// The two channels of a sound loop, in -1..1.
vec2 wave(int n);
// Each texel is a sample: two bytes for the left and two for the right channel.
void main() {
    ivec2 p = ivec2(gl_FragCoord.xy);
    vec2 v = floor(clamp(0.5 + 0.5 * wave(p.y * size.x + p.x), 0.0, 1.0) * 65535.0);
    color = vec4(mod(v.x, 256.0), floor(v.x / 256.0), mod(v.y, 256.0), floor(v.y / 256.0)) / 255.0;
}
