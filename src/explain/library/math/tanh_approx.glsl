// Hyperbolic tangent, which GLSL ES 1.00 lacks: rises from -1 to 1.
// SPDX-License-Identifier: 0BSD

// Beyond 9 the result differs from 1 by less than a float can tell.
float tanh_approx(float x) {
    float e = exp(2.0 * clamp(x, -9.0, 9.0));
    return (e - 1.0) / (e + 1.0);
}
