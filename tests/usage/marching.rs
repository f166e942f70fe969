//! Rays that step over a surface: what `run` counts, and what the linter reports and fixes.

use crate::scratch::Scratch;

const CAMERA: &str = "
void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = (2.0 * fragCoord - iResolution.xy) / iResolution.y;
    float a = 0.3 * iTime;
    vec3 ro = vec3(3.0 * sin(a), 1.0, 3.0 * cos(a));
    vec3 f = normalize(-ro), r = normalize(cross(f, vec3(0, 1, 0))), u = cross(r, f);
    vec3 rd = normalize(uv.x * r + uv.y * u + 1.5 * f);
    vec2 hit = march(ro, rd);
    vec3 color = mix(vec3(0.5, 0.7, 1.0), vec3(0.2, 0.4, 0.8), uv.y);
    if (hit.y > 0.5) color = vec3(0.9, 0.5, 0.2) + 0.3 * sin(5.0 * (ro + rd * hit.x));
    fragColor = vec4(color * light(ro + rd * hit.x), 1.0);
}
";
const LIGHT: &str = "float light(vec3 p) { return 1.0; }";

/// A loop that moves a ray parameter.
const PARAMETER: &str = "vec2 march(vec3 ro, vec3 rd) {
    float t = 0.0;
    for (int i = 0; i < 120; i++) {
        float d = map(ro + rd * t);
        if (d < 0.001) return vec2(t, 1.0);
        t += d;
        if (t > 20.0) break;
    }
    return vec2(20.0, 0.0);
}";
/// A loop that moves a point.
const POINT: &str = "vec2 march(vec3 ro, vec3 rd) {
    vec3 p = ro;
    for (int i = 0; i < 120; i++) {
        float d = map(p);
        if (abs(d) < 0.001) return vec2(distance(ro, p), 1.0);
        p += rd * d * 0.9;
        if (length(p) > 20.0) break;
    }
    return vec2(20.0, 0.0);
}";
/// A loop that tests what the previous iteration has left.
const LATE: &str = "vec2 march(vec3 ro, vec3 rd) {
    float t = 0.0, d = 1.0;
    int i = 0;
    while (d > 0.001 && t < 20.0 && i < 120) {
        d = map(ro + rd * t);
        t += d;
        i++;
    }
    return vec2(t, float(d <= 0.001));
}";

/// Exact distances, and others that change by less than 1 per unit.
const GENTLE: [&str; 6] = [
    "return length(p) - 1.0;",
    "vec3 q = abs(p) - 0.8; return length(max(q, 0.0)) + min(max(q.x, max(q.y, q.z)), 0.0);",
    "return length(vec2(length(p.xz) - 0.9, p.y)) - 0.25;",
    "p.y -= clamp(p.y, -0.8, 0.8); return length(p) - 0.2;",
    "return min(p.y + 1.0, length(p) - 1.0);",
    "float a = length(p - 0.4) - 0.6, b = length(p + 0.4) - 0.6, h = clamp(0.5 + (b - a) / 0.6, 0.0, 1.0);
     return mix(b, a, h) - 0.3 * h * (1.0 - h);",
];

/// Scenes that are too steep for full steps.
const STEEP: [&str; 5] = [
    "return length(p) - 1.0 + 0.3 * sin(9.0 * p.x) * sin(9.0 * p.y) * sin(9.0 * p.z);",
    "float c = cos(5.0 * p.y), s = sin(5.0 * p.y); p.xz = mat2(c, -s, s, c) * p.xz;
     vec3 q = abs(p) - vec3(0.7, 1.0, 0.2);
     return length(max(q, 0.0)) + min(max(q.x, max(q.y, q.z)), 0.0);",
    "return 2.0 * (length(p / vec3(1.0, 0.2, 1.0)) - 1.0);",
    "return 2.0 * length(p - vec3(0.0, 0.3, 0.0)) - 1.6;",
    "return p.y + 0.5 - 0.5 * sin(4.0 * p.x) * sin(4.0 * p.z) - 0.2 * sin(9.0 * p.x) * sin(11.0 * p.z);",
];

fn shader(scene: &str, [march, light]: [&str; 2]) -> String {
    format!("float map(vec3 p) {{ {scene} }}\n{march}\n{light}\n{CAMERA}")
}

/// The findings of the rule in a shader.
fn lint(scratch: &Scratch, options: &[&str]) -> String {
    let rule = [
        "a.glsl",
        "--run-samples",
        "4096",
        "--only",
        "missed-surface",
    ];
    let args = [&rule[..], options].concat();
    scratch.run(&args).out
}

/// The rays of each loop of a frame: their share that steps over a surface, and their steepest slope.
fn rays(scratch: &Scratch) -> Vec<(f64, f64)> {
    let args = [
        "run", "a.glsl", "--size", "96x54", "--time", "1", "--report",
    ];
    let ran = scratch.run(&[&args[..], &["--format", "json"]].concat());
    let facts: serde_json::Value = serde_json::from_str(&ran.out).expect(&ran.err);
    let rows = facts["rays"].as_array().cloned().unwrap_or_default();
    let number = |row: &serde_json::Value, key: &str| row[key].as_f64().unwrap();
    let rows = rows.iter();
    rows.map(|row| (number(row, "stepped_over"), number(row, "slope")))
        .collect()
}

#[test]
fn exact_distance_fields_are_marched_without_holes() {
    for scene in GENTLE {
        for march in [PARAMETER, POINT, LATE] {
            let text = shader(scene, [march, LIGHT]);
            let scratch = Scratch::new(&[("a.glsl", &text)]);
            let found = lint(&scratch, &[]);
            assert!(!found.contains("steps over"), "{found}\n{text}");
        }
        let text = shader(scene, [PARAMETER, LIGHT]);
        let [(share, slope)] = rays(&Scratch::new(&[("a.glsl", &text)]))[..] else {
            panic!("{text}");
        };
        assert!(share == 0.0 && slope < 1.001, "{share} {slope}\n{text}");
    }
}

#[test]
fn fixed_step_factors_remove_holes() {
    let marches = [PARAMETER, POINT, LATE].into_iter().cycle();
    for (scene, march) in STEEP.into_iter().zip(marches) {
        let text = shader(scene, [march, LIGHT]);
        let scratch = Scratch::new(&[("a.glsl", &text)]);
        let found = lint(&scratch, &[]);
        assert!(
            found.contains("steps over the surface in"),
            "{found}\n{text}"
        );
        let before = rays(&scratch);
        assert!(
            before[0].0 > 0.003 && before[0].1 > 1.2,
            "{before:?}\n{text}"
        );
        lint(&scratch, &["--unsafe-fixes"]);
        let fixed = scratch.read("a.glsl");
        assert_ne!(fixed, text);
        let (found, after) = (lint(&scratch, &[]), rays(&scratch));
        assert!(!found.contains("steps over"), "{found}\n{fixed}");
        assert!(after[0].0 < 0.003, "{after:?}\n{fixed}");
    }
}

#[test]
fn iteration_limits_are_raised_for_shorter_steps() {
    let march = PARAMETER.replace("i < 120", "i < 24");
    let scratch = Scratch::new(&[("a.glsl", &shader(STEEP[2], [&march, LIGHT]))]);
    let found = lint(&scratch, &["--unsafe-fixes"]);
    let fixed = scratch.read("a.glsl");
    assert!(fixed.contains("t += d * 0.2;"), "{found}\n{fixed}");
    assert!(fixed.contains("i < 120"), "{found}\n{fixed}");
}

#[test]
fn named_iteration_limits_are_raised_at_their_definition() {
    let named = PARAMETER.replace("i < 120", "i < STEPS");
    let tested = named
        .replace("for (int i = 0", "int i;\n    for (i = 0")
        .replace(
            "return vec2(20.0, 0.0)",
            "return vec2(i == STEPS ? t : 20.0, 0.0)",
        );
    let counted = named.replace("vec2(20.0, 0.0)", "vec2(20.0 + 0.0 * float(STEPS), 0.0)");
    for (definition, march, is_raised) in [
        ("#define STEPS 24", &named, true),
        ("#define STEPS (24)", &tested, true),
        ("const int STEPS = 24;", &named, true),
        ("const int STEPS = 24;", &tested, true),
        ("#define STEPS 24", &counted, false),
        ("const int STEPS = 24;", &counted, false),
        ("#define STEPS 24\n#if STEPS > 99\n#endif", &named, false),
        ("#define STEPS (12 * 2)", &named, false),
        ("const int STEPS = 12 * 2;", &named, false),
    ] {
        let march = format!("{definition}\n{march}");
        let scratch = Scratch::new(&[("a.glsl", &shader(STEEP[2], [&march, LIGHT]))]);
        let found = lint(&scratch, &["--unsafe-fixes"]);
        let fixed = scratch.read("a.glsl");
        let raised = definition.replace("24", "120");
        let is_fixed = fixed.contains("t += d * 0.2;") && fixed.contains(&raised);
        assert_eq!(is_fixed, is_raised, "{definition}\n{found}\n{fixed}");
        let is_advised = found.contains("the number of steps by 5");
        assert_eq!(is_advised, !is_raised, "{definition}\n{found}");
    }
}

#[test]
fn glow_volumes_and_soft_shadows_are_not_holes() {
    let glow = PARAMETER
        .replace("vec2 march", "float glow;\nvec2 march")
        .replace("t += d;", "t += d; glow += 0.02 / (0.1 + abs(d));");
    let volume = PARAMETER
        .replace("t += d;", "t += 0.05 + 0.5 * abs(d);")
        .replace(
            "if (d < 0.001) return vec2(t, 1.0);",
            "sum += exp(-4.0 * abs(d)) * (1.0 - sum); if (sum > 0.99) return vec2(t, 1.0);",
        );
    let volume = volume.replace("float t = 0.0;", "float t = 0.0, sum = 0.0;");
    for march in [&glow, &volume] {
        let scratch = Scratch::new(&[("a.glsl", &shader(STEEP[0], [march, LIGHT]))]);
        let found = lint(&scratch, &[]);
        assert!(!found.contains("steps over"), "{found}");
        assert_eq!(rays(&scratch), []);
    }
    let soft = "float light(vec3 p) {
        float t = 0.02, res = 1.0;
        for (int i = 0; i < 60; i++) {
            float h = map(p + vec3(0.4, 0.9, 0.1) * t);
            res = min(res, 8.0 * h / t);
            t += clamp(h, 0.01, 0.5);
            if (res < 0.001 || t > 5.0) break;
        }
        return clamp(res, 0.2, 1.0);
    }";
    let text = shader(GENTLE[4], [PARAMETER, soft]);
    let found = lint(&Scratch::new(&[("a.glsl", &text)]), &[]);
    assert!(!found.contains("steps over"), "{found}");
}

#[test]
fn holes_in_shadows_are_reported() {
    let hard = "float light(vec3 p) {
        float t = 0.1;
        for (int i = 0; i < 60; i++) {
            float h = steep(p + vec3(0.41, 0.9, 0.1) * t);
            if (h < 0.001) return 0.2;
            t += h;
            if (t > 8.0) break;
        }
        return 1.0;
    }";
    let steep = "float steep(vec3 p) { return 3.0 * length(p - vec3(0.5, 2.0, 0.0)) - 2.4; }\n";
    let text = steep.to_string() + &shader("return p.y + 0.5;", [PARAMETER, hard]);
    let scratch = Scratch::new(&[("a.glsl", &text)]);
    let found = lint(&scratch, &[]);
    assert!(
        found.contains("shadow loop steps over the surface"),
        "{found}"
    );
    let rows = rays(&scratch);
    assert!(rows[0].0 == 0.0 && rows[1].0 > 0.01, "{rows:?}");
}

#[test]
fn heatmaps_show_slopes_of_distance_fields() {
    let reds = |scene: &str| {
        let text = shader(scene, [PARAMETER, LIGHT]);
        let scratch = Scratch::new(&[("a.glsl", &text)]);
        let args = [
            "run",
            "a.glsl",
            "--size",
            "96x54",
            "--heatmap",
            "slope",
            "-o",
            "s.png",
        ];
        let ran = scratch.run(&args);
        assert_eq!(ran.code, 0, "{}", ran.err);
        let (width, height, pixels) = super::run::pixels(&scratch, "s.png");
        assert_eq!((width, height), (96, 70));
        let image = pixels.iter().take(96 * 54);
        image.filter(|[r, _, b]| r > b).count()
    };
    assert_eq!(reds(GENTLE[0]), 0);
    assert!(reds(STEEP[1]) > 500);
    let scratch = Scratch::new(&[(
        "a.glsl",
        "void mainImage(out vec4 o, in vec2 p) { o = vec4(1.0); }",
    )]);
    let ran = scratch.run(&["run", "a.glsl", "--heatmap", "slope", "-o", "s.png"]);
    assert_eq!(ran.code, 2);
    assert!(
        ran.err.contains("no loop follows rays from the camera"),
        "{}",
        ran.err
    );
}

/// What lints a shader with the rule about needlessly short steps.
const SHORT_STEPS: [&str; 6] = [
    "a.glsl",
    "--run-samples",
    "4096",
    "--only",
    "short-steps",
    "--info",
];

#[test]
fn unnecessarily_short_steps_are_lengthened() {
    let lint = |scratch: &Scratch| {
        scratch.run(&[&SHORT_STEPS[..], &["--unsafe-fixes"]].concat());
        scratch.read("a.glsl")
    };
    let with = |march: &str, from: &str, to: &str, scene: usize| {
        let text = shader(GENTLE[scene], [&march.replace(from, to), LIGHT]);
        Scratch::new(&[("a.glsl", &text)])
    };
    for (step, fixed) in [
        ("t += d * 0.4;", "t += d;"),
        ("t += 0.4 * d;", "t += d;"),
        ("t += d / 2.5;", "t += d;"),
        ("t += 0.8 * d * 0.5;", "t += 2.0 * d * 0.5;"),
    ] {
        let scratch = with(PARAMETER, "t += d;", step, 3);
        let report = || {
            let size = ["--size", "96x54", "--time", "1", "--report"];
            scratch.run(&[&["run", "a.glsl"], &size[..]].concat()).out
        };
        let out = report();
        let line = "steps could be 2.5 times as long: 6 instead of 15 iterations per ray";
        assert!(out.contains(line), "{step}: {out}");
        let text = lint(&scratch);
        assert!(text.contains(fixed), "{step}: {text}");
        assert!(!report().contains("as long"));
    }
    assert!(lint(&with(POINT, "rd * d * 0.9", "rd * 0.5 * d", 0)).contains("p += rd * d;"));
}

#[test]
fn short_steps_that_the_scene_requires_are_kept() {
    let half = PARAMETER.replace("t += d;", "t += 0.5 * d;");
    let glow = half
        .replace("vec2 march", "float glow;\nvec2 march")
        .replace(
            "t += 0.5 * d;",
            "t += 0.5 * d; glow += 0.02 / (0.1 + abs(d));",
        );
    let steps = half
        .replace("float t = 0.0;", "float t = 0.0, n = 0.0;")
        .replace("t += 0.5 * d;", "t += 0.5 * d; n += 0.03;")
        .replace("vec2(t, 1.0)", "vec2(n, 1.0)");
    for (scene, march) in [(STEEP[3], &half), (GENTLE[3], &glow), (GENTLE[3], &steps)] {
        let scratch = Scratch::new(&[("a.glsl", &shader(scene, [march, LIGHT]))]);
        let found = scratch.run(&SHORT_STEPS);
        assert!(!found.out.contains("as long"), "{}", found.out);
    }
}
