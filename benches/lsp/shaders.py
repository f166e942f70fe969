"""Generates shaders of any length for measurements: noise, distance functions, loops, structs and
macros in typical style. The same arguments always give the same text."""

import random

BLOCKS = [
    """#define RATIO{n} {a}
#define SATURATE{n}(x) clamp((x), 0.0, {b})

// A number for each cell of a grid.
float hash{n}(vec2 p) {{
    vec3 q = fract(vec3(p.xyx) * {a});
    q += dot(q, q.yzx + 33.33);
    return fract((q.x + q.y) * q.z);
}}

float noise{n}(vec2 p) {{
    vec2 cell = floor(p);
    vec2 f = fract(p);
    vec2 u = f * f * (3.0 - 2.0 * f);
    float bottom = mix(hash{n}(cell), hash{n}(cell + vec2(1.0, 0.0)), u.x);
    float top = mix(hash{n}(cell + vec2(0.0, 1.0)), hash{n}(cell + vec2(1.0, 1.0)), u.x);
    return mix(bottom, top, u.y);
}}

// Octaves of it.
float fbm{n}(vec2 p) {{
    float sum = 0.0;
    float amplitude = 0.5;
    for (int i = 0; i < {k}; i++) {{
        sum += amplitude * noise{n}(p);
        p = p * 2.02 + vec2({b}, 1.7);
        amplitude *= 0.5;
    }}
    return SATURATE{n}(sum);
}}
""",
    """struct Material{n} {{
    vec3 albedo; // what it reflects
    float roughness;
    float metallic;
}};

float sphere{n}(vec3 p, float radius) {{
    return length(p) - radius;
}}

float box{n}(vec3 p, vec3 half_size) {{
    vec3 q = abs(p) - half_size;
    return length(max(q, 0.0)) + min(max(q.x, max(q.y, q.z)), 0.0);
}}

mat2 turn{n}(float angle) {{
    float c = cos(angle), s = sin(angle);
    return mat2(c, -s, s, c);
}}

float scene{n}(vec3 p) {{
    p.xz = turn{n}({a} * iTime) * p.xz;
    float d = sphere{n}(p - vec3(0.0, {b}, 0.0), {b});
    d = min(d, box{n}(p, vec3({b}, 0.3, 0.4)));
    return min(d, p.y + 1.0);
}}

vec3 normal{n}(vec3 p) {{
    const vec2 e = vec2(0.001, 0.0);
    return normalize(vec3(
        scene{n}(p + e.xyy) - scene{n}(p - e.xyy),
        scene{n}(p + e.yxy) - scene{n}(p - e.yxy),
        scene{n}(p + e.yyx) - scene{n}(p - e.yyx)));
}}

// How far a ray goes; below zero where it meets nothing.
float march{n}(vec3 origin, vec3 ray) {{
    float t = 0.0;
    for (int i = 0; i < 1{k}; i++) {{
        float d = scene{n}(origin + ray * t);
        if (d < 0.001 * t) {{
            return t;
        }}
        t += d;
        if (t > 40.0) {{
            break;
        }}
    }}
    return -1.0;
}}

vec3 shade{n}(vec3 origin, vec3 ray, Material{n} material) {{
    float t = march{n}(origin, ray);
    if (t < 0.0) {{
        return mix(vec3(0.7, 0.8, 0.9), vec3(0.2, 0.4, {b}), ray.y * 0.5 + 0.5);
    }}
    vec3 place = origin + ray * t;
    vec3 n = normal{n}(place);
    vec3 light = normalize(vec3({b}, 0.9, -0.3));
    float diffuse = max(dot(n, light), 0.0);
    float shine = pow(max(dot(reflect(ray, n), light), 0.0), 8.0 / (material.roughness + 0.1));
    return material.albedo * diffuse + shine * material.metallic;
}}
""",
]
LAST = """void mainImage(out vec4 fragColor, in vec2 fragCoord) {{
    vec2 uv = (fragCoord - 0.5 * iResolution.xy) / iResolution.y;
    vec3 ray = normalize(vec3(uv, 1.5));
    vec3 col = vec3(0.0);
{calls}    fragColor = vec4(sqrt(max(col, 0.0)), 1.0);
}}
"""


def numbers(source):
    """Constants that differ between blocks."""
    return {
        "a": "%.4f" % source.uniform(0.1, 0.9),
        "b": "%.2f" % source.uniform(0.2, 0.8),
        "k": source.randint(4, 8),
    }


def shader(lines, seed=1):
    """A shader of about this many lines. The image uses only a few of its functions, as in a file
    that grew over the years; the rest is still compiled."""
    source = random.Random(seed)
    parts, count, number = [], 0, 0
    while count < lines - 20:
        block = BLOCKS[number % 2].format(n=number, **numbers(source))
        parts.append(block)
        count += block.count("\n") + 1
        number += 1
    calls = []
    for used in range(min(number, 4)):
        if used % 2:
            calls.append("    col += shade%d(vec3(0.0, 0.5, -3.0), ray, Material%d(vec3(0.8), 0.4, 0.2));\n"
                         % (used, used))
        else:
            calls.append("    col += RATIO%d * fbm%d(uv * 8.0 + iTime);\n" % (used, used))
    parts.append(LAST.format(calls="".join(calls)))
    return "\n".join(parts)
