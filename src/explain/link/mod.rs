//! Linking of vertex and fragment shader: the checks that the browser's linker makes on two shaders
//! that compile.
//!
//! The rules are those of GLSL ES 3.00 (4.3.4 to 4.3.10 and 9) and 1.00 (4.3.3 to 4.6.4) as ANGLE
//! applies them: what a fragment shader names counts as used, whether or not the code runs.

mod blocks;
mod compare;
mod errors;
mod limits;
mod uniforms;
mod varyings;

use errors::{LinkErrors, MAX_ERRORS};
use shaderlint_diagnostic::{Diagnostic, error};
use shaderlint_semantic::Program;
use shaderlint_semantic::interface::Interface;

/// Finds link errors between two shaders without compile errors. Both are in one address space.
pub fn link(vertex: &Program, fragment: &Program) -> Vec<Diagnostic> {
    let (vertex, fragment) = (Interface::of(vertex), Interface::of(fragment));
    let mut found = LinkErrors::default();
    if vertex.program.version != fragment.program.version {
        versions(&vertex, &fragment, &mut found);
        return found.diagnostics;
    }
    limits::attributes(&vertex, &mut found);
    varyings::check(&vertex, &fragment, &mut found);
    uniforms::check(&vertex, &fragment, &mut found);
    blocks::check(&vertex, &fragment, &mut found);
    limits::counts(&vertex, &mut found);
    limits::counts(&fragment, &mut found);
    found.diagnostics.truncate(MAX_ERRORS);
    found.diagnostics
}

/// Both stages must have the same version.
fn versions(vertex: &Interface, fragment: &Interface, found: &mut LinkErrors) {
    let place = |i: &Interface| {
        let tokens = &i.program.tokens;
        let first = tokens.tokens.first().map(|t| t.span);
        tokens.version_span.or(first).unwrap_or_default()
    };
    let name = |i: &Interface| i.program.version.profile().name;
    let message = format!(
        "fragment shader is {}, vertex shader is {}",
        name(fragment),
        name(vertex)
    );
    found.diagnostics.push(
        Diagnostic::error(error::LINK_VERSION, place(fragment), message)
            .label(place(vertex), format!("{} here", name(vertex)))
            .note("both stages of a program must use the same version (section 3.3)")
            .help("use the same `#version` in both shaders"),
    );
}
