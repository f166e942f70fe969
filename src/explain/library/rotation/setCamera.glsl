// Axes of a camera: right, up and forward, as the columns of a matrix.
// SPDX-License-Identifier: 0BSD

// From the position, the point that it looks at and the roll in radians: `m * vec3(uv, zoom)`.
mat3 setCamera(vec3 position, vec3 target, float roll) {
    vec3 view = target - position;
    vec3 forward = dot(view, view) > 0.0 ? normalize(view) : vec3(0.0, 0.0, 1.0);
    vec3 side = cross(forward, vec3(sin(roll), cos(roll), 0.0));
    bool vertical = dot(side, side) < 1e-8;
    vec3 right = vertical ? vec3(cos(roll), -sin(roll), 0.0) : normalize(side);
    return mat3(right, cross(right, forward), forward);
}
