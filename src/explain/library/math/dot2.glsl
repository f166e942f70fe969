// Square of the length of a vector.
// SPDX-License-Identifier: 0BSD

// Two numbers.
float dot2(vec2 v) {
    return dot(v, v);
}

// Three numbers.
float dot2(vec3 v) {
    return dot(v, v);
}

// Four numbers.
float dot2(vec4 v) {
    return dot(v, v);
}
