//! `--fix`, `--unsafe-fixes` and `--diff`.

use crate::scratch::{BROKEN, CLEAN, Scratch, WARNED, after_fix};
use std::fs;

#[test]
fn safe_fixes_are_applied_until_none_is_left() {
    let scratch = Scratch::new(&[("a.glsl", BROKEN), ("b.glsl", CLEAN)]);
    let ran = scratch.run(&["--fix", "."]);
    assert_eq!(
        (ran.code, ran.out.as_str()),
        (
            0,
            "All checks passed (2 shaders in 2 files); fixed 2 findings\n"
        )
    );
    assert_eq!(scratch.read("a.glsl"), after_fix());
    let again = scratch.run(&["-q", "--fix", "."]);
    assert_eq!((again.code, again.out.as_str()), (0, ""));
    assert_eq!(scratch.read("a.glsl"), after_fix());
}

#[test]
fn verbose_output_shows_how_fixes_were_verified() {
    let code = "void mainImage(out vec4 c, in vec2 p) {\n    vec3 v = vec3(p, iTime);\n    v = v;\n    c = vec4(v, 1.0);\n}\n";
    let scratch = Scratch::new(&[("a.glsl", code)]);
    let ran = scratch.run(&["-v", "--fix", "a.glsl"]);
    let reported = "shaderlint: a.glsl: fixed: 1 with identical sampled pixels\n";
    assert!(ran.err.starts_with(reported), "{}", ran.err);
    assert_eq!(scratch.read("a.glsl"), code.replace("    v = v;\n", ""));
}

#[test]
fn a_fix_can_enable_another() {
    // The error hides findings of rules, which need a valid shader.
    let code = "void mainImage(out vec4 c, in vec2 p) {\n    float a = 1;\n    float unused = a;\n    c = vec4(p, a, 1.0);\n}\n";
    let scratch = Scratch::new(&[("a.glsl", code)]);
    let ran = scratch.run(&["--info", "--unsafe-fixes", "a.glsl"]);
    assert_eq!(
        ran.out,
        "All checks passed (1 shader in 1 file); fixed 2 findings\n"
    );
    let fixed = "void mainImage(out vec4 c, in vec2 p) {\n    float a = 1.0;\n    c = vec4(p, a, 1.0);\n}\n";
    assert_eq!(scratch.read("a.glsl"), fixed);
}

/// A name is replaced in the macros that use it, at its own place.
#[test]
fn names_in_macros_are_renamed() {
    let code = "#define time iGlobalTime\n#define id(x) x\nvoid mainImage(out vec4 c, in vec2 p) {\n    \
        c = vec4(sin(time), cos(time), id(iGlobalTime), iGlobalTime);\n}\n";
    let scratch = Scratch::new(&[("a.glsl", code)]);
    let ran = scratch.run(&["--fix", "a.glsl"]);
    assert_eq!(ran.code, 0, "{}", ran.out);
    assert_eq!(scratch.read("a.glsl"), code.replace("iGlobalTime", "iTime"));
}

#[test]
fn unsafe_fixes_require_an_option() {
    let code = "void mainImage(out vec4 c, in vec2 p) {\n    float a = acos(iTime * 2.0 + 3.0);\n    c = vec4(a);\n}\n";
    let scratch = Scratch::new(&[("a.glsl", code)]);
    let reported = scratch.run(&["a.glsl"]).out;
    assert!(
        reported.ends_with("Found 1 warning (1 shader in 1 file); 1 fixable with --unsafe-fixes\n"),
        "{reported}"
    );
    scratch.run(&["--fix", "a.glsl"]);
    assert_eq!(scratch.read("a.glsl"), code);
    let ran = scratch.run(&["--unsafe-fixes", "a.glsl"]);
    assert_eq!(
        ran.out,
        "All checks passed (1 shader in 1 file); fixed 1 finding\n"
    );
    assert!(
        scratch
            .read("a.glsl")
            .contains("acos(clamp(iTime * 2.0 + 3.0, -1.0, 1.0))")
    );
}

#[test]
fn a_diff_writes_nothing() {
    let scratch = Scratch::new(&[("src/a.glsl", BROKEN)]);
    let ran = scratch.run(&["--diff", "src"]);
    let diff = "\
--- a/src/a.glsl
+++ b/src/a.glsl
@@ -1,7 +1,7 @@
 // größe 𝄞
-float halfOf(float x) { return x / 2; }
+float halfOf(float x) { return x / 2.0; }
 
 void mainImage(out vec4 fragColor, in vec2 fragCoord) {
-    /* 𝄞é */ float a = 1;
+    /* 𝄞é */ float a = 1.0;
     fragColor = vec4(halfOf(a));
 }
";
    assert_eq!((ran.code, ran.out.as_str()), (1, diff));
    assert_eq!(scratch.read("src/a.glsl"), BROKEN);
    let both = scratch.run(&["--fix", "--diff", "src"]);
    assert_eq!(both.out, diff);
    assert_eq!(scratch.read("src/a.glsl"), BROKEN);
}

#[test]
fn fixed_standard_input_is_printed() {
    let scratch = Scratch::new(&[]);
    let ran = scratch.pipe(BROKEN, &["--fix", "-"]);
    assert_eq!((ran.code, ran.out), (0, after_fix()));
    let ran = scratch.pipe(CLEAN, &["--fix", "-"]);
    assert_eq!(
        (ran.code, ran.out.as_str(), ran.err.as_str()),
        (0, CLEAN, "")
    );
    // The remaining findings are not mixed with the text.
    let ran = scratch.pipe(WARNED, &["--fix", "-", "--stdin-filename", "x/a.glsl"]);
    assert_eq!(ran.out, WARNED);
    assert!(
        ran.err
            .starts_with("x/a.glsl:2:22: warning[pow-negative-base]"),
        "{}",
        ran.err
    );
    let ran = scratch.pipe(BROKEN, &["--diff", "-"]);
    assert!(ran.out.starts_with("--- a/stdin.glsl\n"), "{}", ran.out);
}

#[test]
fn line_breaks_are_preserved() {
    let crlf = BROKEN.replace('\n', "\r\n");
    let scratch = Scratch::new(&[("a.glsl", &crlf)]);
    assert_eq!(scratch.run(&["--fix", "a.glsl"]).code, 0);
    assert_eq!(scratch.read("a.glsl"), after_fix().replace('\n', "\r\n"));
    // Lines inserted by a fix end like the other lines of the file.
    let code = "#version 300 es\r\nout vec4 c;\r\nvoid main() {\r\n    c = vec4(1.0);\r\n}\r\n";
    scratch.write("b.frag", code);
    scratch.run(&["--unsafe-fixes", "b.frag"]);
    let fixed = scratch.read("b.frag");
    assert!(fixed.contains("precision "), "{fixed}");
    assert_eq!(
        fixed.matches('\n').count(),
        fixed.matches("\r\n").count(),
        "{fixed:?}"
    );
}

#[cfg(unix)]
#[test]
fn symbolic_links_and_modes_of_fixed_files_are_preserved() {
    use std::os::unix::fs::{PermissionsExt, symlink};
    let scratch = Scratch::new(&[("real/a.glsl", BROKEN), ("locked.glsl", BROKEN)]);
    let mode = |name: &str, mode: u32| {
        fs::set_permissions(scratch.path(name), fs::Permissions::from_mode(mode)).unwrap();
    };
    mode("real/a.glsl", 0o640);
    mode("locked.glsl", 0o444);
    symlink("real/a.glsl", scratch.path("link.glsl")).unwrap();
    assert_eq!(scratch.run(&["--fix", "link.glsl"]).code, 0);
    assert!(scratch.path("link.glsl").is_symlink());
    assert_eq!(scratch.read("real/a.glsl"), after_fix());
    let metadata = fs::metadata(scratch.path("real/a.glsl")).unwrap();
    assert_eq!(metadata.permissions().mode() & 0o777, 0o640);
    let ran = scratch.run(&["--fix", "locked.glsl"]);
    assert_eq!(ran.code, 2);
    assert!(
        ran.err
            .contains("locked.glsl: cannot write the fixes: the file is read-only")
    );
    assert!(
        ran.out.contains("Found 2 errors (1 shader in 1 file)"),
        "{}",
        ran.out
    );
    assert_eq!(scratch.read("locked.glsl"), BROKEN);
    let left: Vec<_> = fs::read_dir(scratch.path("")).unwrap().collect();
    assert_eq!(left.len(), 3, "no temporary file is left");
}

const MAIN: &str =
    "void mainImage(out vec4 c, in vec2 p) { c = vec4(p, 0.0, 1.0); float a = 1; c.x = a; }";

#[test]
fn shaders_inside_other_files_are_fixed_in_place() {
    let fixed = MAIN.replace("= 1;", "= 1.0;");
    let texts = [
        (
            "a.html",
            "<p>1;</p>\n<script type=\"x-shader/x-fragment\">@</script>\n",
        ),
        ("a.js", "let a = 1;\nconst s = /* glsl */ `\n@\n`;\n"),
        ("b.ts", "let a = 1;\nconst s: string = glsl`@`;\n"),
        ("a.md", "A text: a = 1;\n\n```glsl\n@\n```\n"),
    ];
    for (name, text) in texts {
        let scratch = Scratch::new(&[(name, &text.replace('@', MAIN))]);
        let ran = scratch.run(&["--fix", name]);
        assert_eq!(ran.code, 0, "{name}: {}", ran.out);
        assert_eq!(scratch.read(name), text.replace('@', &fixed));
    }
}

#[test]
fn quoted_strings_stay_quoted() {
    let text = "const s = \"#version 300 es\\nprecision highp float;\\nout vec4 c;\\nvoid main() { float a = 1; c = vec4(a); }\";\n";
    let scratch = Scratch::new(&[("a.js", text)]);
    scratch.run(&["--fix", "a.js"]);
    assert_eq!(scratch.read("a.js"), text.replace("a = 1;", "a = 1.0;"));
}

#[test]
fn exports_are_fixed_in_place() {
    let code = format!("// \"quoted\" \u{e9}\r\n{MAIN}");
    let pass = serde_json::json!({"type": "image", "name": "Image", "code": code, "inputs": [], "outputs": []});
    let export = serde_json::json!({"info": {"name": "x = 1;"}, "renderpass": [pass]}).to_string();
    let export = format!("[ {} ]\n", export.replace('\u{e9}', "\\u00e9"));
    let scratch = Scratch::new(&[("a.json", &export)]);
    let plain = scratch.run(&["a.json"]).out;
    let promise = "\nFound 1 error (1 shader in 1 file); 1 fixable with --fix\n";
    assert!(plain.contains(promise), "{plain}");
    let fixed = export.replace("a = 1;", "a = 1.0;");
    let piped = scratch.pipe(&export, &["--fix", "-", "--stdin-filename", "a.json"]);
    assert_eq!(piped.out, fixed);
    let ran = scratch.run(&["--fix", "a.json"]);
    assert_eq!(
        (ran.code, ran.out.as_str()),
        (
            0,
            "All checks passed (1 shader in 1 file); fixed 1 finding\n"
        )
    );
    assert_eq!(scratch.read("a.json"), fixed);
}

#[test]
fn errors_uncovered_by_fixes_are_fixed() {
    let code = "void mainImage(out vec4 c, in vec2 p) {\n    float a = 0; float b = max(a, 0); vec3 v = a;\n    c = vec4(v, b);\n}\n";
    let scratch = Scratch::new(&[("a.glsl", code)]);
    let reported = scratch.run(&["a.glsl"]).out;
    let ran = scratch.run(&["--fix", "a.glsl"]);
    let fixed = scratch.read("a.glsl");
    assert!(
        fixed.contains("float a = 0.0; float b = max(a, 0.0);"),
        "{fixed}"
    );
    let summary = ran.out.split("; fixed ").nth(1);
    let count = summary.unwrap().split(' ').next().unwrap();
    assert!(
        reported.contains(&format!("; {count} fixable with --fix")),
        "{reported}"
    );
}

#[test]
fn comments_remain_when_code_is_removed() {
    let code = "void mainImage(out vec4 c, in vec2 p) {\n    float unused = 2.0; // why\n    float other /* what */ = 1.0;\n    c = vec4(1.0);\n}\n";
    let scratch = Scratch::new(&[("a.glsl", code)]);
    scratch.run(&["--info", "--unsafe-fixes", "a.glsl"]);
    assert_eq!(
        scratch.read("a.glsl"),
        code.replace("float unused = 2.0; ", "")
    );
}

#[test]
fn fixed_findings_of_included_files_are_not_reported() {
    let common = "float one() { float a = 1; return a; }\n";
    let image =
        "#include \"common.glsl\"\nvoid mainImage(out vec4 c, in vec2 p) { c = vec4(one()); }\n";
    let scratch = Scratch::new(&[("a.glsl", image), ("common.glsl", common)]);
    let ran = scratch.run(&["--fix", "a.glsl", "common.glsl"]);
    let message = "All checks passed (2 shaders in 2 files); fixed 1 finding\n";
    assert_eq!((ran.code, ran.out.as_str()), (0, message));
}

#[test]
fn included_files_are_fixed_only_when_checked_themselves() {
    let common = "float one() { float a = 1; return a; }\n";
    let image =
        "#include \"common.glsl\"\nvoid mainImage(out vec4 c, in vec2 p) { c = vec4(one()); }\n";
    let scratch = Scratch::new(&[("a.glsl", image), ("common.glsl", common)]);
    let reported = scratch.run(&["a.glsl"]).out;
    assert!(
        reported.contains("\nFound 1 error (1 shader in 1 file)\n"),
        "{reported}"
    );
    scratch.run(&["--fix", "a.glsl"]);
    assert_eq!(scratch.read("a.glsl"), image);
    assert_eq!(scratch.read("common.glsl"), common);
    scratch.run(&["--fix", "common.glsl"]);
    assert_eq!(scratch.run(&["-q", "a.glsl"]).out, "");
}
