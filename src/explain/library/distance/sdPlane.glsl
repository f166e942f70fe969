// Signed distance to a plane, negative below.
// SPDX-License-Identifier: 0BSD

// The plane y = 0.
float sdPlane(vec3 p) {
    return p.y;
}

// The plane y = `height`.
float sdPlane(vec3 p, float height) {
    return p.y - height;
}

// By a normal of the length 1 and the offset: the plane dot(p, plane.xyz) = -plane.w.
float sdPlane(vec3 p, vec4 plane) {
    return dot(p, plane.xyz) + plane.w;
}

// By a normal of the length 1 and the offset: the plane dot(p, normal) = -offset.
float sdPlane(vec3 p, vec3 normal, float offset) {
    return dot(p, normal) + offset;
}
