// Rotation of a point about an axis through the origin.
// SPDX-License-Identifier: 0BSD

// The axis has the length 1; the angle is in radians.
vec3 erot(vec3 p, vec3 axis, float angle) {
    vec3 along = dot(p, axis) * axis;
    return along + cos(angle) * (p - along) + sin(angle) * cross(axis, p);
}
