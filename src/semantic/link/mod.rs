//! Vertex and fragment shader together: what the browser's linker asks of two shaders that compile.
//!
//! The rules are those of GLSL ES 3.00 (4.3.4 to 4.3.10 and 9) and 1.00 (4.3.3 to 4.6.4) as ANGLE
//! applies them: what a fragment shader names counts as used, whether or not the code runs.

mod blocks;
mod compare;
mod errors;
mod interface;
mod limits;
mod live;
mod uniforms;
mod varyings;

use super::Program;
use errors::{LinkErrors, MAX_ERRORS};
pub use interface::{Block, Interface, InterfaceVariable};
use shaderlint_diagnostic::{Diagnostic, error};

/// Finds what keeps two shaders without errors from being linked. Both stand in one address space.
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

/// Both stages are of one version.
fn versions(vertex: &Interface, fragment: &Interface, found: &mut LinkErrors) {
    let place = |i: &Interface| {
        let tokens = &i.program.tokens;
        let first = tokens.tokens.first().map(|t| t.span);
        tokens.version_span.or(first).unwrap_or_default()
    };
    let name = |i: &Interface| i.program.version.profile().name;
    let message = format!(
        "the fragment shader is {}, and its vertex shader {}",
        name(fragment),
        name(vertex)
    );
    found.diagnostics.push(
        Diagnostic::error(error::LINK_VERSION, place(fragment), message)
            .label(place(vertex), format!("{} here", name(vertex)))
            .note("both stages of a program are of one version (section 3.3)")
            .help("start both with the same `#version`"),
    );
}

#[cfg(test)]
mod tests;
