//! Pairs of shaders that compute the same, and pairs that do not.

use super::*;
use crate::test_shader::TestShader;
use crate::{Effects, Writes};
use shaderlint_semantic::{Mentions, Structure};

const MAIN: &str = "void mainImage(out vec4 c, in vec2 p) {";

/// Whether two bodies, each after code of its own, are proved to be equivalent.
#[track_caller]
fn check(before: [&str; 2], after: [&str; 2], expected: bool) {
    let texts = [before, after].map(|[code, body]| format!("{code}\n{MAIN}\n{body}\n}}\n"));
    let shaders = texts.each_ref().map(|text| TestShader::of(text));
    let effects = shaders.each_ref().map(|shader| {
        let (program, module) = (&shader.program, &shader.module);
        let writes = Writes::of(program, module, &Mentions::of(program));
        let structure = Structure::of(program);
        Effects::of(program, module, &structure, &shader.calls, &writes)
    });
    let version = |at: usize| ShaderVersion {
        program: &shaders[at].program,
        module: &shaders[at].module,
        effects: &effects[at],
        entry: None,
    };
    let found = is_equivalent(version(0), version(1));
    assert_eq!(found, expected, "{}\n{}", texts[0], texts[1]);
}

#[test]
fn pairs_are_proved_equivalent_or_not() {
    let cases = include_str!("cases.txt").lines();
    for case in cases.filter(|case| !case.starts_with('#')) {
        let is_equivalent = case.contains(" ≡ ");
        let (before, after) = case
            .split_once([" ≢ ", " ≡ "][usize::from(is_equivalent)])
            .unwrap();
        let parts = |text: &str| {
            let (code, body) = text.split_once(" ¦ ").unwrap();
            [code, body].map(|part| part.replace('↵', "\n"))
        };
        let [before, after] = [before, after].map(parts);
        check(
            before.each_ref().map(String::as_str),
            after.each_ref().map(String::as_str),
            is_equivalent,
        );
    }
}
