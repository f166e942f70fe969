// Known distances.

// each: p = vec3(3, 0, 0), vec3(0, -3, 0), vec3(1, 2, 2)
// each: radius = 0.5, 1, 2.5
bool test_sphere(vec3 p, float radius) {
    return approx(sphere(p, radius), 3.0 - radius);
}

bool test_torus_center() {
    return approx(torus(vec3(0.0), 2.0, 0.5), 1.5);
}

// A capsule without length is a sphere.
// any: p in vec3(-4)..vec3(4); radius in 0..2
bool test_short_capsule(vec3 p, float radius) {
    vec3 at = vec3(1.0, -2.0, 0.5);
    return approx(capsule(p, at, at, radius), sphere(p - at, radius));
}

// any: along in 0..1; radius in 0..2
bool test_capsule_is_straight(float along, float radius) {
    vec3 a = vec3(0.0, 1.0, -1.0);
    vec3 b = vec3(4.0, 1.0, -1.0);
    return approx(capsule(mix(a, b, along) + vec3(0.0, 3.0, 0.0), a, b, radius), 3.0 - radius);
}

// Corners are rounded, faces are not moved.
// each: 0, 0.1, 0.5
bool test_box_face(float radius) {
    return approx(roundedBox(vec3(0.0, 3.0, 0.0), vec3(1.0), radius), 2.0);
}

// What holds everywhere.

// any: p in vec3(-5)..vec3(5); q in vec3(-5)..vec3(5)
bool test_box_grows_no_faster_than_the_way(vec3 p, vec3 q) {
    float a = roundedBox(p, vec3(1.0, 2.0, 0.5), 0.2);
    float b = roundedBox(q, vec3(1.0, 2.0, 0.5), 0.2);
    return abs(a - b) <= distance(p, q) + 1e-5;
}

// any: a in -2..2; b in -2..2; width in 0..1
bool test_blend_is_symmetric_and_below_the_union(float a, float b, float width) {
    float both = blended(a, b, width);
    return approx(both, blended(b, a, width)) && both <= min(a, b) && both >= min(a, b) - width;
}

// any: p in vec3(-3)..vec3(3)
// each: count = 3, 4, 7
bool test_repetition_is_a_rotation(vec3 p, int count) {
    vec3 q = repeated(p, count);
    return approx(length(q), length(p)) && approx(q.y, p.y);
}

// fails: `max` is a bound of the distance only
bool test_difference_is_a_distance() {
    vec3 p = vec3(2.0, 0.0, 0.0);
    float moon = without(sphere(p, 1.0), sphere(p - vec3(1.0, 0.0, 0.0), 1.0));
    return approx(moon, distance(p, vec3(0.5, sqrt(0.75), 0.0)));
}

// How much a shape costs: `shaderlint test --bench`.
// any: p in vec3(-5)..vec3(5)
float bench_scene(vec3 p) {
    float ring = torus(repeated(p, 5), 2.0, 0.2);
    return blended(ring, roundedBox(p, vec3(1.0), 0.1), 0.3);
}
