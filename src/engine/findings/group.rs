//! Joins findings about the same mistake, so that a person reads about it once.

use super::report::Report;
use rustc_hash::FxHashMap;
use shaderlint_diagnostic::{Applicability, Diagnostic, Fix, Label, Origin, Severity, count};
use shaderlint_text::Edit;

/// What findings have in common that are about the same mistake.
#[derive(PartialEq, Eq, Hash)]
struct SameMistake {
    rule: &'static str,
    severity: Severity,
    /// The messages of warnings before their evidence, without the code that they quote: different sentences
    /// are about different mistakes.
    statement: Option<String>,
    /// Places with and without a fix are kept apart, so that a fix is for all places.
    fix: Option<Applicability>,
}

impl Report {
    /// Leaves one finding for each mistake and file, which lists the other places. Errors stay as they
    /// are, and come first.
    pub fn group(&mut self) {
        let mut first: FxHashMap<SameMistake, usize> = FxHashMap::default();
        let mut grouped: Vec<Diagnostic> = Vec::with_capacity(self.diagnostics.len());
        for diagnostic in std::mem::take(&mut self.diagnostics) {
            let Some(mistake) = mistake(&diagnostic) else {
                grouped.push(diagnostic);
                continue;
            };
            match first.get(&mistake).and_then(|at| grouped.get_mut(*at)) {
                Some(known) => join(known, diagnostic),
                None => {
                    first.insert(mistake, grouped.len());
                    grouped.push(diagnostic);
                }
            }
        }
        for diagnostic in &mut grouped {
            join_edits(diagnostic);
        }
        grouped.sort_by_key(|d| d.severity != Severity::Error);
        self.diagnostics = grouped;
    }
}

fn mistake(d: &Diagnostic) -> Option<SameMistake> {
    if d.origin != Origin::Rule || d.severity == Severity::Error {
        return None;
    }
    let is_warning = d.severity == Severity::Warning;
    Some(SameMistake {
        rule: d.rule,
        severity: d.severity,
        statement: is_warning.then(|| statement(&d.message)),
        fix: d.fix.as_ref().map(|f| f.applicability),
    })
}

/// A message up to its evidence, without what is between backticks.
fn statement(message: &str) -> String {
    let sentence = message.split_once(": ").map_or(message, |(first, _)| first);
    sentence.split('`').step_by(2).collect()
}

/// Adds a finding to one about the same mistake.
fn join(known: &mut Diagnostic, other: Diagnostic) {
    known.others.push(Label {
        span: other.span,
        message: other.message,
    });
    if let (Some(fix), Some(more)) = (&mut known.fix, other.fix) {
        fix.edits.extend(more.edits);
    }
}

/// Puts the edits of a joined fix in order, or drops the fix if they overlap.
fn join_edits(diagnostic: &mut Diagnostic) {
    let others = diagnostic.others.len();
    let Some(fix) = diagnostic.fix.take_if(|_| others > 0) else {
        return;
    };
    let Fix {
        title,
        applicability,
        mut edits,
    } = fix;
    edits.sort_by_key(|e| (e.span.start, e.span.end));
    edits.dedup();
    let overlaps = |pair: &[Edit]| matches!(pair, [a, b] if b.span.start < a.span.end);
    if !edits.windows(2).any(overlaps) {
        let title = match edits.len() {
            1 => title,
            _ => format!("{title}, and the same in {}", count(others, "other place")),
        };
        diagnostic.fix = Some(Fix {
            title,
            applicability,
            edits,
        });
    }
}
