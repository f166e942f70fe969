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
    /// The findings whose fixes were applied. Their spans are offsets in the text as it was at first;
    /// labels and fixes still have the addresses of their own look.
    pub applied: Vec<Diagnostic>,
    /// The edits of each round, as offsets in the text before it, in order.
    rounds: Vec<Vec<Edit>>,
}

impl Fixed {
    /// The offset in the text as it was at first of one in the text as it is now.
    fn origin(&self, offset: u32) -> u32 {
        let rounds = self.rounds.iter().rev();
        rounds.fold(offset, |offset, edits| before(edits, offset))
    }
}

/// The offset before some edits, which are in order, of one after them. What was put in comes from
/// the start of what it took the place of.
fn before(edits: &[Edit], offset: u32) -> u32 {
    let (mut removed, mut added) = (0, 0);
    for edit in edits {
        let start = edit.span.start + added - removed;
        let length = edit.text.len() as u32;
        if offset < start {
            break;
        }
        if offset < start + length {
            return edit.span.start;
        }
        (removed, added) = (removed + edit.span.len(), added + length);
    }
    offset + removed - added
}

/// Applies fixes until there are none, or none that helps.
///
/// In each round the fixes of one look are applied, those left out that touch others. The text
/// after a round has no more errors than before: fixes that would bring one are found and left out.
pub fn fix(text: &str, allow: Allow, look: impl FnMut(&str) -> Option<Look>) -> Fixed {
    let mut engine = Engine { look };
    let mut fixed = Fixed {
        text: text.to_string(),
        applied: Vec::new(),
        rounds: Vec::new(),
    };
    let Some(mut seen) = (engine.look)(text) else {
        return fixed;
    };
    for _ in 0..MAX_ROUNDS {
        let Some(next) = engine.round(&fixed, &seen, allow) else {
            break;
        };
        (fixed, seen) = next;
    }
    fixed
}

struct Engine<F> {
    look: F,
}

/// What a round gives: the fixes that it kept, and what became of the text.
struct Kept<'a> {
    fixes: Vec<&'a Diagnostic>,
    after: Option<(Fixed, Look)>,
}

impl<F: FnMut(&str) -> Option<Look>> Engine<F> {
    /// One round: all fixes together, without those that do harm.
    fn round(&mut self, fixed: &Fixed, seen: &Look, allow: Allow) -> Option<(Fixed, Look)> {
        let fixes = choose(&seen.diagnostics, seen.span, allow);
        let mut kept = Kept {
            fixes: Vec::new(),
            after: None,
        };
        // Halves are tried where the whole does harm, so that one bad fix among many costs few
        // looks.
        let mut todo = vec![fixes.as_slice()];
        while let Some(next) = todo.pop() {
            let together = [kept.fixes.as_slice(), next].concat();
            if next.is_empty() {
                continue;
            }
            match self.attempt(fixed, seen, &together) {
                Some(after) => {
                    kept = Kept {
                        fixes: together,
                        after: Some(after),
                    };
                }
                None if next.len() > 1 => {
                    let (first, second) = next.split_at(next.len() / 2);
                    todo.extend([second, first]);
                }
                None => {}
            }
        }
        kept.after
    }

    /// The text after some fixes, if it is another one and has no more errors than before.
    fn attempt(
        &mut self,
        fixed: &Fixed,
        seen: &Look,
        mended: &[&Diagnostic],
    ) -> Option<(Fixed, Look)> {
        let fixes = mended.iter().filter_map(|d| d.fix.as_ref());
        let mut edits: Vec<Edit> = fixes.flat_map(|f| f.edits.iter().cloned()).collect();
        end_lines_alike(&mut edits, &fixed.text);
        let base = seen.span.start;
        let text = apply_edits(&fixed.text, base, &edits).ok()?;
        if text == fixed.text {
            return None;
        }
        let after = (self.look)(&text)?;
        if errors(&after) > errors(seen) {
            return None;
        }
        let mut next = fixed.clone();
        let offset = |address: u32| fixed.origin(address.saturating_sub(base));
        next.applied.extend(mended.iter().map(|d| {
            let span = Span::new(offset(d.span.start), offset(d.span.end));
            Diagnostic {
                span,
                ..(*d).clone()
            }
        }));
        for edit in &mut edits {
            edit.span = Span::new(edit.span.start - base, edit.span.end - base);
        }
        edits.sort_by_key(|e| e.span);
        next.rounds.push(edits);
        next.text = text;
        Some((next, after))
    }
}

/// Writes the line breaks of a text into what is put into it.
fn end_lines_alike(edits: &mut [Edit], text: &str) {
    let first = text.find('\n').and_then(|end| text.get(..end));
    if first.is_some_and(|line| line.ends_with('\r')) {
        for edit in edits {
            edit.text = edit.text.replace("\r\n", "\n").replace('\n', "\r\n");
        }
    }
}

fn errors(look: &Look) -> usize {
    let is_error = |d: &&Diagnostic| d.severity == Severity::Error;
    look.diagnostics.iter().filter(is_error).count()
}

/// The fixes that go together: in the order of the text, each of which touches nothing that one
/// before it touches. The same fix offered twice counts once.
fn choose(diagnostics: &[Diagnostic], span: Span, allow: Allow) -> Vec<&Diagnostic> {
    let mut taken: Vec<Span> = Vec::new();
    let mut chosen: Vec<&Diagnostic> = Vec::new();
    for found in diagnostics {
        let Some(fix) = &found.fix else { continue };
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
        chosen.push(found);
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
    use crate::diagnostic::{Origin, error};

    fn info(span: Span) -> Diagnostic {
        Diagnostic::new("letter", Origin::Rule, Severity::Info, span, "a")
    }

    /// Each `a` can be written `b`; each `b` beside a `b` is an error without a fix.
    fn look(text: &str) -> Option<Look> {
        let mut diagnostics = Vec::new();
        for (i, c) in text.char_indices() {
            let span = Span::new(i as u32, i as u32 + 1);
            let edit = Edit::replace(span, "b");
            if c == 'a' {
                diagnostics.push(info(span).fix(Fix::safe("b", vec![edit])));
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
        assert_eq!((fixed.text.as_str(), fixed.applied.len()), ("b.b.b", 3));
    }

    #[test]
    fn fixes_that_harm_are_not_kept() {
        let fixed = fix("aa", Allow::Safe, look);
        assert_eq!((fixed.text.as_str(), fixed.applied.len()), ("ba", 1));
    }

    #[test]
    fn one_fix_that_harms_does_not_keep_others_back() {
        let fixed = fix("a.a.ab.a.a", Allow::Safe, look);
        assert_eq!(
            (fixed.text.as_str(), fixed.applied.len()),
            ("b.b.ab.b.b", 4)
        );
    }

    #[test]
    fn one_bad_fix_among_many_costs_few_looks() {
        let text = format!("{}ab.{}", "a.".repeat(500), "a.".repeat(500));
        let mut looks = 0;
        let fixed = fix(&text, Allow::Safe, |text| {
            looks += 1;
            self::look(text)
        });
        assert_eq!(fixed.applied.len(), 1000);
        assert!(looks < 40, "{looks} looks");
    }

    /// Each `(x)` offers to take both brackets off, which overlaps with what those inside offer.
    fn brackets(text: &str) -> Option<Look> {
        let mut open = Vec::new();
        let mut diagnostics = Vec::new();
        for (i, c) in text.char_indices() {
            let i = i as u32;
            match c {
                '(' => open.push(i),
                ')' => {
                    let from = open.pop()?;
                    let inner = text.get(from as usize + 1..i as usize)?;
                    let span = Span::new(from, i + 1);
                    let edit = Edit::replace(span, inner);
                    diagnostics.push(info(span).fix(Fix::safe("b", vec![edit])));
                }
                _ => {}
            }
        }
        let span = Span::new(0, text.len() as u32);
        Some(Look { diagnostics, span })
    }

    #[test]
    fn fixes_that_overlap_take_one_round_each() {
        let fixed = fix("((a))+(b)", Allow::Safe, brackets);
        assert_eq!((fixed.text.as_str(), fixed.applied.len()), ("a+b", 3));
    }

    #[test]
    fn what_was_mended_is_known_by_its_first_place() {
        let fixed = fix("((a))+(b)", Allow::Safe, brackets);
        let places: Vec<&str> = fixed
            .applied
            .iter()
            .filter_map(|d| "((a))+(b)".get(d.span.start as usize..d.span.end as usize))
            .collect();
        assert_eq!(places, ["(a)", "(b)", "((a))"]);
    }

    #[test]
    fn offsets_go_back_through_edits() {
        let edits = [
            Edit::insert(2, "xx"),
            Edit::replace(Span::new(4, 6), "y"),
            Edit::delete(Span::new(8, 10)),
        ];
        // "0123456789ab" became "01xx23y67ab".
        let back: Vec<u32> = (0..11).map(|i| before(&edits, i)).collect();
        assert_eq!(back, [0, 1, 2, 2, 2, 3, 4, 6, 7, 10, 11]);
    }

    #[test]
    fn fixes_that_want_a_look_are_not_applied_unasked() {
        let unsafe_look = |text: &str| {
            let mut look = look(text)?;
            for fix in look.diagnostics.iter_mut().filter_map(|d| d.fix.as_mut()) {
                fix.applicability = Applicability::Unsafe;
            }
            Some(look)
        };
        assert_eq!(fix("a", Allow::Safe, unsafe_look).text, "a");
        assert_eq!(fix("a", Allow::Unsafe, unsafe_look).text, "b");
    }
}
