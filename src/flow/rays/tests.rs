//! Tests of the proof that a loop follows a ray.

use super::ray_loops;
use crate::calls::Calls;
use crate::ranges::{Query, Ranges};
use crate::reaching_definitions::ReachingDefinitions;
use crate::test_shader::checked;
use shaderlint_ir::lower;

const SCENE: &str = "float map(vec3 p) { return length(p) - 1.0; }
    vec3 normal(vec3 p) { return normalize(p); }
    bool full(ivec3 c) { return c.y < 0; }\n";

/// Checks the ray loops of a shader: their kinds, exits, and whether they start at the camera.
#[track_caller]
fn check_shader(code: &str, expected: &str) {
    let code = format!("{SCENE}{code}");
    let analysis = checked(&code);
    let module = lower(&analysis.program);
    let calls = Calls::of(&module);
    let defs = ReachingDefinitions::of(&analysis.program, &module, &calls);
    let query = Query {
        program: &analysis.program,
        module: &module,
        defs: &defs,
        ranges: &Ranges::default(),
    };
    let rays = ray_loops(query, &calls).into_iter().map(|ray| {
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
    let cases = include_str!("cases.txt").lines();
    for case in cases.filter(|case| !case.starts_with("# ")) {
        let (code, expected) = case.rsplit_once(" =>").unwrap();
        match code.strip_prefix("shader: ") {
            Some(shader) => check_shader(shader, expected.trim()),
            None => check(code, expected.trim()),
        }
    }
}

#[test]
fn loops_that_step_by_the_distance_are_ray_marching() {
    let full = "Distance hit far camera scene";
    check(
        "for (int i = 0; i < 80; i++) { d = map(ro + rd * t); if (d < 0.001 || t > 20.0) break; t += d; }",
        full,
    );
    check(
        "for (int i = 0; i < 80; i++) { if (d < 0.001) break; if (t > 20.0) break; d = map(ro + t * rd); t += 0.5 * d; }",
        full,
    );
    check(
        "while (d > 0.001 && t < 20.0) { d = map(ro + rd * t); t += max(d, 0.01); }",
        full,
    );
    check(
        "for (int i = 0; i < 80; i++) { vec3 x = ro + rd * t; float h = map(x); t += h * 0.7; if (abs(h) < 0.001 * t || t > 9.0) break; }",
        full,
    );
    check(
        "for (int i = 0; i < 80; i++) { d = map(p); if (d < 0.001 || length(p) > 9.0) break; p += rd * d; }",
        full,
    );
    check(
        "for (int i = 0; i < 80; i++) { d = map(p); p += d * rd * 0.5; if (d < 0.001 || p.z > 9.0) break; }",
        full,
    );
    check(
        "for (int i = 0; i < 80; i++) { d = length(ro + rd * t) - 1.0; if (d < 0.001 || t > 20.0) break; t += d; }",
        "Distance hit far camera",
    );
    check(
        "vec4 h; h.w = 0.0; for (int i = 0; i < 80; i++) { d = map(ro + rd * h.w); if (d < 0.001) break; h.w += d; }",
        "Distance hit camera scene",
    );
    check(
        "for (int i = 0; i < 80; i++) { d = map(ro + rd * t); if (d < 0.001) break; t += d; }",
        "Distance hit camera scene",
    );
    check(
        "for (int i = 0; i < 80; i++) { d = map(ro + rd * t); t += d; }",
        "Distance camera scene",
    );
    check(
        "for (int i = 0; i < 80; i++) { d = map(ro + rd * t); if (t > 20.0) break; t += d; o.x += exp(-d); }",
        "Distance far sum camera scene",
    );
}

#[test]
fn secondary_rays_do_not_start_at_the_camera() {
    let march = "for (int i = 0; i < 80; i++) { d = map(ro + rd * t); if (d < 0.001 || t > 20.0) break; t += d; }";
    check(
        &format!("{march} ro += rd * t; rd = vec3(0.0, 1.0, 0.0); t = 0.1; {march}"),
        "Distance hit far camera scene, Distance hit far scene",
    );
    let cast =
        format!("float castRay(vec3 ro, vec3 rd) {{ float t = 0.1, d; {march} return t; }}\n");
    let main = "void mainImage(out vec4 o, vec2 q) {
        vec3 ro = vec3(0.0, 0.0, -3.0), rd = normalize(vec3(q, 1.0));
        float t = castRay(ro, rd);";
    check_shader(
        &format!("{cast}{main} o = vec4(castRay(ro + rd * t, rd)); }}"),
        "Distance hit far camera scene",
    );
    let shadow = cast.replace("castRay", "shadow");
    check_shader(
        &format!("{cast}{shadow}{main} o = vec4(shadow(ro + rd * t, rd)); }}"),
        "Distance hit far camera scene, Distance hit far scene",
    );
}
