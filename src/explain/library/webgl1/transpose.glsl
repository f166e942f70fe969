// Exchanges rows and columns, which GLSL ES 1.00 has no function for.
// SPDX-License-Identifier: 0BSD

// Two rows.
mat2 transpose(mat2 m) {
    return mat2(m[0].x, m[1].x, m[0].y, m[1].y);
}

// Three rows.
mat3 transpose(mat3 m) {
    return mat3(m[0].x, m[1].x, m[2].x, m[0].y, m[1].y, m[2].y, m[0].z, m[1].z, m[2].z);
}

// Four rows.
mat4 transpose(mat4 m) {
    return mat4(m[0].x, m[1].x, m[2].x, m[3].x, m[0].y, m[1].y, m[2].y, m[3].y,
                m[0].z, m[1].z, m[2].z, m[3].z, m[0].w, m[1].w, m[2].w, m[3].w);
}
