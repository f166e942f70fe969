// Distances to shapes and ways to combine them: negative inside, zero on the surface.

const float PI = 3.14159265;

float sphere(vec3 p, float radius) {
    return length(p) - radius;
}

float torus(vec3 p, float radius, float thickness) {
    float around = length(p.xz) - radius;
    return length(vec2(around, p.y)) - thickness;
}

// The way from `a` to `b`, widened by `radius`.
float capsule(vec3 p, vec3 a, vec3 b, float radius) {
    vec3 way = b - a;
    float along = dot(way, way) > 0.0 ? dot(p - a, way) / dot(way, way) : 0.0;
    return distance(p, a + way * clamp(along, 0.0, 1.0)) - radius;
}

float roundedBox(vec3 p, vec3 size, float radius) {
    vec3 beyond = abs(p) - size + radius;
    float outside = length(max(beyond, 0.0));
    float inside = min(max(beyond.x, max(beyond.y, beyond.z)), 0.0);
    return outside + inside - radius;
}

// What is in `a` but not in `b`. A lower bound of the distance, not the distance itself.
float without(float a, float b) {
    return max(a, -b);
}

// The union of both, with a seam as wide as `width`.
float blended(float a, float b, float width) {
    if (width <= 0.0) {
        return min(a, b);
    }
    float overlap = max(width - abs(a - b), 0.0) / width;
    return min(a, b) - overlap * overlap * width * 0.25;
}

// Repeats space around the axis `y`, `count` times.
vec3 repeated(vec3 p, int count) {
    float slice = 2.0 * PI / float(count);
    float angle = atan(p.z, p.x);
    float turned = angle - slice * floor(angle / slice + 0.5);
    return vec3(length(p.xz) * vec2(cos(turned), sin(turned)), p.y).xzy;
}
