//! Tests of the proof that a loop follows a ray.

use super::ray_loops;
use crate::test_shader::{TestShader, cases};

const SCENE: &str = "float map(vec3 p) { return length(p) - 1.0; }
    vec3 normal(vec3 p) { return normalize(p); }
    bool full(ivec3 c) { return c.y < 0; }\n";

/// Checks the ray loops of a shader: their kinds, exits, and whether they start at the camera.
#[track_caller]
fn check_shader(code: &str, expected: &str) {
    let code = format!("{SCENE}{code}");
    let shader = TestShader::of(&code);
    let rays = ray_loops(shader.query(), &shader.calls)
        .into_iter()
        .map(|ray| {
            let mut words = vec![format!("{:?}", ray.kind)];
            let all = [
                (ray.hit.is_some(), "hit"),
                (ray.ends_far, "far"),
                (ray.accumulates, "sum"),
                (ray.start.is_some(), "camera"),
                (ray.scene.is_some(), "scene"),
            ];
            words.extend(
                all.iter()
                    .filter(|(is, _)| *is)
                    .map(|(_, word)| word.to_string()),
            );
            words.join(" ")
        });
    assert_eq!(rays.collect::<Vec<_>>().join(", "), expected, "{code}");
}

/// The same for the body of `mainImage`.
#[track_caller]
fn check(body: &str, expected: &str) {
    check_shader(
        &format!(
            "void mainImage(out vec4 o, vec2 q) {{
                vec3 ro = vec3(0.0, 0.0, -3.0), rd = normalize(vec3(q, 1.0));
                float t = 0.0, d = 1.0; vec3 p = ro; o = vec4(0.0);
                {body}
                o += vec4(t, d, p.x, 1.0); }}"
        ),
        expected,
    );
}

#[test]
fn loops_have_the_expected_rays() {
    for (code, expected) in cases(include_str!("cases.txt")) {
        match code.strip_prefix("shader: ") {
            Some(shader) => check_shader(shader, expected),
            None => check(code, expected),
        }
    }
}
