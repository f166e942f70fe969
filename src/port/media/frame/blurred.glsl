#version 300 es
precision highp float;
precision highp int;
uniform ivec2 size;
uniform int layer;
uniform bool flip;
out vec4 color;
// What is seen in a direction; y is up.
vec3 look(vec3 d);
// The mean of what is seen around a direction, on the faces of OpenGL: +x, -x, +y, -y, +z, -z.
void main() {
    vec2 p = 2.0 * gl_FragCoord.xy / vec2(size) - 1.0;
    float side = (layer & 1) == 0 ? 1.0 : -1.0;
    vec3 d = vec3(side, -p.y, -side * p.x);
    if (layer > 3) d = vec3(side * p.x, -p.y, side);
    else if (layer > 1) d = vec3(p.x, side, side * p.y);
    if (flip) d.y = -d.y;
    d = normalize(d);
    vec3 u = normalize(cross(d, abs(d.y) < 0.9 ? vec3(0, 1, 0) : vec3(1, 0, 0)));
    vec3 v = cross(d, u);
    vec4 sum = vec4(0.0);
    for (int i = 0; i < 240; i++) {
        float r = 0.7 * sqrt((float(i) + 0.5) / 240.0);
        float turn = 2.399963 * float(i);
        vec3 way = normalize(d + r * (cos(turn) * u + sin(turn) * v));
        sum += vec4(look(way), 1.0) * exp(-5.0 * r * r);
    }
    color = vec4(sum.rgb / sum.a, 1.0);
}
