//! One cause is one finding, also where several rules see it.

use crate::scratch::Scratch;

/// Bodies of `mainImage`, with the rules that report them.
const CASES: [(&str, &str); 3] = [
    (
        "vec3 c; for (float j = 0.0; j < 4.0; j++) c[int(j)] = p.x * j; o = vec4(c, 1.0);",
        "out-of-range-seen",
    ),
    (
        "vec2 k[4] = vec2[4](p, p.yx, p, p); o = vec4(k[(iFrame - 1) % 4] / iResolution.xy, 0.2, 1.0);",
        "negative-remainder",
    ),
    (
        "vec2 u = p / iResolution.x; float x = u.x - 0.5, y = 0.28 + sin(iTime) * 0.1 - u.y;\
         o = vec4(sqrt(pow(x, 2.0) + pow(y, 2.0)));",
        "pow-negative-base",
    ),
];

#[test]
fn one_cause_is_one_finding() {
    for (body, expected) in CASES {
        let text = format!("void mainImage(out vec4 o, vec2 p) {{ {body} }}\n");
        let folder = Scratch::new(&[("a.glsl", &text)]);
        let found = folder.places(&["check", "a.glsl"]);
        let rules: Vec<&str> = found.iter().filter_map(|f| f.split(' ').nth(1)).collect();
        assert_eq!(rules, [expected], "{text}{found:?}");
    }
}
