//! Which language a text is.

use shaderlint::detect::kind::{Claim, Evidence, FileKind, Scanned, decide, own_directive};

#[test]
fn files_with_a_glsl_extension_are_glsl_if_the_dialect_is_given() {
    for text in [
        "{} void main() {}",
        "[] float a;",
        "half4 a = lerp(b, c, 0.5);",
    ] {
        let kind = decide("a.frag", text, Claim::Dialect).kind;
        assert_eq!(kind, FileKind::Shader, "{text}");
    }
    let desktop = decide("a.frag", "#version 450\nvoid main() {}", Claim::Dialect);
    assert!(matches!(desktop.kind, FileKind::Foreign(_)));
    assert_ne!(decide("a.txt", "{}", Claim::Dialect).kind, FileKind::Shader);
}

#[track_caller]
fn check(name: &str, text: &str, expected: &str) {
    let decision = decide(name, text, Claim::None);
    let kind = match decision.kind {
        FileKind::Shader => "shader",
        FileKind::Export => "export",
        FileKind::Holds(_) => "holds",
        FileKind::Foreign(_) => "foreign",
        FileKind::Other => "other",
    };
    assert_eq!(format!("{kind}: {decision}"), expected);
}

/// A text of a table, with `↵` for a line break and `⇥` for a tab.
fn written(text: &str) -> String {
    text.replace('↵', "\n")
        .replace('⇥', "\t")
        .replace("{GLSL}", GLSL)
}

const GLSL: &str = "uniform vec2 size;\nvoid main() { gl_FragColor = vec4(size, 0, 1) }";

#[test]
fn names_and_texts_decide() {
    let cases = include_str!("../../src/detect/kind/cases.txt").lines();
    for case in cases.filter(|case| !case.starts_with("# ")) {
        let (name, rest) = case.split_once(" | ").unwrap();
        let (text, expected) = rest.rsplit_once(" => ").unwrap();
        check(name, &written(text), expected);
    }
}

#[test]
fn directives_of_shader_bundles_are_recognised() {
    assert_eq!(
        own_directive("@export a.b\nvoid main() {}\n@end"),
        Some("@export")
    );
    assert_eq!(own_directive("/*\n@author me\n*/\nvoid main() {}"), None);
    assert_eq!(
        own_directive("// @author\nx; /* a */\n@import 'b.glsl'"),
        None
    );
    assert_eq!(own_directive("float f() { return @SCALE@; }\n@NAME@"), None);
}

/// Shaders of engines: the language, its sign, and a text.
fn engines() -> Vec<(String, String, String)> {
    let lines = include_str!("../../src/detect/kind/engines.txt").lines();
    let parts = lines.map(|line| {
        let (language, rest) = line.split_once(" | ").unwrap();
        let (sign, text) = rest.split_once(" | ").unwrap();
        (language.to_string(), sign.to_string(), written(text))
    });
    parts.collect()
}

#[test]
fn shaders_of_engines_are_recognised() {
    for (name, sign, text) in engines() {
        let FileKind::Foreign(language) = decide("a.glsl", &text, Claim::None).kind else {
            panic!("{text}");
        };
        let range = Evidence::of(&text).first_sign(language).unwrap();
        assert_eq!(
            (format!("{language:?}"), &text[range]),
            (name, sign.as_str()),
            "{text}"
        );
    }
}

#[test]
fn engine_names_in_comments_and_strings_are_ignored() {
    for (_, _, text) in engines() {
        let comment: String = text.lines().map(|l| format!("// {l}\n")).collect();
        let block = format!("/*\n{}*/\n", text.replace("/*", "").replace("*/", ""));
        let quoted = format!("#pragma note {:?}\n", text.replace('"', "'"));
        for about in [comment, block, quoted] {
            let text = format!("{about}{GLSL}");
            let decision = decide("a.glsl", &text, Claim::None);
            assert_eq!(decision.kind, FileKind::Shader, "{text}");
        }
    }
}

#[test]
fn shaders_are_distinguished_from_other_programs() {
    let is_shader = |text| Scanned::of(text).is_shader();
    assert!(is_shader("void main() {}"));
    assert!(is_shader("\n#version 300 es\n"));
    assert!(!is_shader(
        "<html><script>void main() { gl_FragColor = vec4(1); }</script></html>"
    ));
    assert!(!is_shader(
        "#include <stdio.h>\nvoid main() { printf(\"x\"); }"
    ));
    assert!(!is_shader(
        "void main() { if (a &lt; b) gl_FragColor = vec4(1); }"
    ));
    assert!(!is_shader("void mainly()"));
}
