//! Errors that follow from another one in the same statement.

use shaderlint_diagnostic::{Diagnostic, Severity, error};
use shaderlint_semantic::Program;
use shaderlint_syntax::TokenKind;
use shaderlint_text::Span;

/// Keeps the first error of a statement that does not parse. What is reported about the names and
/// types in it depends on how it was parsed, so it is not a second mistake. `errors` are in source
/// order.
pub(super) fn keep_causes(program: &Program, errors: &mut Vec<Diagnostic>) {
    let mut kept: Vec<Diagnostic> = Vec::with_capacity(errors.len());
    let mut statement: Vec<Diagnostic> = Vec::new();
    for d in errors.drain(..) {
        let last = statement.last();
        if !last.is_some_and(|last| is_one_statement(program, last.span, d.span)) {
            kept.extend(causes(program, &mut statement));
        }
        statement.push(d);
    }
    kept.extend(causes(program, &mut statement));
    *errors = kept;
}

/// The errors of a statement that are reported.
fn causes(program: &Program, statement: &mut Vec<Diagnostic>) -> Vec<Diagnostic> {
    let is_cut = |d: &Diagnostic| is_unread(d) && d.is(error::SYNTAX_ERROR);
    if statement.iter().any(is_cut) || statement.first().is_some_and(is_unread) {
        let mut at = 0;
        statement.retain(|d| {
            at += 1;
            at == 1 || at < MAX_DROPPED && is_used_below(program, d)
        });
    }
    std::mem::take(statement)
}

/// Maximum number of errors of a statement whose names are searched below it.
const MAX_DROPPED: usize = 10;

/// Whether an error is about an undeclared name that another line uses: it is reported only once.
fn is_used_below(program: &Program, d: &Diagnostic) -> bool {
    let text = program.sources.text(d.span);
    let name = program
        .names
        .get(text)
        .filter(|_| d.is(error::UNDECLARED_NAME));
    name.is_some_and(|name| {
        let tokens = program.tokens.tokens.iter();
        let mut uses = tokens.filter(|t| t.kind == TokenKind::Identifier && t.value == name.0);
        uses.any(|t| t.span.start > d.span.end && !is_one_statement(program, d.span, t.span))
    })
}

/// An error after which the rest of a statement cannot be read as it was meant, and that no correction
/// explains.
fn is_unread(d: &Diagnostic) -> bool {
    let kinds = [
        error::SYNTAX_ERROR,
        error::UNKNOWN_TYPE,
        error::FOREIGN_SYNTAX,
        error::RESERVED_WORD,
    ];
    d.severity == Severity::Error && d.fix.is_none() && kinds.iter().any(|kind| d.is(*kind))
}

/// Whether two places are on one line without the end of a statement between them.
fn is_one_statement(program: &Program, a: Span, b: Span) -> bool {
    let between = Span::new(a.start, b.start.max(a.start));
    let sources = &program.sources;
    sources.file_id_at(a.start) == sources.file_id_at(b.start)
        && !sources.text(between).contains([';', '{', '}', '\n', '\r'])
}
