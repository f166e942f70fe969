//! Shaders for the unit tests of the analyses.

use shaderlint_semantic::{CheckedShader, Completeness, Dialect, Pass, Stage, Unit, check_shader};
use shaderlint_syntax::{GlContext, Search};
use shaderlint_text::{Role, Sources};
use std::sync::Arc;

/// The cases of a table: lines `code => what is found`, without headings and comments.
pub(super) fn cases(table: &str) -> impl Iterator<Item = (&str, &str)> {
    let lines = table.lines();
    let lines = lines.filter(|line| !line.is_empty() && !line.starts_with('#'));
    lines.map(|line| {
        let (code, found) = line.split_once(" =>").unwrap();
        (code, found.trim())
    })
}

/// Checks the code of a ShaderToy image pass and asserts that it has no errors.
pub(super) fn checked(code: &str) -> CheckedShader {
    let mut sources = Sources::default();
    let prelude = Pass::Image.host().prelude([None; 4]);
    let header = sources.add("header", None, Role::Prelude, prelude).unwrap();
    let user = sources.add("test", None, Role::User, code).unwrap();
    let sources = Arc::new(sources);
    let unit = Unit {
        sources: &sources,
        files: &[header, user],
        stage: Stage::Fragment,
        dialect: Dialect::ShaderToy(Pass::Image),
        context: GlContext::WEBGL2,
        infer_channels: true,
        completeness: Completeness::Complete,
    };
    let shader = check_shader(&unit, &mut Search::for_text());
    assert!(shader.is_valid(), "{:?}", shader.problems.all);
    shader
}
