//! The `#version` of GLSL ES 3.00 where it is missing.

use super::stage::ShaderCheck;
use crate::shader::reading::code_of;
use shaderlint_diagnostic::{Diagnostic, Fix, Severity, error};
use shaderlint_semantic::Completeness;
use shaderlint_syntax::{Version, WordClass, classify};
use shaderlint_text::{Edit, Role, Span};

/// Adds the finding about a missing `#version`.
pub fn report_missing(shader: &mut ShaderCheck) {
    let found = missing(shader);
    shader.checked.diagnostics.extend(found);
}

/// Reports a shader that requires GLSL ES 3.00 but has no `#version`: an error if it is compiled
/// unchanged, a warning in a file that no known host completes.
fn missing(shader: &ShaderCheck) -> Option<Diagnostic> {
    let (sources, part) = (shader.sources, shader.part);
    if shader.checked.completeness == Completeness::Excerpt {
        return None;
    }
    let files = &part.reading()?.files;
    let own = |id: &&_| sources.code(**id).is_some_and(|c| c.role == Role::User);
    let first = sources.code(*files.iter().find(own)?)?;
    let at = part.readings.lacks_version(first.text)?;
    // Included files may require GLSL ES 3.00 as well.
    let is_alone = code_of(sources, files).len() == first.text.len();
    let severity = match part.readings.is_compiled() {
        true => Severity::Error,
        false if is_alone && !part.readings.is_handed_over() && shader.hosts.adds_no_version() => {
            Severity::Warning
        }
        false => return None,
    };
    let word = first.text.get(at.clone())?;
    let span = Span::new(first.base + at.start as u32, first.base + at.end as u32);
    let message = format!("`{word}` requires GLSL ES 3.00, but `#version 300 es` is missing");
    let d = Diagnostic::of(error::NEEDS_WEBGL2, severity, span, message)
        .note("a shader without `#version` is GLSL ES 1.00 (section 3.4)");
    if let Some(setting) = &part.readings.version_setting {
        return Some(d.help(format!("set `{setting}` next to the shader")));
    }
    let edit = Edit::insert(first.base, "#version 300 es\n");
    let title = "add `#version 300 es` as the first line";
    Some(d.fix(Some(Fix::suggestion(title, vec![edit]))))
}

/// Lowers the errors of words that only GLSL ES 3.00 reserves to warnings, in a text without `#version`
/// whose host is unknown: some hosts compile such a text as GLSL ES 1.00 and define `in` and `out`.
pub fn lower_reserved_words(shader: &mut ShaderCheck) {
    let (sources, readings) = (shader.sources, &shader.part.readings);
    let checked = &mut shader.checked;
    let has_host = !readings.hosts.is_empty() || readings.is_compiled();
    if has_host || readings.has_version() || checked.program.dialect.is_shadertoy() {
        return;
    }
    for d in &mut checked.diagnostics {
        let is_free = |span| classify(sources.text(span), Version::Es100) == WordClass::Plain;
        if d.is(error::RESERVED_WORD) && is_free(d.span) {
            d.severity = Severity::Warning;
            d.notes.push(
                "a host without `#version` may compile it as GLSL ES 1.00, which allows it"
                    .to_string(),
            );
        }
    }
}
