// Fractal noise in [0, 1): a sum of octaves of noise, each half as strong as the last.
// SPDX-License-Identifier: 0BSD

// In the plane, as the sum of five octaves.
float fbm(vec2 p) {
    float sum = 0.0;
    float amplitude = 0.5;
    for (int i = 0; i < 5; i++) {
        sum += amplitude * noise(p);
        amplitude *= 0.5;
        p = 2.0 * mat2(0.8, -0.6, 0.6, 0.8) * p + 17.3;
    }
    return sum;
}

// In space, as the sum of five octaves.
float fbm(vec3 p) {
    float sum = 0.0;
    float amplitude = 0.5;
    for (int i = 0; i < 5; i++) {
        sum += amplitude * noise(p);
        amplitude *= 0.5;
        p = 2.0 * vec3(0.8 * p.y - 0.6 * p.z, 0.6 * p.y + 0.8 * p.z, p.x) + 17.3;
    }
    return sum;
}

// In the plane, as the sum of up to 16 octaves.
float fbm(vec2 p, int octaves) {
    float sum = 0.0;
    float amplitude = 0.5;
    for (int i = 0; i < 16; i++) {
        if (i >= octaves) {
            break;
        }
        sum += amplitude * noise(p);
        amplitude *= 0.5;
        p = 2.0 * mat2(0.8, -0.6, 0.6, 0.8) * p + 17.3;
    }
    return sum;
}

// In space, as the sum of up to 16 octaves.
float fbm(vec3 p, int octaves) {
    float sum = 0.0;
    float amplitude = 0.5;
    for (int i = 0; i < 16; i++) {
        if (i >= octaves) {
            break;
        }
        sum += amplitude * noise(p);
        amplitude *= 0.5;
        p = 2.0 * vec3(0.8 * p.y - 0.6 * p.z, 0.6 * p.y + 0.8 * p.z, p.x) + 17.3;
    }
    return sum;
}

// Along a line, as the sum of five octaves.
float fbm(float x) {
    float sum = 0.0;
    float amplitude = 0.5;
    for (int i = 0; i < 5; i++) {
        sum += amplitude * noise(x);
        amplitude *= 0.5;
        x = 2.0 * x + 17.3;
    }
    return sum;
}
