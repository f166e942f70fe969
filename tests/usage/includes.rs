//! Included files, and ShaderToy passes in separate files.

use crate::scratch::Scratch;

/// A file with a function.
const F: &str = "vec2 f() { return vec2(1.0); }\n";

/// A shader that calls it incorrectly: the error is reported if the file is found.
fn calling(directive: &str) -> String {
    format!(
        "{directive}\nvoid mainImage(out vec4 c, in vec2 p) {{ float x = f(); c = vec4(x); }}\n"
    )
}

/// The rules of the findings in `a.glsl`.
#[track_caller]
fn rules(scratch: &Scratch, args: &[&str]) -> Vec<String> {
    let places = scratch.places(args);
    let rule = |p: &String| p.split(' ').nth(1).unwrap().to_string();
    places.iter().map(rule).collect()
}

/// Checks that a directive in `src/x/a.glsl` finds a file.
#[track_caller]
fn finds(file: &str, directive: &str) {
    let scratch = Scratch::new(&[(file, F), ("src/x/a.glsl", &calling(directive))]);
    let found = rules(&scratch, &["src/x/a.glsl"]);
    assert_eq!(found, ["vector-size"], "{directive}");
}

#[test]
fn includes_are_resolved_as_in_bundlers() {
    finds("src/x/f.glsl", "#include \"f.glsl\"");
    finds("src/x/f.glsl", "#include './f.glsl';");
    finds("src/x/f.glsl", "#include f");
    finds("src/x/f.frag", "#include ./f;");
    finds("src/x/f/index.glsl", "#include \"./f\"");
    finds("src/x/f.glsl", "#include <f>");
    finds("src/x/f.glsl", "#import \"f.glsl\"");
    finds("src/x/f.glsl", "#pragma include \"f.glsl\"");
    finds("math/f.glsl", "#include \"../../math/f.glsl\"");
    finds("math/f.glsl", "#include \"/math/f.glsl\" /* one\nmore */");
    finds(
        "node_modules/pkg/math/f.glsl",
        "#include \"pkg/math/f.glsl\"",
    );
    finds("node_modules/pkg/math/f.glsl", "#include \"~pkg/math/f\"");
    finds("src/node_modules/@a/pkg/f.glsl", "#include <@a/pkg/f>");
}

#[test]
fn includes_are_found_by_the_end_of_their_path() {
    finds("lib/core/f.glsl", "#include <core/f>");
    finds("lib/core/gpu/f.glsl", "#include \"core/f.glsl?raw\"");
    finds("lib/f.module.glsl", "#pragma include <f>");
    finds(
        "lib/shaders/f.frag.glsl",
        "@import ../../../shaders/f.frag;",
    );
    finds("packages/pkg/lib/f.vert", "@import ./pkg/f");
    finds("lib/math/f.glsl", "#import \"@pkg/math/f\"");
    finds(
        "packages/pkg/src/math/f.glsl",
        "#pragma import \"@a/pkg/dist/math/f.glsl\"",
    );
    for (file, directive) in [
        // A chunk is code for any stage.
        ("lib/f.frag", "#include <f>"),
        ("lib/f.glsl", "#include \"core/f\""),
        ("lib/gpu/core/f.glsl", "#include \"core/gpu/f\""),
        ("lib/f.glsl", "#include \"f.frag\""),
        ("dist/f.glsl", "#include \"f\""),
        // A chunk of three.js.
        ("lib/common.glsl", "#include <common>"),
    ] {
        let scratch = Scratch::new(&[(file, F), ("src/x/a.glsl", &calling(directive))]);
        assert_eq!(scratch.run(&["-q", "src/x/a.glsl"]).code, 0, "{directive}");
    }
}

#[test]
fn one_of_several_files_is_included_only_if_all_are_the_same() {
    let shader = calling("#include \"f\"");
    let scratch = Scratch::new(&[("a/f.glsl", F), ("b/f.glsl", F), ("c/a.glsl", &shader)]);
    assert_eq!(rules(&scratch, &["c/a.glsl"]), ["vector-size"]);
    // The cache notices files anywhere.
    scratch.write("b/f.glsl", "vec3 f() { return vec3(1.0); }\n");
    assert_eq!(rules(&scratch, &["c/a.glsl"]), ["undeclared-name"]);
    // Findings there are those without the shader, which its program completes.
    let wrong = "vec2 f() { return vec2(1.0, true, 2); }\n";
    let scratch = Scratch::new(&[("a/f.glsl", wrong), ("c/a.glsl", &shader)]);
    assert_eq!(rules(&scratch, &["c/a.glsl"]), ["vector-size"]);
    // No file includes itself.
    let scratch = Scratch::new(&[("c/f.glsl", &shader.replace("\"f\"", "\"d/f\""))]);
    assert_eq!(scratch.run(&["-q", "c/f.glsl"]).code, 0);
}

#[test]
fn missing_includes_are_not_errors() {
    let missing = calling("#include \"nowhere.glsl\"");
    let scratch = Scratch::new(&[("a.glsl", &missing)]);
    assert_eq!(scratch.run(&["-q", "a.glsl"]).code, 0);
    let outside = calling("#include \"../f.glsl\"");
    let scratch = Scratch::new(&[("f.glsl", F), ("in/a.glsl", &outside)]);
    assert_eq!(scratch.run_in("in", &["-q", "a.glsl"]).code, 0);
    let found = scratch.places(&["in/a.glsl"]);
    assert_eq!(
        found.len(),
        1,
        "the current folder contains both: {found:?}"
    );
}

#[test]
fn includes_outside_of_the_folder_require_a_repository() {
    for (mark, text) in [
        (".git/HEAD", ""),
        ("package.json", "{}"),
        ("shaderlint.toml", ""),
    ] {
        let shader = calling("#include \"../f.glsl\"");
        let scratch = Scratch::new(&[("f.glsl", F), ("in/a.glsl", &shader), (mark, text)]);
        let ran = scratch.run_in("in", &["-q", "a.glsl"]);
        assert_eq!(ran.code, 1, "{mark}: {}", ran.out);
    }
    let shader = calling("#include \"../f.glsl\"");
    let scratch = Scratch::new(&[("f.glsl", F), ("in/a.glsl", &shader), ("other/b.txt", "")]);
    let ran = scratch.run_in("other", &["-q", ".."]);
    assert_eq!(ran.code, 1, "{}", ran.out);
}

#[test]
fn include_roots_are_searched() {
    let shader = calling("#include \"math/f.glsl\"");
    let files = [("lib/math/f.glsl", F), ("src/a.glsl", shader.as_str())];
    let scratch = Scratch::new(&files);
    // Without the root, either may be meant.
    scratch.write("gpu/math/f.glsl", "vec3 f() { return vec3(1.0); }");
    assert_eq!(rules(&scratch, &["src/a.glsl"]), ["undeclared-name"]);
    scratch.write("shaderlint.toml", "include_roots = [\"other\", \"lib\"]");
    assert_eq!(rules(&scratch, &["src/a.glsl"]), ["vector-size"]);
    let only = "[[overrides]]\npaths = [\"src\"]\ninclude_roots = [\"lib\"]";
    scratch.write("shaderlint.toml", only);
    assert_eq!(rules(&scratch, &["src/a.glsl"]), ["vector-size"]);
    scratch.write("shaderlint.toml", "include_roots = \"lib\"");
    let ran = scratch.run(&["src/a.glsl"]);
    assert!(ran.err.contains("expected a list"), "{}", ran.err);
}

#[test]
fn files_are_included_once() {
    let a = calling("#include \"b.glsl\"\n#include \"f.glsl\"\n#include \"f.glsl\"");
    let b = "#ifdef X\n#include \"f.glsl\"\n#endif\n#include \"k.glsl\"\n#include \"k.glsl\"\n";
    let k = "const float K = 1.0;\n";
    let scratch = Scratch::new(&[("a.glsl", &a), ("b.glsl", b), ("f.glsl", F), ("k.glsl", k)]);
    assert_eq!(rules(&scratch, &["a.glsl"]), ["vector-size"]);
}

#[test]
fn conditional_includes_of_the_same_file_are_resolved() {
    let a = calling(
        "#define X\n#ifdef X\n#include \"f.glsl\"\n#endif\n#ifndef Y\n#include \"f.glsl\"\n#endif",
    );
    for f in [
        F.to_string(),
        format!("#pragma once\n{F}"),
        format!("#ifndef F\n#define F\n{F}#endif\n"),
    ] {
        let scratch = Scratch::new(&[("a.glsl", &a), ("f.glsl", &f)]);
        assert_eq!(rules(&scratch, &["a.glsl"]), ["vector-size"], "{f}");
    }
    let either = calling("#ifdef X\n#include \"f.glsl\"\n#else\n#include \"f.glsl\"\n#endif");
    let scratch = Scratch::new(&[("a.glsl", &either), ("f.glsl", F)]);
    assert_eq!(rules(&scratch, &["a.glsl"]), ["vector-size"]);
}

#[test]
fn includes_with_different_meanings_are_repeated() {
    let a = "#define T float\n#include \"t.glsl\"\n#undef T\n#define T vec2\n#include \"t.glsl\"\n#undef T\n\
        void mainImage(out vec4 c, in vec2 p) { c = vec4(twice(1.0), twice(p), 1.0); }\n";
    let t = "T twice(T a) { return a * 2.0; }\n";
    let scratch = Scratch::new(&[("a.glsl", a), ("t.glsl", t)]);
    assert_eq!(scratch.places(&["a.glsl"]), [] as [&str; 0]);
    let a = "void mainImage(out vec4 c, in vec2 p) {\n c = vec4(0.0);\n if (p.x < 9.0) {\n#include \"body.glsl\"\n }\n\
        #include \"body.glsl\"\n}\n";
    let scratch = Scratch::new(&[
        ("a.glsl", a),
        ("body.glsl", "vec4 d = vec4(p, p);\nc += d;\n"),
    ]);
    assert_eq!(scratch.places(&["a.glsl"]), [] as [&str; 0]);
}

#[test]
fn circular_includes_without_a_guard_are_errors() {
    let a = calling("#include \"f.glsl\"");
    let f = format!("#include \"g.glsl\"\n{F}");
    let g = "#include \"f.glsl\"\nfloat g() { return 2.0; }\n";
    let scratch = Scratch::new(&[("a.glsl", &a), ("f.glsl", &f), ("g.glsl", g)]);
    let ran = scratch.run(&["-q", "a.glsl"]);
    assert!(ran.out.contains("`f.glsl` includes itself"), "{}", ran.out);
    scratch.write("f.glsl", format!("#pragma once\n{f}"));
    assert_eq!(rules(&scratch, &["a.glsl"]), ["vector-size"]);
    scratch.write("f.glsl", format!("#ifndef F_IN\n#define F_IN\n{f}#endif\n"));
    assert_eq!(rules(&scratch, &["a.glsl"]), ["vector-size"]);
}

#[test]
fn glslify_modules_have_private_names() {
    let a = "#pragma glslify: f = require(./lib)\n#pragma glslify: g = require('pkg', map = scene, n = 3)\n\
        float hash(float p) { return p; }\nfloat scene(float p) { return p; }\n\
        void mainImage(out vec4 c, in vec2 p) { c = vec4(f(p.x), g(p.y), hash(p.x), f(p)); }\n";
    let lib = "#pragma glslify: inner = require(pkg/inner)\nfloat hash(float p) { return inner(p); }\n\
        float noise(float p) { return hash(p); }\n#pragma glslify: export(noise)\n";
    let main = "float hash(float p) { return p * float(n); }\nfloat trace(float p) { return map(hash(p)); }\n\
        #pragma glslify: export(trace)\n";
    let inner = "float hash(float p) { return p; }\n#pragma glslify: export(hash)\n";
    let scratch = Scratch::new(&[
        ("src/a.glsl", a),
        ("src/lib.glsl", lib),
        ("node_modules/pkg/package.json", "{\"main\": \"main\"}"),
        ("node_modules/pkg/main.glsl", main),
        ("node_modules/pkg/inner.glsl", inner),
    ]);
    let ran = scratch.run(&["-q", "src/a.glsl", "--format", "short"]);
    assert_eq!(ran.out.lines().count(), 1, "{}", ran.out);
    assert!(
        ran.out.starts_with("src/a.glsl:5:79: error[vector-size]"),
        "{}",
        ran.out
    );
}

#[test]
fn only_errors_are_reported_for_packages() {
    let a =
        "#include \"pkg/f.glsl\"\nvoid mainImage(out vec4 c, in vec2 p) { c = vec4(f(p.x)); }\n";
    let warned = "float f(float x) { float unused = 1.0; return pow(x - 9.0, 2.0); }\n";
    let file = "node_modules/pkg/f.glsl";
    let scratch = Scratch::new(&[("a.glsl", a), (file, warned)]);
    assert_eq!(scratch.places(&["a.glsl"]), [] as [&str; 0]);
    scratch.write(file, "float f(float x) { return vec2(1.0); }\n");
    assert_eq!(scratch.places(&["a.glsl"]), ["1:20 vector-size"]);
}

#[test]
fn common_code_precedes_the_passes_of_its_folder() {
    let common = "#define K 2.0\nfloat one() { float unused = 1.0; return K; }\n";
    let image = "void mainImage(out vec4 c, in vec2 p) { c = vec4(one()) * K; }\n";
    let scratch = Scratch::new(&[
        ("Common.glsl", common),
        ("Image.glsl", image),
        ("BufferA.glsl", image),
    ]);
    assert_eq!(
        scratch.places(&["Image.glsl", "-q"]),
        ["2:21 unused-variable"]
    );
    let ran = scratch.run(&["--info", "--format", "short"]);
    let unused = ran.out.matches("unused-variable").count();
    assert_eq!((ran.code, unused), (0, 1), "{}", ran.out);
    assert!(ran.out.contains("Common.glsl:2:21: "), "{}", ran.out);
    scratch.write("image.frag", image);
    assert_eq!(
        scratch.run(&["-q", "Image.glsl"]).code,
        1,
        "unrelated image passes"
    );
}

/// `NAME-c.glsl` belongs to `NAME.glsl` and to `NAME-0.glsl`, and to no other shader.
#[test]
fn common_code_of_a_screen_saver_precedes_its_programs() {
    let common = "float one() { return 1.0; }\n";
    let image = "void mainImage(out vec4 c, in vec2 p) { c = vec4(one()); }\n";
    let scratch = Scratch::new(&[
        ("sea-c.glsl", common),
        ("sea.glsl", image),
        ("sea-0.glsl", image),
        ("sea-1.glsl", image),
        ("lake.glsl", image),
    ]);
    for program in ["sea.glsl", "sea-0.glsl", "sea-1.glsl", "sea-c.glsl"] {
        let ran = scratch.run(&["-q", program]);
        assert_eq!((ran.code, ran.out.as_str()), (0, ""), "{program}");
    }
    assert_eq!(scratch.places(&["lake.glsl"]), ["1:50 undeclared-name"]);
}

#[test]
fn common_code_is_checked_as_common_code() {
    let common = "vec4 look(sampler2D s, vec2 p) { return texture(s, p); }\n// what main and texture2D did\n";
    let image = "void mainImage(out vec4 c, in vec2 p) { c = look(iChannel0, p); }\n";
    let scratch = Scratch::new(&[("common.frag", common), ("image.frag", image)]);
    let ran = scratch.run(&["-v"]);
    assert_eq!(ran.code, 0, "{}", ran.out);
    assert!(
        ran.err
            .contains("common.frag: checked as ShaderToy common code"),
        "{}",
        ran.err
    );
}

#[test]
fn chunks_of_three_js_are_not_read_from_files() {
    let a = "#include <common>\nvoid main() { gl_FragColor = vec4(saturate(0.5)); }\n";
    let scratch = Scratch::new(&[("a.frag", a), ("common.glsl", "float ( ;\n")]);
    scratch.write("shaderlint.toml", "host = \"three\"");
    assert_eq!(scratch.places(&["a.frag"]), [] as [&str; 0]);
}
