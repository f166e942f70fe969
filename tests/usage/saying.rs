//! Messages of a run besides its findings: summaries, `-v` and `-q`, exit codes, and output limits.

use crate::scratch::{BROKEN, CLEAN, Scratch, WARNED};
use serde_json::Value;

#[test]
fn every_run_prints_a_summary() {
    let scratch = Scratch::new(&[
        ("a.glsl", CLEAN),
        ("b.glsl", CLEAN),
        ("c.js", "let a = 1;\n"),
    ]);
    let out = |args: &[&str]| scratch.run(args).out;
    assert_eq!(out(&["a.glsl"]), "All checks passed (1 shader in 1 file)\n");
    // Without a path the current folder is checked.
    assert_eq!(out(&[]), "All checks passed (2 shaders in 2 of 3 files)\n");
    assert_eq!(out(&["c.js"]), "No shaders found in 1 file\n");
    assert_eq!(out(&["-q"]), "");
    scratch.write("a.glsl", BROKEN);
    scratch.write("b.glsl", WARNED);
    assert!(
        out(&[]).ends_with(
            "\nFound 2 errors, 1 warning (2 shaders in 2 of 3 files); 2 fixable with --fix; 1 more info: --info\n\
         Not fully checked: 2 functions (-v lists them)\n"
        ),
        "{}",
        out(&[])
    );
    let ran = scratch.run(&["-qq"]);
    assert_eq!((ran.code, ran.out.as_str(), ran.err.as_str()), (1, "", ""));
    let ran = scratch.run(&["-qq", "missing.glsl"]);
    assert_eq!((ran.code, ran.out.as_str(), ran.err.as_str()), (2, "", ""));
    assert_eq!(scratch.run(&["-q", "-v"]).code, 2);
}

#[test]
fn verbose_output_lists_read_and_skipped_files() {
    let scratch = Scratch::new(&[
        ("shaderlint.toml", "exclude = [\"out\"]"),
        ("a.glsl", CLEAN),
        (
            "b.vert",
            "#version 300 es\nvoid main() { gl_Position = vec4(1); }\n",
        ),
        ("out/c.glsl", CLEAN),
        ("notes.txt", ""),
        ("package.json", "{}"),
    ]);
    let ran = scratch.run(&["-v"]);
    let lines: Vec<&str> = ran.err.lines().collect();
    for line in [
        "shaderlint: a.glsl: checked as ShaderToy image; shaderlint.toml",
        "shaderlint: b.vert: checked as vertex shader, GLSL ES 3.00; shaderlint.toml",
        "shaderlint: out/c.glsl: skipped: excluded by the configuration",
    ] {
        assert!(lines.contains(&line), "{line} in {lines:#?}");
    }
    assert!(ran.err.contains("package.json: skipped: "), "{}", ran.err);
    assert!(ran.err.contains("(.toml, .txt)"), "{}", ran.err);
    assert_eq!(ran.out, "All checks passed (2 shaders in 2 files)\n");
}

/// Rules skip a function with errors; their findings elsewhere are the same as without errors.
#[test]
fn rules_run_in_functions_without_errors() {
    let code = "\
float helper(float x) { return x; }
float idle(float x) { return x; }
float sharp(float x) { return x == 0.5 ? 1.0 : pow(iTime - 9.0, 2.0); }
float power(float x) { return pow(x, 0.5); }
const float LEVEL = 2.0;
void mainImage(out vec4 c, in vec2 p) {
    float unused = 1.0;
    c = vec4(helper(power(p.x)) + sharp(p.y * 0.3) * LEVEL + 1);
}
";
    let scratch = Scratch::new(&[("a.glsl", code)]);
    assert_eq!(
        scratch.places(&["a.glsl"]),
        [
            "8:62 int-float-mix",
            "3:31 float-equality",
            "3:52 pow-negative-base",
        ]
    );
    let ran = scratch.run(&["-v", "a.glsl"]);
    let last = ran.out.lines().last().unwrap();
    assert_eq!(last, "Rules skipped 1 function with errors: `mainImage`");
    let ran = scratch.run(&["a.glsl"]);
    let last = ran.out.lines().last().unwrap();
    assert_eq!(last, "Not fully checked: 1 function (-v lists them)");
    // An error outside all functions disables all rules.
    scratch.write("a.glsl", format!("{code}}}\n"));
    let ran = scratch.run(&["-v", "a.glsl"]);
    let last = ran.out.lines().last().unwrap();
    assert_eq!(last, "Rules skipped 1 shader with errors outside functions");
}

#[test]
fn suppressions_in_broken_code_are_not_reported_as_unused() {
    let code = "void mainImage(out vec4 c, in vec2 p) {\n\
        c = vec4(pow(iTime - 9.0, 2.0)) + nothing; // shaderlint: allow(pow-negative-base)\n}\n";
    let scratch = Scratch::new(&[("a.glsl", code)]);
    assert_eq!(scratch.places(&["a.glsl"]), ["2:35 undeclared-name"]);
}

#[test]
fn only_selected_rules_are_reported() {
    let scratch = Scratch::new(&[("a.glsl", WARNED), ("b.glsl", BROKEN)]);
    let only = |names: &str| scratch.places(&["--only", names, "."]);
    assert_eq!(only("pow-negative-base"), ["2:22 pow-negative-base"]);
    assert_eq!(only("tidy"), ["3:11 unused-variable"]);
    assert_eq!(only("tidy,int-float-mix").len(), 3);
    // A rule that is off runs if it is named.
    assert_eq!(only("unused-parameter"), ["1:42 unused-parameter"; 0]);
    let ran = scratch.run(&["--only", "tidy", "."]);
    assert_eq!(ran.code, 0);
    assert!(ran.out.contains("2 errors hidden by --only"), "{}", ran.out);
    let ran = scratch.run(&["--only", "int-flaot-mix", "."]);
    assert_eq!(ran.code, 2);
    assert!(
        ran.err.contains("did you mean `int-float-mix`?"),
        "{}",
        ran.err
    );
    assert_eq!(
        scratch
            .run(&["--only", "tidy", "--ignore", "look", "."])
            .code,
        2
    );
    // Only the selected findings are fixed.
    scratch.run(&["--unsafe-fixes", "--only", "tidy", "."]);
    assert_eq!(scratch.read("b.glsl"), BROKEN);
    assert!(!scratch.read("a.glsl").contains("unused"));
}

#[test]
fn the_exit_code_has_a_threshold() {
    let scratch = Scratch::new(&[("a.glsl", WARNED), ("b.glsl", BROKEN), ("c.glsl", CLEAN)]);
    let code = |args: &[&str]| scratch.run(args).code;
    assert_eq!(code(&["a.glsl"]), 0);
    assert_eq!(code(&["--max-warnings", "0", "a.glsl"]), 1);
    assert_eq!(code(&["--max-warnings", "1", "a.glsl"]), 0);
    assert_eq!(code(&["--deny-warnings", "a.glsl"]), 1);
    assert_eq!(code(&["--deny-warnings", "c.glsl"]), 0);
    assert_eq!(
        code(&["--deny-warnings", "--max-warnings", "1", "a.glsl"]),
        2
    );
    assert_eq!(code(&["--max-warnings", "x", "a.glsl"]), 2);
    assert_eq!(code(&["--exit-zero", "b.glsl"]), 0);
    assert_eq!(code(&["--exit-zero", "--deny-warnings", "a.glsl"]), 0);
    assert_eq!(code(&["--exit-zero", "missing.glsl"]), 2);
}

#[test]
fn rules_can_be_configured_to_fail_the_run() {
    let scratch = Scratch::new(&[("a.glsl", WARNED)]);
    let run = |config: &str| {
        scratch.write("shaderlint.toml", config);
        scratch.run(&["a.glsl"])
    };
    let rule = "[rules]\npow-negative-base = { fail = true }";
    let ran = run(rule);
    assert_eq!(ran.code, 1);
    assert!(
        ran.out.contains("warning[pow-negative-base]"),
        "{}",
        ran.out
    );
    assert!(
        ran.out
            .contains("Failed because of 1 finding of `pow-negative-base` (`fail = true`)"),
        "{}",
        ran.out
    );
    assert_eq!(scratch.run(&["--ignore", "numeric", "a.glsl"]).code, 0);
    assert_eq!(
        run("[rules]\ntidy = { level = \"info\", fail = true }").code,
        1
    );
    assert_eq!(
        run("[rules]\nall = { fail = true }\nnumeric = { fail = false }\ntidy = \"off\"").code,
        0
    );
    assert_eq!(run("[rules]\nlook = { fail = true }").code, 0);
    let ran = run("[rules]\nlook = { fail = 1 }");
    assert_eq!(ran.code, 2);
    assert!(
        ran.err.contains("expected `true` or `false`"),
        "{}",
        ran.err
    );
}

#[test]
fn the_more_specific_selection_applies() {
    let scratch = Scratch::new(&[("a.glsl", WARNED)]);
    let found = |args: &[&str]| scratch.places(&[args, &["a.glsl"]].concat());
    let pow = ["2:22 pow-negative-base"];
    assert_eq!(found(&["--ignore", "all", "--select", "numeric"]), pow);
    assert_eq!(
        found(&["--ignore", "numeric,tidy", "--select", "pow-negative-base"]),
        pow
    );
    assert_eq!(
        found(&["--select", "numeric", "--ignore", "pow-negative-base,tidy"]),
        [""; 0]
    );
    scratch.write(
        "shaderlint.toml",
        "[rules]\npow-negative-base = \"warning\"\nall = \"off\"",
    );
    assert_eq!(found(&[]), pow);
}

/// A shader with this many errors in as many lines.
fn many(count: usize) -> String {
    let line = "    c.x += 1;\n";
    let lines = line.repeat(count);
    format!(
        "float f() {{ return vec2(iTime); }}\nvoid mainImage(out vec4 c, in vec2 p) {{\n    c = vec4(f());\n{lines}}}\n"
    )
}

#[test]
fn at_most_200_findings_of_a_file_are_printed() {
    let code = format!("```glsl\n{}```\n", many(99)).repeat(3);
    let scratch = Scratch::new(&[("a.md", &code), ("b.glsl", WARNED)]);
    for format in ["human", "short", "agent"] {
        let out = scratch.run(&["--format", format, "."]).out;
        assert!(
            out.contains("\na.md: and 100 more findings\n"),
            "{format}: {out}"
        );
        assert_eq!(out.matches("b.glsl:").count(), 1, "{format}");
    }
    let out = scratch.run(&["."]).out;
    assert!(
        out.contains("300 errors, 1 warning"),
        "all findings are counted: {out}"
    );
    let out = scratch.run(&["--format", "json", "."]).out;
    let all: Value = serde_json::from_str(&out).unwrap();
    assert_eq!(all["summary"]["left_out"], 100);
    assert_eq!(all["summary"]["errors"], 300);
    assert_eq!(all["diagnostics"].as_array().unwrap().len(), 203);
    let out = scratch.run(&["--format", "jsonl", "."]).out;
    let more = out.lines().find(|l| l.contains("more-findings")).unwrap();
    let more: Value = serde_json::from_str(more).unwrap();
    assert_eq!(more["message"], "and 100 more findings");
    for format in ["sarif", "gitlab"] {
        let out = scratch.run(&["--format", format, "."]).out;
        serde_json::from_str::<Value>(&out).unwrap();
        assert!(out.contains("and 100 more findings"), "{format}");
    }
    for format in ["junit", "checkstyle"] {
        let out = scratch.run(&["--format", format, "."]).out;
        roxmltree::Document::parse(&out).unwrap();
        assert!(out.contains("and 100 more findings"), "{format}");
    }
}

#[test]
fn rules_and_errors_are_listed_as_json() {
    let out = Scratch::new(&[]).run(&["rules", "--format", "json"]).out;
    let list: Value = serde_json::from_str(&out).unwrap();
    let all = list["rules"].as_array().unwrap();
    let errors = shaderlint::diagnostic::ERRORS;
    assert_eq!(all.len(), shaderlint::rules::RULES.len() + errors.len());
    for entry in all {
        for key in ["name", "kind", "severity", "summary", "page"] {
            assert!(
                entry[key].as_str().is_some_and(|t| !t.is_empty()),
                "{entry}"
            );
        }
        let page = crate::scratch::root().join(entry["page"].as_str().unwrap());
        assert!(page.is_file(), "{entry}");
    }
    let budget = all.iter().find(|e| e["name"] == "step-budget").unwrap();
    assert_eq!(budget["group"], "budget");
    assert_eq!(budget["options"][0]["name"], "main");
}

#[test]
fn the_agent_format_has_one_line_per_finding() {
    let code = "float half(float x) { return x / 2; }\nvoid mainImage(out vec4 c, in vec2 p) {\n    float unused = 1.0;\n    c = vec4(p, 0.0, 1.0)\n}\n";
    let scratch = Scratch::new(&[("a.glsl", code), ("b.glsl", WARNED)]);
    let ran = scratch.run(&["--format", "agent", "--info", "-q", "."]);
    let lines: Vec<&str> = ran.out.lines().collect();
    for line in &lines[..lines.len() - 2] {
        assert!(
            line.starts_with("a.glsl:") || line.starts_with("b.glsl:"),
            "{line}"
        );
    }
    assert!(ran.out.contains("; insert `;`"), "{}", ran.out);
    assert!(
        ran.out
            .contains("`unused` is never used; unsafe delete line 3"),
        "{}",
        ran.out
    );
    assert!(ran.out.contains(" (2 shaders in 2 files)"), "{}", ran.out);
}
