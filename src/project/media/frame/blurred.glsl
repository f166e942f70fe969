// The average colour around a direction.
void main() {
    vec3 d = direction();
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
