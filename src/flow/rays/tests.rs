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
fn loops_with_fixed_steps_are_ray_marching() {
    check(
        "for (float s = 0.1; s < 9.0; s += 0.02) { p = ro + rd * s; if (map(p) < 0.0) break; }",
        "Fixed far scene",
    );
    check(
        "float dt = 0.1; for (t = 0.2; t < 40.0; t += dt) { if (map(ro + t * rd) < 0.0) break; dt = 0.01 * t; }",
        "Fixed far scene",
    );
    // Samples of a volume.
    check(
        "for (int i = 0; i < 80; i++) { d = map(ro + rd * t); o += d; if (o.x > 1.0) break; t += 0.1; }",
        "Fixed far scene",
    );
    // Octaves, slices and samples on a plane are no rays.
    check(
        "float f = 1.0; for (int i = 0; i < 5; i++) { d += map(ro * f); f += 1.0; }",
        "",
    );
    check(
        "for (float z = 0.0; z < 1.0; z += 0.1) d += map(vec3(q, z));",
        "",
    );
    check(
        "for (float z = 0.0; z < 1.0; z += 0.1) d += length(q + z);",
        "",
    );
}

#[test]
fn ray_marching_may_use_struct_members() {
    check_shader(
        "struct Ray { vec3 o, d; }; struct Found { vec3 at; float far; };
        vec3 at(Ray r, float t) { return r.o + r.d * t; }
        void mainImage(out vec4 o, vec2 q) {
            Ray r = Ray(vec3(0.0), normalize(vec3(q, 1.0))); Found found; float t = 0.0;
            for (int i = 0; i < 80 && t < 9.0; i++) {
                found.at = at(r, t); found.far = map(found.at);
                if (found.far < 0.01) break;
                t += found.far; }
            o = vec4(t); }",
        "Distance hit far scene",
    );
}

#[test]
fn other_loops_are_not_ray_marching() {
    // Bounces.
    check(
        "for (int i = 0; i < 4; i++) { d = map(ro); if (d < 0.001) break; ro += rd * d; rd = reflect(rd, normal(ro)); }",
        "",
    );
    // Two dimensions.
    check(
        "vec2 a = q; for (int i = 0; i < 80; i++) { d = length(a) - 1.0; if (d < 0.001) break; a += rd.xy * d; }",
        "",
    );
    // Fractals.
    check(
        "for (int i = 0; i < 80; i++) { p = abs(p) / dot(p, p) - 1.0; d = length(p); if (d < 0.001) break; t += d; }",
        "",
    );
    check(
        "vec2 z = q; for (int i = 0; i < 80; i++) { z = vec2(z.x * z.x - z.y * z.y, 2.0 * z.x * z.y) + q; if (dot(z, z) > 4.0) break; t += 1.0; }",
        "",
    );
    // Octaves.
    check(
        "for (int i = 0; i < 8; i++) { d *= 0.5; t += d * map(p); p *= 2.0; }",
        "",
    );
    // Ambient occlusion.
    check(
        "for (int i = 0; i < 5; i++) { float h = 0.1 * float(i); d += h - map(p + rd * h); if (d > 1.0) break; }",
        "",
    );
}

#[test]
fn grid_traversals_are_recognised() {
    check(
        "ivec3 c = ivec3(floor(ro)), go = ivec3(sign(rd)); vec3 delta = abs(1.0 / rd), next = delta * 0.5;
        for (int i = 0; i < 80; i++) {
            if (full(c)) break;
            vec3 mask = step(next.xyz, next.yzx) * step(next.xyz, next.zxy);
            next += mask * delta; c += ivec3(mask) * go; }",
        "Grid hit camera scene",
    );
    check(
        "bvec3 mask; ivec3 c = ivec3(floor(ro)), go = ivec3(sign(rd)); vec3 delta = abs(1.0 / rd), next = delta * 0.5;
        for (int i = 0; i < 80; i++) {
            if (full(c)) break;
            mask = lessThanEqual(next.xyz, min(next.yzx, next.zxy));
            next += vec3(mask) * delta; c += ivec3(vec3(mask)) * go; }",
        "Grid hit camera scene",
    );
    // Not by one.
    check(
        "ivec3 c = ivec3(ro); for (int i = 0; i < 80; i++) { if (full(c)) break; c += ivec3(rd * 9.0 * float(i)); }",
        "",
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
