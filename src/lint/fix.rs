//! The fix engine: which fixes of one look at a text go together, and their repetition until
//! nothing is left to mend.

use crate::diagnostic::{Applicability, Diagnostic, Fix, Severity};
use crate::text::{Edit, Span, apply_edits};

/// Most looks that are taken at one text.
const MAX_ROUNDS: usize = 16;

/// Which fixes may be applied.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Allow {
    /// Those that keep the picture.
    Safe,
    /// All.
    Unsafe,
}

impl Allow {
    /// Whether a fix may be applied.
    pub fn permits(self, fix: &Fix) -> bool {
        self == Allow::Unsafe || fix.applicability == Applicability::Safe
    }
}

/// What the findings in a text are, and where the text lies among the addresses.
pub struct Look {
    /// The findings.
    pub diagnostics: Vec<Diagnostic>,
    /// Addresses of the text.
    pub span: Span,
}

/// A text after its fixes.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Fixed {
    /// The text.
    pub text: String,
    /// How many fixes were applied.
    pub applied: usize,
}

/// Applies fixes until there are none, or none that helps. A set of fixes that brings more errors
/// than it takes away is not kept.
pub fn fix(text: &str, allow: Allow, mut look: impl FnMut(&str) -> Option<Look>) -> Fixed {
    let mut fixed = Fixed {
        text: text.to_string(),
        applied: 0,
    };
    let Some(mut seen) = look(text) else {
        return fixed;
    };
    for _ in 0..MAX_ROUNDS {
        let Some(next) = round(&fixed, &seen, allow, &mut look) else {
            break;
        };
        (fixed, seen) = next;
    }
    fixed
}

/// One round: all fixes together, or else those that do no harm alone.
fn round(
    fixed: &Fixed,
    seen: &Look,
    allow: Allow,
    look: &mut impl FnMut(&str) -> Option<Look>,
) -> Option<(Fixed, Look)> {
    let fixes = choose(&seen.diagnostics, seen.span, allow);
    let mut attempt = |fixes: &[&Fix]| -> Option<(Fixed, Look)> {
        let edits: Vec<Edit> = fixes.iter().flat_map(|f| f.edits.iter().cloned()).collect();
        let text = apply_edits(&fixed.text, seen.span.start, &edits).ok()?;
        let after = look(&text)?;
        let is_better = errors(&after) <= errors(seen) && text != fixed.text;
        let applied = fixed.applied + fixes.len();
        is_better.then_some((Fixed { text, applied }, after))
    };
    if fixes.is_empty() {
        return None;
    }
    attempt(&fixes).or_else(|| fixes.iter().find_map(|&fix| attempt(&[fix])))
}

fn errors(look: &Look) -> usize {
    let is_error = |d: &&Diagnostic| d.severity == Severity::Error;
    look.diagnostics.iter().filter(is_error).count()
}

/// The fixes that go together: in the order of the text, each of which touches nothing that one
/// before it touches. The same fix offered twice counts once.
fn choose(diagnostics: &[Diagnostic], span: Span, allow: Allow) -> Vec<&Fix> {
    let mut taken: Vec<Span> = Vec::new();
    let mut chosen: Vec<&Fix> = Vec::new();
    for fix in diagnostics.iter().filter_map(|d| d.fix.as_ref()) {
        let inside = |e: &Edit| span.start <= e.span.start && e.span.end <= span.end;
        if !allow.permits(fix) || !fix.edits.iter().all(inside) {
            continue;
        }
        if fix.edits.iter().any(|e| is_taken(&taken, e.span)) {
            continue;
        }
        for edit in &fix.edits {
            let at = taken.partition_point(|t| *t < edit.span);
            taken.insert(at, edit.span);
        }
        chosen.push(fix);
    }
    chosen
}

/// Whether a span touches one of these, which are sorted and do not touch each other.
fn is_taken(taken: &[Span], span: Span) -> bool {
    let at = taken.partition_point(|t| t.start < span.start);
    let touches = |t: &Span| t.start <= span.end && span.start <= t.end;
    let before = at.checked_sub(1).and_then(|i| taken.get(i));
    before.is_some_and(touches) || taken.get(at).is_some_and(touches)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnostic::error;

    /// Each `a` is an error that is mended by `b`; each `b` beside a `b` an error without a fix.
    fn look(text: &str) -> Option<Look> {
        let mut diagnostics = Vec::new();
        for (i, c) in text.char_indices() {
            let span = Span::new(i as u32, i as u32 + 1);
            let edit = Edit::replace(span, "b");
            if c == 'a' {
                let d = Diagnostic::error(error::SYNTAX_ERROR, span, "a");
                diagnostics.push(d.fix(Fix::safe("b", vec![edit])));
            }
        }
        let twins = text.matches("bb").count();
        for _ in 0..twins * 2 {
            diagnostics.push(Diagnostic::error(error::SYNTAX_ERROR, Span::at(0), "bb"));
        }
        let span = Span::new(0, text.len() as u32);
        Some(Look { diagnostics, span })
    }

    #[test]
    fn all_fixes_are_applied() {
        let fixed = fix("a.a.a", Allow::Safe, look);
        assert_eq!((fixed.text.as_str(), fixed.applied), ("b.b.b", 3));
    }

    #[test]
    fn fixes_that_harm_are_not_kept() {
        let fixed = fix("aa", Allow::Safe, look);
        assert_eq!((fixed.text.as_str(), fixed.applied), ("ba", 1));
    }
}
