// Examples: the shaders of the repository.
const templates = import.meta.glob('../../../corpus/templates/*.glsl', { query: '?raw', import: 'default' });
const pitfalls = import.meta.glob('../../../corpus/pitfalls/*.glsl', { query: '?raw', import: 'default' });
const mistakes = import.meta.glob('../../../corpus/mistakes/*.{glsl,frag}', { query: '?raw', import: 'default' });

/** What a visitor sees first: an image, and a warning about it. */
export const FIRST = `// Errors and warnings appear as you type: write 8 for 8.0.
float wave(vec2 p) {
    return 0.5 + 0.5 * sin(p.x * 8.0 + iTime) * cos(p.y * 8.0);
}

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = (2.0 * fragCoord - iResolution.xy) / iResolution.y;
    float height = wave(uv) - 0.5 * length(uv);
    vec3 color = mix(vec3(0.05, 0.2, 0.4), vec3(1.0, 0.8, 0.5), sqrt(height));
    fragColor = vec4(color, 1.0);
}
`;

const named = (files, label) =>
  Object.entries(files).map(([path, load]) => {
    const name = path.slice(path.lastIndexOf('/') + 1);
    return { label, name, load };
  });

/** All examples, by group. */
export const examples = [
  { label: 'Start', name: 'wave.glsl', load: () => Promise.resolve(FIRST) },
  ...named(templates, 'Complete shaders'),
  ...named(pitfalls, 'Pitfalls'),
  ...named(mistakes, 'Mistakes'),
];
