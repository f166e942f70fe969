//! The fix engine: selects fixes that do not overlap, applies them, and repeats until no fix is left.
//! Also helpers for the edits of fixes: removals and indentation.

mod change;
pub mod indent;
pub(super) mod look;
pub(super) mod removal;

use change::{ErrorChange, Moves, errors};
use look::Look;
use rustc_hash::FxHashSet;
use shaderlint_diagnostic::{Applicability, Diagnostic, Fix};
use shaderlint_text::{Edit, Sources, Span, apply_edits};
use std::cell::LazyCell;

/// Most rounds of fixes for one text.
const MAX_ROUNDS: usize = 16;
/// Most bytes of text that are checked again for the fixes of one text. Fixes left over then are not
/// applied: a text of a megabyte is checked twice, one of ten kilobytes thirty times.
const MAX_LOOKED: usize = 2_000_000;
/// Least cost of a check, in bytes of text: unclosed brackets make a short text expensive.
const LEAST_LOOKED: usize = 64_000;
/// Cost of a token or macro call, in bytes of text.
const TOKEN_COST: usize = 4;

/// Which fixes may be applied.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Allow {
    /// Fixes that keep the image.
    Safe,
    /// All fixes.
    Unsafe,
}

impl Allow {
    /// Whether a fix may be applied.
    pub fn permits(self, fix: &Fix) -> bool {
        self == Allow::Unsafe || fix.applicability == Applicability::Safe
    }
}

/// Evidence that fixes kept the image, the strongest first.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Proof {
    /// The compiled code is the same.
    SameCode,
    /// All sampled pixels have the same bits.
    SameBits,
    /// No evidence: the shader cannot be run, or could not be before.
    Unknown,
    /// The image differs.
    Refuted,
}

/// A text after its fixes.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Fixed {
    /// The text with the fixes applied.
    pub text: String,
    /// The findings whose fixes were applied. Their spans are offsets in the original text; labels and
    /// fixes keep the addresses of the round that found them.
    pub applied: Vec<Diagnostic>,
    /// The evidence for each finding in `applied`.
    pub proofs: Vec<Proof>,
    /// The findings with a safe fix that would change the image and was not applied. Their spans are
    /// offsets in the fixed text.
    pub left: Vec<Diagnostic>,
    /// How each round moved offsets.
    rounds: Vec<Moves>,
}

impl Fixed {
    /// A text without applied fixes.
    fn unchanged(text: &str) -> Fixed {
        Fixed {
            text: text.to_string(),
            ..Fixed::default()
        }
    }

    /// Maps an offset in the fixed text to the original text.
    pub fn origin(&self, offset: u32) -> u32 {
        let rounds = self.rounds.iter().rev();
        rounds.fold(offset, |offset, moves| moves.before(offset))
    }
}

/// Applies fixes until none is left, or none that helps.
///
/// Each round applies the fixes of one check that do not touch each other. A fix is kept if it causes no
/// error; errors in places that could not be checked before do not count. Fixes that cause errors are
/// found by bisection and left out, and so are safe fixes for which `compare` finds another image.
pub fn fix(
    text: &str,
    allow: Allow,
    mut look: impl FnMut(&str) -> Option<Look>,
    compare: impl FnMut(&Look, &Look) -> Proof,
) -> Fixed {
    match look(text) {
        Some(seen) => fix_seen(text, seen, allow, look, compare),
        None => Fixed::unchanged(text),
    }
}

/// Most bytes of text that are checked to try the fixes of errors that are offered.
const MAX_OFFERED: usize = 500_000;

/// The errors whose fix fails: applied alone, the error remains, or there is a new one in code that was
/// checked before, or one without a fix in its line. Tries the fixes that `is_offered` selects, as far as
/// a budget permits; `seen` is the check of `text`.
pub fn failing_fixes<'a>(
    text: &str,
    seen: &'a Look,
    is_offered: impl Fn(&Diagnostic) -> bool,
    look: impl FnMut(&str) -> Option<Look>,
) -> Vec<&'a Diagnostic> {
    let mut engine = Engine {
        look,
        compare: without_images,
        left: MAX_OFFERED,
        refuted: Vec::new(),
    };
    let fixed = Fixed::unchanged(text);
    // Edits of included files are not tried.
    let is_inside = |d: &&Diagnostic| {
        let edits = d.fix.iter().flat_map(|fix| &fix.edits);
        d.fix.is_some() && edits.into_iter().all(|e| seen.span.contains(e.span))
    };
    let offered = errors(seen).filter(|d| is_inside(d) && is_offered(d));
    let fails = |d: &&Diagnostic| match engine.try_fixes(&fixed, seen, &[d]) {
        Ok((_, after)) => {
            // As they were applied.
            let mut edits = d.fix.as_ref().map_or(Vec::new(), |fix| fix.edits.clone());
            end_lines_alike(&mut edits, text);
            ErrorChange::new(seen, &after, &edits, &[d]).leaves_line_broken(text)
        }
        Err(harm) => matches!(harm, Harm::Errors),
    };
    offered.filter(fails).collect()
}

/// Compares no images: the evidence is always [`Proof::Unknown`].
pub fn without_images(_: &Look, _: &Look) -> Proof {
    Proof::Unknown
}

/// Applies fixes to a checked text: the safe ones first, and then the others if they are allowed, so that
/// the safe ones do not depend on the others.
fn fix_seen(
    text: &str,
    mut seen: Look,
    allow: Allow,
    look: impl FnMut(&str) -> Option<Look>,
    compare: impl FnMut(&Look, &Look) -> Proof,
) -> Fixed {
    let mut engine = Engine {
        look,
        compare,
        left: MAX_LOOKED,
        refuted: Vec::new(),
    };
    let mut fixed = Fixed::unchanged(text);
    for step in [Allow::Safe, Allow::Unsafe] {
        if step == Allow::Unsafe && allow == Allow::Safe {
            break;
        }
        for _ in 0..MAX_ROUNDS {
            let next = engine.round(&fixed, &seen, Allow::Safe);
            let next = match step {
                Allow::Safe => next,
                // An unsafe fix may reveal a finding with a safe one.
                Allow::Unsafe => next.or_else(|| engine.round(&fixed, &seen, step)),
            };
            let Some(next) = next else {
                break;
            };
            (fixed, seen) = next;
        }
    }
    let left = seen.diagnostics.iter();
    let left = left.filter(|d| engine.is_refuted(&fixed, &seen, d));
    fixed.left = left.map(|d| at_offset(d, seen.span.start)).collect();
    fixed
}

/// A finding with its span as offsets in the text that starts at address `base`.
fn at_offset(found: &Diagnostic, base: u32) -> Diagnostic {
    let offset = |address: u32| address.saturating_sub(base);
    Diagnostic {
        span: Span::new(offset(found.span.start), offset(found.span.end)),
        ..found.clone()
    }
}

struct Engine<L, C> {
    look: L,
    compare: C,
    /// Bytes that may still be checked.
    left: usize,
    /// Safe fixes that would change the image.
    refuted: Vec<Refuted>,
}

/// A safe fix that would change the image: its rule, its offset in the original text, and its title.
#[derive(PartialEq)]
struct Refuted(&'static str, u32, String);

impl Refuted {
    fn of(fixed: &Fixed, seen: &Look, found: &Diagnostic) -> Option<Refuted> {
        let place = fixed.origin(found.span.start.saturating_sub(seen.span.start));
        let title = found.fix.as_ref()?.title.clone();
        Some(Refuted(found.rule, place, title))
    }
}

/// Why fixes are rejected.
enum Harm {
    /// They cause errors, or change nothing.
    Errors,
    /// They cost too much to check.
    Budget,
    /// They change the image.
    Image,
}

/// The fixes that a round kept, and the resulting text.
struct Kept<'a> {
    fixes: Vec<&'a Diagnostic>,
    after: Option<(Fixed, Look)>,
}

impl<L: FnMut(&str) -> Option<Look>, C: FnMut(&Look, &Look) -> Proof> Engine<L, C> {
    /// Whether the fix of a finding is known to change the image.
    fn is_refuted(&self, fixed: &Fixed, seen: &Look, found: &Diagnostic) -> bool {
        let is_it = |own: Refuted| self.refuted.contains(&own);
        !self.refuted.is_empty() && Refuted::of(fixed, seen, found).is_some_and(is_it)
    }

    /// One round: all compatible fixes, without the harmful ones. If all are harmful, tries those that
    /// they blocked.
    fn round(&mut self, fixed: &Fixed, seen: &Look, allow: Allow) -> Option<(Fixed, Look)> {
        let open = seen.diagnostics.iter();
        let mut open: Vec<_> = open.filter(|d| !self.is_refuted(fixed, seen, d)).collect();
        loop {
            let fixes = choose(&open, seen.span, allow);
            if fixes.is_empty() {
                return None;
            }
            if let Some(after) = self.without_harm(fixed, seen, &fixes) {
                return Some(after);
            }
            let mut refused = fixes.iter().peekable();
            open.retain(|d| refused.next_if(|r| std::ptr::eq(**r, *d)).is_none());
        }
    }

    /// Applies those of `fixes` that do no harm.
    fn without_harm(
        &mut self,
        fixed: &Fixed,
        seen: &Look,
        fixes: &[&Diagnostic],
    ) -> Option<(Fixed, Look)> {
        let mut kept = Kept {
            fixes: Vec::new(),
            after: None,
        };
        // Bisects a harmful set, so that one bad fix among many costs few checks.
        let mut todo = vec![fixes];
        while let Some(next) = todo.pop() {
            let together = [kept.fixes.as_slice(), next].concat();
            if next.is_empty() {
                continue;
            }
            match (self.try_fixes(fixed, seen, &together), next) {
                (Ok(after), _) => {
                    kept = Kept {
                        fixes: together,
                        after: Some(after),
                    };
                }
                (Err(Harm::Image), [one]) => {
                    self.refuted.extend(Refuted::of(fixed, seen, one));
                }
                (Err(_), _) if next.len() > 1 => {
                    let (first, second) = next.split_at(next.len() / 2);
                    todo.extend([second, first]);
                }
                (Err(_), _) => {}
            }
        }
        kept.after
    }

    /// The text after some fixes, if it changes, they cause no error, and safe fixes keep the image.
    fn try_fixes(
        &mut self,
        fixed: &Fixed,
        seen: &Look,
        chosen: &[&Diagnostic],
    ) -> Result<(Fixed, Look), Harm> {
        let fixes = chosen.iter().filter_map(|d| d.fix.as_ref());
        let mut edits: Vec<Edit> = fixes.clone().flat_map(|f| f.edits.clone()).collect();
        end_lines_alike(&mut edits, &fixed.text);
        let base = seen.span.start;
        let text = apply_edits(&fixed.text, base, &edits).map_err(|_| Harm::Errors)?;
        if text == fixed.text {
            return Err(Harm::Errors);
        }
        let cost = text.len().max(LEAST_LOOKED);
        self.left = self.left.checked_sub(cost).ok_or(Harm::Budget)?;
        let after = (self.look)(&text).ok_or(Harm::Errors)?;
        // Macros may expand a short text to many tokens.
        let expanded = (after.size * TOKEN_COST).saturating_sub(cost);
        self.left = self.left.saturating_sub(expanded);
        let change = ErrorChange::new(seen, &after, &edits, chosen);
        let grows = errors(&after).count() > errors(seen).count();
        if !change.fixes_all() || grows && !change.only_reveals() {
            return Err(Harm::Errors);
        }
        let proof = match fixes.into_iter().all(|fix| Allow::Safe.permits(fix)) {
            true => (self.compare)(seen, &after),
            false => Proof::Unknown,
        };
        if proof == Proof::Refuted {
            return Err(Harm::Image);
        }
        let mut next = fixed.clone();
        let offset = |address: u32| fixed.origin(address.saturating_sub(base));
        next.applied.extend(chosen.iter().map(|d| {
            let span = Span::new(offset(d.span.start), offset(d.span.end));
            Diagnostic {
                span,
                ..(*d).clone()
            }
        }));
        next.proofs.resize(next.applied.len(), proof);
        for edit in &mut edits {
            edit.span = Span::new(edit.span.start - base, edit.span.end - base);
        }
        edits.sort_by_key(|e| e.span);
        next.rounds.push(Moves::of(&edits));
        next.text = text;
        Ok((next, after))
    }
}

/// Converts the line breaks of inserted text to those of the file.
fn end_lines_alike(edits: &mut [Edit], text: &str) {
    let first = text.find('\n').and_then(|end| text.get(..end));
    if first.is_some_and(|line| line.ends_with('\r')) {
        for edit in edits {
            edit.text = edit.text.replace("\r\n", "\n").replace('\n', "\r\n");
        }
    }
}

/// Replaces a fix that would remove a comment with a help of the same words. `comments` are in the order
/// of the text.
pub fn keep_comments(sources: &Sources, comments: &[Span], diagnostic: &mut Diagnostic) {
    let loses = |edit: &Edit| {
        // A copy of a comment may be removed with the copy of its code.
        let others = LazyCell::new(|| {
            let others = comments.iter().filter(|o| !edit.span.contains(**o));
            others.map(|o| sources.text(*o)).collect::<FxHashSet<_>>()
        });
        let is_copied = |c: &Span, text: &str| {
            edit.text.is_empty() && edit.span.contains(*c) && others.contains(text)
        };
        let first = comments.partition_point(|c| c.end <= edit.span.start);
        let touched = comments.iter().skip(first);
        let mut touched = touched.take_while(|c| c.start < edit.span.end);
        // An insertion loses nothing.
        !edit.span.is_empty()
            && touched.any(|c| {
                let text = sources.text(*c);
                (text.is_empty() || !edit.text.contains(text) || !edit.span.contains(*c))
                    && !is_copied(c, text)
            })
    };
    if let Some(fix) = diagnostic.fix.take_if(|f| f.edits.iter().any(loses)) {
        diagnostic.help.push(fix.title);
    }
}

/// The findings, in order, with fixes that touch no span of an earlier chosen fix. The same fix offered
/// twice counts once.
fn choose<'a>(diagnostics: &[&'a Diagnostic], span: Span, allow: Allow) -> Vec<&'a Diagnostic> {
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

/// Whether a span touches one of `taken`, which are sorted and disjoint.
fn is_taken(taken: &[Span], span: Span) -> bool {
    let at = taken.partition_point(|t| t.start < span.start);
    let touches = |t: &Span| t.start <= span.end && span.start <= t.end;
    let before = at.checked_sub(1).and_then(|i| taken.get(i));
    before.is_some_and(touches) || taken.get(at).is_some_and(touches)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::checked_spans::CheckedSpans;
    use shaderlint_diagnostic::{Origin, Severity, error};

    fn info(span: Span) -> Diagnostic {
        Diagnostic::new("letter", Origin::Rule, Severity::Info, span, "a")
    }

    fn with(text: &str, diagnostics: Vec<Diagnostic>) -> Look {
        Look {
            diagnostics,
            span: Span::new(0, text.len() as u32),
            checked_spans: None,
            size: 0,
            shaders: Vec::new(),
        }
    }

    /// Each `a` has the fix `b`; each `bb` is two errors without a fix.
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
        Some(with(text, diagnostics))
    }

    #[test]
    fn as_many_fixes_as_possible_are_applied() {
        let check = |text, look: fn(&str) -> Option<Look>, expected: &str, count| {
            let fixed = fix(text, Allow::Safe, look, without_images);
            let found = (&*fixed.text, fixed.applied.len());
            assert_eq!(found, (expected, count), "{text}");
        };
        check("a.a.a", look, "b.b.b", 3);
        // Fixes that add findings are not kept, and do not prevent others.
        check("aa", look, "ba", 1);
        check("a.a.ab.a.a", look, "b.b.ab.b.b", 4);
        // Fixes that overlap are applied in separate rounds.
        check("((a))+(b)", brackets, "a+b", 3);
    }

    #[test]
    fn one_bad_fix_among_many_costs_few_checks() {
        let text = format!("{}ab.{}", "a.".repeat(500), "a.".repeat(500));
        let mut looks = 0;
        let count = |text: &str| {
            looks += 1;
            look(text)
        };
        let fixed = fix(&text, Allow::Safe, count, without_images);
        assert_eq!(fixed.applied.len(), 1000);
        assert!(looks < 40, "{looks} looks");
    }

    /// All fixes but one change the image: they are not applied, even with `Allow::Unsafe`.
    #[test]
    fn fixes_that_change_the_image_are_not_applied() {
        let compare = |_: &Look, after: &Look| match after.diagnostics.len() {
            0..4 => Proof::Refuted,
            _ => Proof::SameBits,
        };
        for allow in [Allow::Safe, Allow::Unsafe] {
            let fixed = fix("a.a.a.a.a", allow, look, compare);
            assert_eq!(fixed.text, "b.a.a.a.a");
            assert_eq!(fixed.proofs, [Proof::SameBits]);
            let left: Vec<u32> = fixed.left.iter().map(|d| d.span.start).collect();
            assert_eq!(left, [2, 4, 6, 8]);
        }
    }

    /// Each `(x)` has a fix that removes its brackets and overlaps with those inside.
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
        Some(with(text, diagnostics))
    }

    #[test]
    fn applied_fixes_have_positions_in_the_original_text() {
        let fixed = fix("((a))+(b)", Allow::Safe, brackets, without_images);
        let places: Vec<&str> = fixed
            .applied
            .iter()
            .filter_map(|d| "((a))+(b)".get(d.span.start as usize..d.span.end as usize))
            .collect();
        assert_eq!(places, ["(a)", "(b)", "((a))"]);
    }

    /// `a` has the fix `b`; a `c` after an `a` is hidden, any other is an error.
    fn hiding(text: &str) -> Option<Look> {
        let mut look = with(text, Vec::new());
        let mut checked_spans = CheckedSpans::default();
        let mut hidden = false;
        for (i, c) in text.char_indices() {
            let span = Span::new(i as u32, i as u32 + 1);
            hidden |= c == 'a';
            let error = || Diagnostic::error(error::UNDECLARED_NAME, span, "x");
            if hidden {
                checked_spans.left.push(span)
            } else {
                checked_spans.done.push(span)
            }
            match c {
                'a' => {
                    let fix = Fix::safe("b", vec![Edit::replace(span, "b")]);
                    look.diagnostics.push(error().fix(fix));
                }
                // An error that the edit causes before itself.
                'd' if text.contains('b') => look.diagnostics.push(error()),
                'c' if !hidden => look.diagnostics.push(error()),
                _ => {}
            }
        }
        look.checked_spans = Some(checked_spans);
        Some(look)
    }

    #[test]
    fn fixes_may_uncover_findings() {
        let fixed = |text| fix(text, Allow::Safe, hiding, without_images).text;
        assert_eq!(fixed("acc"), "bcc");
        assert_eq!(fixed("ddacc"), "ddacc");
    }

    /// `a` is an error with the fix `b`, which fails before another `b`.
    #[test]
    fn fixes_that_fail_on_their_own_are_not_applied() {
        let errors = |text: &str| {
            let mut look = look(text)?;
            for found in &mut look.diagnostics {
                found.severity = Severity::Error;
            }
            Some(look)
        };
        let check = |text: &str| {
            let seen = errors(text).unwrap();
            let failing = failing_fixes(text, &seen, |d| d.span.start != 4, errors);
            failing.iter().map(|d| d.span.start).collect::<Vec<_>>()
        };
        assert_eq!(check("a.a."), [0; 0]);
        assert_eq!(check("a.ab.ab"), [2, 5]);
        assert_eq!(check("a..ab"), [3]);
        assert_eq!(check("a...ab"), [0; 0]);
        // Another error, reported at the start, has no fix.
        assert_eq!(check("a.bb"), [0]);
        assert_eq!(check(".\na.bb"), [0; 0]);
        // Fixes that are not tried are offered.
        let long = format!("ab{}", ".".repeat(MAX_OFFERED));
        assert_eq!(check(&long), [0; 0]);
    }

    #[test]
    fn fixes_that_remove_comments_become_help() {
        let mut sources = Sources::new();
        let text = "a /* b */ c";
        sources.add("a", None, shaderlint_text::Role::User, text);
        let check = |edit: Edit| {
            let mut found = info(Span::new(0, 1)).fix(Fix::safe("do it", vec![edit]));
            keep_comments(&sources, &[Span::new(2, 9)], &mut found);
            (found.fix.is_some(), found.help)
        };
        let kept = (true, Vec::new());
        assert_eq!(check(Edit::delete(Span::new(0, 2))), kept);
        assert_eq!(check(Edit::delete(Span::new(9, 11))), kept);
        assert_eq!(check(Edit::replace(Span::new(0, 11), "x /* b */")), kept);
        let refused = (false, vec!["do it".to_string()]);
        assert_eq!(check(Edit::delete(Span::new(0, 3))), refused);
        assert_eq!(check(Edit::replace(Span::new(0, 11), "x")), refused);
    }

    #[test]
    fn unsafe_fixes_are_applied_on_request_only() {
        let unsafe_look = |text: &str| {
            let mut look = look(text)?;
            for fix in look.diagnostics.iter_mut().filter_map(|d| d.fix.as_mut()) {
                fix.applicability = Applicability::Unsafe;
            }
            Some(look)
        };
        let fixed = |allow| fix("a", allow, unsafe_look, without_images).text;
        assert_eq!(fixed(Allow::Safe), "a");
        assert_eq!(fixed(Allow::Unsafe), "b");
    }
}
