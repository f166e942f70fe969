#version 300 es
precision highp float;
precision highp int;
uniform ivec2 size;
uniform int layer;
uniform bool flip;
out vec4 color;
// The colour in a direction; y is up.
vec3 look(vec3 d);
// The direction of the current texel. The faces are those of OpenGL: +x, -x, +y, -y, +z, -z.
vec3 direction() {
    vec2 p = 2.0 * gl_FragCoord.xy / vec2(size) - 1.0;
    float side = (layer & 1) == 0 ? 1.0 : -1.0;
    vec3 d = vec3(side, -p.y, -side * p.x);
    if (layer > 3) d = vec3(side * p.x, -p.y, side);
    else if (layer > 1) d = vec3(p.x, side, side * p.y);
    if (flip) d.y = -d.y;
    return normalize(d);
}
