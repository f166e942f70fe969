//! Drops findings that another finding about the same mistake explains better.

use shaderlint_diagnostic::{Diagnostic, Label};
use shaderlint_semantic::Program;
use shaderlint_text::Span;

/// Pairs of rules that can report one mistake: the rule whose finding is dropped, and the one that is
/// kept if they meet.
const PAIRS: [(&str, &str); 5] = [
    ("index-range", "negative-remainder"),
    ("index-range", "out-of-range-seen"),
    ("known-comparison", "duplicate-branch"),
    ("sin-hash", "mediump-noise"),
    ("uniform-without-effect", "unused-variable"),
];

/// The same for rules that report one mistake of several calls in a statement: the place of the one is added
/// to the other.
const CALLS: (&str, &str) = ("undefined-seen", "pow-negative-base");

/// Leaves one finding where two rules report the same mistake.
pub fn absorb(program: &Program, diagnostics: &mut Vec<Diagnostic>) {
    absorb_calls(program, diagnostics);
    for (dropped, kept) in PAIRS {
        let spans: Vec<Span> = diagnostics
            .iter()
            .filter(|d| d.rule == kept)
            .flat_map(spans)
            .collect();
        let spans = joined(spans);
        diagnostics.retain(|d| d.rule != dropped || !meets(&spans, d.span));
    }
}

fn absorb_calls(program: &Program, diagnostics: &mut Vec<Diagnostic>) {
    let (dropped, kept) = CALLS;
    let is_of = |rule: &'static str| move |d: &Diagnostic| d.rule == rule;
    if ![dropped, kept]
        .map(|rule| diagnostics.iter().any(is_of(rule)))
        .iter()
        .all(|has| *has)
    {
        return;
    }
    let (mut moved, mut rest): (Vec<_>, Vec<_>) = std::mem::take(diagnostics)
        .into_iter()
        .partition(is_of(dropped));
    for d in rest.iter_mut().filter(|d| d.rule == kept) {
        // The innermost statement comes first.
        let spans = program
            .tree
            .stmts
            .iter()
            .map(|stmt| program.span(stmt.extent));
        let Some(statement) = spans.into_iter().find(|span| span.contains(d.span)) else {
            continue;
        };
        let inside = moved.extract_if(.., |other| statement.contains(other.span));
        d.others.extend(inside.map(|other| Label {
            span: other.span,
            message: other.message,
        }));
    }
    rest.append(&mut moved);
    *diagnostics = rest;
}

/// What a finding is about: its span, its labels, and what its fix replaces.
fn spans(d: &Diagnostic) -> impl Iterator<Item = Span> {
    let labels = d.labels.iter().map(|l| l.span);
    let edits = d.fix.iter().flat_map(|f| &f.edits).map(|e| e.span);
    std::iter::once(d.span).chain(labels).chain(edits)
}

/// The spans in order, with overlapping ones joined.
fn joined(mut spans: Vec<Span>) -> Vec<Span> {
    spans.sort_by_key(|s| s.start);
    spans.dedup_by(|next, last| {
        let overlaps = next.start < last.end;
        if overlaps {
            last.end = last.end.max(next.end);
        }
        overlaps
    });
    spans
}

/// Whether one of some ordered spans overlaps another span.
fn meets(spans: &[Span], span: Span) -> bool {
    let after = spans.partition_point(|s| s.end <= span.start);
    spans.get(after).is_some_and(|s| s.start < span.end)
}
