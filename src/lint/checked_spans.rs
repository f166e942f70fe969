//! Which code of a shader with errors was type-checked, and which was not: one mistake may hide others.

use shaderlint_semantic::Program;
use shaderlint_syntax::ast::{DeclKind, StmtKind};
use shaderlint_text::Span;

/// Spans of a text that were checked, and spans that were not.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct CheckedSpans {
    /// Expressions of a known type, and declared names.
    pub done: Vec<Span>,
    /// Code that could not be parsed, and expressions of unknown type.
    pub left: Vec<Span>,
}

impl CheckedSpans {
    /// Collects the spans of a checked shader.
    pub fn of(program: &Program) -> CheckedSpans {
        let mut spans = CheckedSpans::default();
        let tree = &program.tree;
        for (expr, info) in tree.exprs.iter().zip(&program.exprs) {
            let span = program.span(expr.extent);
            let into = if info.ty.is_error() {
                &mut spans.left
            } else {
                &mut spans.done
            };
            into.push(span);
        }
        let unread = tree.stmts.iter().filter(|s| s.kind == StmtKind::Error);
        spans.left.extend(unread.map(|s| program.span(s.extent)));
        let unread = tree.decls.iter().filter(|d| d.kind == DeclKind::Error);
        spans.left.extend(unread.map(|d| program.span(d.extent)));
        let names = tree.declarator_lists.iter().zip(&program.declared);
        let names = names.filter(|(_, variable)| variable.is_some());
        let names = names.filter_map(|(d, _)| program.token(d.ident.token));
        spans.done.extend(names.map(|t| t.span));
        spans
    }

    /// Adds the spans of another shader of the same text.
    pub fn join(&mut self, other: CheckedSpans) {
        self.done.extend(other.done);
        self.left.extend(other.left);
    }

    /// Whether a mistake at this span would have been reported.
    pub fn has_seen(&self, span: Span) -> bool {
        let meets = |other: &Span| other.start <= span.end && span.start <= other.end;
        let holds = |other: &Span| other.start < span.end && span.start < other.end;
        !self.left.iter().any(holds) && self.done.iter().any(meets)
    }
}
