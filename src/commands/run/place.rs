//! Source positions.

use shaderlint_ir::Provenance;
use shaderlint_semantic::Program;
use shaderlint_text::{Sources, Span};

/// The span that something in the IR comes from.
pub fn span(program: &Program, from: Provenance) -> Option<Span> {
    match from {
        Provenance::Expr(id) => Some(program.expr_span(id)),
        Provenance::Declaration(token) => program.token(token).map(|t| t.span),
        Provenance::Stmt(id) => Some(program.span(program.tree.stmt(id).extent)),
        Provenance::Language => None,
    }
}

/// A position as `file:line:column`.
pub fn position(sources: &Sources, span: Span) -> Option<String> {
    let file = sources.file_at(span.start)?;
    let at = file.position(span.start);
    let (path, line) = file.origin(at.line);
    Some(format!("{path}:{line}:{}", at.column))
}
