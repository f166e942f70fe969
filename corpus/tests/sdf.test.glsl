const float EPS = 1e-5;

bool test_box_face() {
    return abs(sdBox(vec3(3.0, 0.0, 0.0), vec3(1.0)) - 2.0) < EPS;
}

bool test_box_corner() {
    float d = sdBox(vec3(2.0), vec3(1.0));
    return abs(d - sqrt(3.0)) < EPS;
}

// At every pixel: a distance grows no faster than the way.
bool test_union_is_a_bound() {
    vec3 p = vec3(gl_FragCoord.xy / 200.0, 1.0);
    vec3 q = p + vec3(0.01, -0.02, 0.005);
    float a = smoothUnion(sdSphere(p, 1.0), sdBox(p - 2.0, vec3(0.5)), 0.4);
    float b = smoothUnion(sdSphere(q, 1.0), sdBox(q - 2.0, vec3(0.5)), 0.4);
    return abs(a - b) <= length(p - q) + EPS;
}
