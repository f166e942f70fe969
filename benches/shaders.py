"""Generates shaders of any size for the benchmarks."""

HEADER = '#version 300 es\nprecision highp float;\nuniform vec2 size;\nuniform float time;\nout vec4 color;\n'


def function(i):
    """One function of ten lines in typical shader style."""
    before = f'shape{i - 1}(p * 1.1, t)' if i % 8 else 'length(p) - 1.0'
    return f'''float shape{i}(vec3 p, float t) {{
    vec3 q = abs(p) - vec3(0.{i % 9 + 1}, 1.0, 0.5);
    float edge = max(q.x, max(q.y, q.z));
    float wave = 0.5 + 0.5 * sin(t * {i % 7 + 1}.0 + p.x * 3.0); // moves
    for (int k = 0; k < 4; k++) {{
        q = abs(q) - 0.25 * float(k + 1);
        edge = min(edge, length(q.xy) - 0.1 * wave);
    }}
    return min(edge, {before});
}}
'''


def shader(functions):
    body = ''.join(function(i) for i in range(functions))
    call = f'shape{functions - 1}(vec3(gl_FragCoord.xy / size, 0.0), time)'
    return f'{HEADER}{body}void main() {{\n    color = vec4({call});\n}}\n'


def tiny():
    """The smallest shader that draws something."""
    return HEADER + 'void main() {\n    color = vec4(gl_FragCoord.xy / size, 0.0, 1.0);\n}\n'
