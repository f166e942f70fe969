//! Drops findings that another finding about the same mistake explains better.

use shaderlint_diagnostic::Diagnostic;
use shaderlint_text::Span;

/// Pairs of rules that can report one mistake: the rule whose finding is dropped, and the one that is
/// kept if they meet.
const PAIRS: [(&str, &str); 3] = [
    ("known-comparison", "duplicate-branch"),
    ("sin-hash", "mediump-noise"),
    ("uniform-without-effect", "unused-variable"),
];

/// Leaves one finding where two rules report the same mistake.
pub fn absorb(diagnostics: &mut Vec<Diagnostic>) {
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
