//! Converts a complete shader of GLSL ES 1.00 to GLSL ES 3.00.

use super::place::RefactorPlace;
use super::proposal::{ProposedRefactoring, RefactorKind, RequiredProof};
use shaderlint_explain::upgrade;
use shaderlint_semantic::Dialect;
use shaderlint_syntax::Version;

pub(super) fn propose(place: &RefactorPlace) -> Option<ProposedRefactoring> {
    let program = place.program;
    // Code that gives the shader to the browser may depend on its version.
    let is_alone =
        place.document.report.analyses.len() == 1 && !place.document.report.holds_shaders();
    let is_old = program.version == Version::Es100 && program.dialect == Dialect::WebGl;
    let done = (is_alone && is_old)
        .then(|| upgrade(program).ok())
        .flatten();
    // Inputs with other names would need changes of the code that sets them.
    let done = done.filter(|done| done.renamed.is_empty());
    done.map(|done| ProposedRefactoring {
        evidence: RequiredProof::EqualImages,
        ..ProposedRefactoring::new(RefactorKind::Rewrite, "Convert to GLSL ES 3.00", done.edits)
    })
}
