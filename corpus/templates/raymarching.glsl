// Ray marching: a scene of signed distances with Phong lighting.

#define MAX_STEPS 128 // Adjustable: max step count, 64~256, more = more precise but slower
#define MAX_DIST 100.0 // Adjustable: max travel distance
#define SURF_DIST 0.001 // Adjustable: surface hit threshold, 0.0001~0.01
#define FOCAL_LENGTH 1.8 // Adjustable: 1.0~3.0, larger = narrower FOV
#define SHININESS 32.0 // Adjustable: 8~64

// --- Basic SDF Primitives ---
float sdSphere(vec3 p, float r) {
    return length(p) - r;
}

float sdBox(vec3 p, vec3 b) {
    vec3 d = abs(p) - b;
    return min(max(d.x, max(d.y, d.z)), 0.0) + length(max(d, 0.0));
}

float sdTorus(vec3 p, vec2 t) {
    return length(vec2(length(p.xz) - t.x, p.y)) - t.y;
}

// --- CSG Boolean Operations ---
float opUnion(float a, float b) { return min(a, b); }
float opSubtraction(float a, float b) { return max(a, -b); }
float opIntersection(float a, float b) { return max(a, b); }

// --- Smooth Boolean Operations (organic blending) ---
float smin(float a, float b, float k) {
    float h = max(k - abs(a - b), 0.0);
    return min(a, b) - h * h * 0.25 / k; // k adjustable: blend radius, 0.1~0.5
}

// --- Scene ---
float map(vec3 p) {
    float d = sdSphere(p - vec3(0.0, 0.5, 0.0), 0.5); // Sphere
    d = opUnion(d, p.y); // Add ground plane
    d = smin(d, sdBox(p - vec3(1.0, 0.3, 0.0), vec3(0.3)), 0.2); // Smooth blend with box
    return d;
}

// --- Camera ---
mat3 setCamera(vec3 ro, vec3 ta, float cr) {
    vec3 cw = normalize(ta - ro); // Forward direction
    vec3 cp = vec3(sin(cr), cos(cr), 0.0); // Up reference (cr controls roll)
    vec3 cu = normalize(cross(cw, cp)); // Right direction
    vec3 cv = cross(cu, cw); // Up direction
    return mat3(cu, cv, cw);
}

// --- Marching ---
float rayMarch(vec3 ro, vec3 rd) {
    float t = 0.0;
    for (int i = 0; i < MAX_STEPS; i++) {
        vec3 p = ro + t * rd;
        float d = map(p);
        if (d < SURF_DIST) return t; // Surface hit
        t += d;
        if (t > MAX_DIST) break; // Out of range
    }
    return -1.0; // No hit
}

// Tetrahedron trick (4 SDF calls, prevents compiler inline bloat)
vec3 calcNormal(vec3 pos) {
    vec3 n = vec3(0.0);
    for (int i = 0; i < 4; i++) {
        vec3 e = 0.5773 * (2.0 * vec3((((i+3)>>1)&1), ((i>>1)&1), (i&1)) - 1.0);
        n += e * map(pos + 0.001 * e);
    }
    return normalize(n);
}

// --- Lighting ---
vec3 shade(vec3 p, vec3 rd) {
    vec3 nor = calcNormal(p);
    vec3 lightDir = normalize(vec3(0.6, 0.35, 0.5)); // Light direction (adjustable)
    vec3 viewDir = -rd;
    vec3 halfDir = normalize(lightDir + viewDir);

    // Diffuse
    float diff = clamp(dot(nor, lightDir), 0.0, 1.0);
    // Specular
    float spec = pow(clamp(dot(nor, halfDir), 0.0, 1.0), SHININESS); // SHININESS adjustable: 8~64
    // Ambient + sky light
    float sky = sqrt(clamp(0.5 + 0.5 * nor.y, 0.0, 1.0));

    vec3 col = vec3(0.2, 0.2, 0.25); // Material base color (adjustable)
    vec3 lin = vec3(0.0);
    lin += diff * vec3(1.3, 1.0, 0.7) * 2.2; // Main light
    lin += sky * vec3(0.4, 0.6, 1.15) * 0.6; // Sky light
    lin += vec3(0.25) * 0.55; // Fill light
    col *= lin;
    col += spec * vec3(1.3, 1.0, 0.7) * 5.0; // Specular highlight

    return col;
}

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = (2.0 * fragCoord - iResolution.xy) / iResolution.y;
    float angle = 0.4 * iTime;
    vec3 ta = vec3(0.4, 0.4, 0.0);
    vec3 ro = ta + vec3(3.2 * cos(angle), 1.4, 3.2 * sin(angle));
    mat3 ca = setCamera(ro, ta, 0.0);
    vec3 rd = ca * normalize(vec3(uv, FOCAL_LENGTH));

    vec3 col = vec3(0.5, 0.7, 0.9) - 0.4 * max(rd.y, 0.0); // Sky
    float t = rayMarch(ro, rd);
    if (t > 0.0) {
        col = mix(shade(ro + t * rd, rd), col, 1.0 - exp(-0.0006 * t * t * t));
    }

    // Reinhard tone mapping
    col = col / (1.0 + col);
    // Gamma correction
    col = pow(col, vec3(0.4545));
    // Vignette
    vec2 q = fragCoord / iResolution.xy;
    col *= 0.5 + 0.5 * pow(16.0 * q.x * q.y * (1.0 - q.x) * (1.0 - q.y), 0.25);
    fragColor = vec4(col, 1.0);
}
