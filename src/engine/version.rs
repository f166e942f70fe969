//! GLSL ES 3.00 shaders without `#version`, which browsers compile as GLSL ES 1.00.

use super::host::Hosts;
use super::reading::code_of;
use super::shader_input::ShaderInput;
use shaderlint_diagnostic::{Diagnostic, Fix, Severity, error};
use shaderlint_semantic::{Checked, Completeness};
use shaderlint_text::{Edit, Role, Sources, Span};

/// Reports a shader that requires GLSL ES 3.00 but has no `#version`: an error if it is compiled
/// unchanged, a warning in a file that no known host completes.
pub fn missing(
    sources: &Sources,
    part: &ShaderInput,
    checked: &Checked,
    hosts: &Hosts,
) -> Option<Diagnostic> {
    if checked.completeness == Completeness::Excerpt {
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
        false if is_alone && !part.readings.is_handed_over() && hosts.adds_no_version() => {
            Severity::Warning
        }
        false => return None,
    };
    let word = first.text.get(at.clone())?;
    let span = Span::new(first.base + at.start as u32, first.base + at.end as u32);
    let message = format!("`{word}` requires GLSL ES 3.00, but `#version 300 es` is missing");
    let edit = Edit::insert(first.base, "#version 300 es\n");
    let d = Diagnostic::of(error::NEEDS_WEBGL2, severity, span, message)
        .note("a shader without `#version` is GLSL ES 1.00 (section 3.4)");
    let title = "add `#version 300 es` as the first line";
    Some(d.fix(Some(Fix::suggestion(title, vec![edit]))))
}
