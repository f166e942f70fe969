//! The fix engine: which fixes of one look at a text go together, and their repetition until
//! nothing is left to mend.

use super::Judged;
use crate::diagnostic::{Applicability, Diagnostic, Fix, Severity, error};
use crate::text::{Edit, Sources, Span, apply_edits};

/// Most looks that are taken at one text.
const MAX_ROUNDS: usize = 16;
/// Most work that is done again for the fixes of one text, in bytes of text. What is left over then
/// stays a finding: a text of a megabyte gets two looks, one of ten kilobytes two hundred.
const MAX_LOOKED: usize = 2_000_000;
/// What a token or macro call costs, in bytes of text.
const TOKEN_COST: usize = 4;

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
    /// What of the text was judged; `None` stands for all of it.
    pub judged: Option<Judged>,
    /// How many tokens and macro calls were read.
    pub size: usize,
}

/// A text after its fixes.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Fixed {
    /// The text.
    pub text: String,
    /// The findings whose fixes were applied. Their spans are offsets in the text as it was at first;
    /// labels and fixes still have the addresses of their own look.
    pub applied: Vec<Diagnostic>,
    /// What each round did to places in the text.
    rounds: Vec<Moves>,
}

impl Fixed {
    /// A text in which nothing is mended.
    fn unchanged(text: &str) -> Fixed {
        Fixed {
            text: text.to_string(),
            applied: Vec::new(),
            rounds: Vec::new(),
        }
    }

    /// The offset in the text as it was at first of one in the text as it is now.
    fn origin(&self, offset: u32) -> u32 {
        let rounds = self.rounds.iter().rev();
        rounds.fold(offset, |offset, moves| moves.before(offset))
    }
}

/// Where places behind edits come from; there may be very many of both.
#[derive(Clone, PartialEq, Eq, Debug)]
struct Moves(Vec<Move>);

/// What one edit does to places.
#[derive(Clone, PartialEq, Eq, Debug)]
struct Move {
    /// Where what it put in stands behind all edits.
    inserted: Span,
    /// Where what it took away stood before them.
    from: u32,
    /// Bytes that it and all before it took away, and put in.
    removed: u32,
    added: u32,
}

impl Moves {
    /// Those of edits that are in order.
    fn of(edits: &[Edit]) -> Moves {
        let (mut removed, mut added) = (0, 0);
        let one = |edit: &Edit| {
            let start = edit.span.start + added - removed;
            let length = edit.text.len() as u32;
            (removed, added) = (removed + edit.span.len(), added + length);
            Move {
                inserted: Span::new(start, start + length),
                from: edit.span.start,
                removed,
                added,
            }
        };
        Moves(edits.iter().map(one).collect())
    }

    /// The offset before the edits of one behind them. What was put in comes from the start of what
    /// it took the place of.
    fn before(&self, offset: u32) -> u32 {
        let behind = self.0.partition_point(|m| m.inserted.start <= offset);
        match behind.checked_sub(1).and_then(|i| self.0.get(i)) {
            None => offset,
            Some(last) if offset < last.inserted.end => last.from,
            Some(last) => offset + last.removed - last.added,
        }
    }

    /// Whether an offset behind the edits lies in what they put in.
    fn has_inserted(&self, offset: u32) -> bool {
        let behind = self.0.partition_point(|m| m.inserted.start <= offset);
        let last = behind.checked_sub(1).and_then(|i| self.0.get(i));
        last.is_some_and(|m| offset < m.inserted.end)
    }
}

/// Applies fixes until there are none, or none that helps.
///
/// In each round the fixes of one look are applied, those left out that touch others. A fix is kept
/// where it makes no error: those that come to light behind it do not count, where nothing could be
/// said of their places before. Fixes that would make one are found and left out.
pub fn fix(text: &str, allow: Allow, mut look: impl FnMut(&str) -> Option<Look>) -> Fixed {
    match look(text) {
        Some(seen) => fix_seen(text, seen, allow, look),
        None => Fixed::unchanged(text),
    }
}

/// Applies fixes to a text that has been looked at: first the safe ones, and then, where they may be
/// applied, the others too; so what the safe ones mend does not depend on the others.
pub fn fix_seen(
    text: &str,
    mut seen: Look,
    allow: Allow,
    look: impl FnMut(&str) -> Option<Look>,
) -> Fixed {
    let mut engine = Engine {
        look,
        left: MAX_LOOKED,
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
                // What another fix brought to light may have a safe one.
                Allow::Unsafe => next.or_else(|| engine.round(&fixed, &seen, step)),
            };
            let Some(next) = next else {
                break;
            };
            (fixed, seen) = next;
        }
    }
    fixed
}

struct Engine<F> {
    look: F,
    /// How many bytes may still be looked at.
    left: usize,
}

/// What a round gives: the fixes that it kept, and what became of the text.
struct Kept<'a> {
    fixes: Vec<&'a Diagnostic>,
    after: Option<(Fixed, Look)>,
}

impl<F: FnMut(&str) -> Option<Look>> Engine<F> {
    /// One round: all fixes that go together, without those that do harm. Where all of them do,
    /// those that they stood in the way of.
    fn round(&mut self, fixed: &Fixed, seen: &Look, allow: Allow) -> Option<(Fixed, Look)> {
        let mut open: Vec<&Diagnostic> = seen.diagnostics.iter().collect();
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

    /// What becomes of a text by all of `fixes` that do no harm.
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
        // Halves are tried where the whole does harm, so that one bad fix among many costs few
        // looks.
        let mut todo = vec![fixes];
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

    /// The text after some fixes, if it is another one and they make no error.
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
        self.left = self.left.checked_sub(text.len())?;
        let after = (self.look)(&text)?;
        // Macros make much of little text.
        let expanded = (after.size * TOKEN_COST).saturating_sub(text.len());
        self.left = self.left.saturating_sub(expanded);
        let change = Change::new(seen, &after, &edits, mended);
        let grows = errors(&after).count() > errors(seen).count();
        if !change.mends() || grows && !change.only_reveals() {
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
        next.rounds.push(Moves::of(&edits));
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

fn errors(look: &Look) -> impl Iterator<Item = &Diagnostic> {
    let all = look.diagnostics.iter();
    all.filter(|d| d.severity == Severity::Error)
}

/// What edits do to the errors of a text.
struct Change<'a> {
    seen: &'a Look,
    after: &'a Look,
    moves: Moves,
    mended: &'a [&'a Diagnostic],
}

impl<'a> Change<'a> {
    fn new(
        seen: &'a Look,
        after: &'a Look,
        edits: &[Edit],
        mended: &'a [&'a Diagnostic],
    ) -> Change<'a> {
        let mut edits: Vec<Edit> = edits.to_vec();
        for edit in &mut edits {
            edit.span.start -= seen.span.start;
            edit.span.end -= seen.span.start;
        }
        edits.sort_by_key(|e| e.span);
        Change {
            seen,
            after,
            moves: Moves::of(&edits),
            mended,
        }
    }

    /// The place before the edits of an error behind them.
    fn origin(&self, d: &Diagnostic) -> Span {
        let of = |address: u32| {
            let offset = address.saturating_sub(self.after.span.start);
            self.seen.span.start + self.moves.before(offset)
        };
        Span::new(of(d.span.start), of(d.span.end))
    }

    /// Whether an error was there before at the same place, and was not one to mend.
    fn is_known(&self, d: &Diagnostic, place: Span) -> bool {
        let is_same = |s: &Diagnostic| {
            s.span.start == place.start && s.rule == d.rule && s.message == d.message
        };
        errors(self.seen).any(|s| is_same(s) && !self.mended.iter().any(|m| std::ptr::eq(*m, s)))
    }

    /// Whether the errors that the edits are for are gone, and have not only moved.
    fn mends(&self) -> bool {
        let remains = |d: &Diagnostic| {
            let place = self.origin(d);
            let is_at = |m: &&Diagnostic| {
                let mut edits = m.fix.iter().flat_map(|f| &f.edits);
                let whole = edits.clone().fold(m.span, |all, e| all.to(e.span));
                let is_error = m.severity == Severity::Error && m.rule == d.rule;
                let is_inside = whole.start <= place.start && place.start < whole.end;
                is_error && (is_inside || edits.any(|e| e.span.start == place.start))
            };
            self.mended.iter().any(is_at) && !self.is_known(d, place)
        };
        !errors(self.after).any(remains)
    }

    /// Whether the errors that are there besides were hidden before: each stands where the code
    /// could not be judged, and not in what was put in.
    fn only_reveals(&self) -> bool {
        let Some(judged) = &self.seen.judged else {
            return false;
        };
        errors(self.after).all(|d| {
            let place = self.origin(d);
            let offset = d.span.start.saturating_sub(self.after.span.start);
            let is_hidden = !self.moves.has_inserted(offset) && !judged.has_seen(place);
            self.is_known(d, place) || (is_hidden && !SYNTAX.contains(&d.rule))
        })
    }
}

/// What the parser and the preprocessor say. They judge all that they read.
const SYNTAX: &[&str] = &[
    error::SYNTAX_ERROR,
    error::MISSING_SEMICOLON,
    error::UNCLOSED_DELIMITER,
    error::STRAY_SEMICOLON,
    error::UNBALANCED_CONDITIONAL,
    error::UNTERMINATED_COMMENT,
    error::INVALID_CHARACTER,
    error::BAD_DIRECTIVE,
    error::MACRO_ARGUMENTS,
    error::LOCAL_FUNCTION,
];

/// Takes the fix away from a finding where it would take a comment away, and tells it in words
/// instead. The comments are in the order of the text.
pub fn keep_comments(sources: &Sources, comments: &[Span], diagnostic: &mut Diagnostic) {
    let loses = |edit: &Edit| {
        let first = comments.partition_point(|c| c.end <= edit.span.start);
        let touched = comments.iter().skip(first);
        let mut touched = touched.take_while(|c| c.start < edit.span.end);
        touched.any(|c| {
            let text = sources.text(*c);
            text.is_empty() || !edit.text.contains(text) || !edit.span.contains(*c)
        })
    };
    if let Some(fix) = diagnostic.fix.take_if(|f| f.edits.iter().any(loses)) {
        diagnostic.help.push(fix.title);
    }
}

/// The fixes that go together: in the order of the text, each of which touches nothing that one
/// before it touches. The same fix offered twice counts once.
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
        Some(Look {
            diagnostics,
            span,
            judged: None,
            size: 0,
        })
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
        Some(Look {
            diagnostics,
            span,
            judged: None,
            size: 0,
        })
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

    /// `a` can be written `b`; a `c` behind an `a` is not seen, any other is an error.
    fn hiding(text: &str) -> Option<Look> {
        let mut look = Look {
            diagnostics: Vec::new(),
            span: Span::new(0, text.len() as u32),
            judged: None,
            size: 0,
        };
        let mut judged = Judged::default();
        let mut hidden = false;
        for (i, c) in text.char_indices() {
            let span = Span::new(i as u32, i as u32 + 1);
            hidden |= c == 'a';
            let error = || Diagnostic::error(error::UNDECLARED_NAME, span, "x");
            if hidden {
                judged.left.push(span)
            } else {
                judged.done.push(span)
            }
            match c {
                'a' => {
                    let fix = Fix::safe("b", vec![Edit::replace(span, "b")]);
                    look.diagnostics.push(error().fix(fix));
                }
                // What the edit brings about before itself.
                'd' if text.contains('b') => look.diagnostics.push(error()),
                'c' if !hidden => look.diagnostics.push(error()),
                _ => {}
            }
        }
        look.judged = Some(judged);
        Some(look)
    }

    #[test]
    fn what_comes_to_light_is_no_reason_to_refuse() {
        assert_eq!(fix("acc", Allow::Safe, hiding).text, "bcc");
        assert_eq!(fix("ddacc", Allow::Safe, hiding).text, "ddacc");
    }

    #[test]
    fn comments_stay() {
        let mut sources = Sources::new();
        let text = "a /* b */ c";
        sources.add("a", None, crate::text::Role::User, text);
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
    fn offsets_go_back_through_edits() {
        let edits = [
            Edit::insert(2, "xx"),
            Edit::replace(Span::new(4, 6), "y"),
            Edit::delete(Span::new(8, 10)),
        ];
        let moves = Moves::of(&edits);
        // "0123456789ab" became "01xx23y67ab".
        let back: Vec<u32> = (0..11).map(|i| moves.before(i)).collect();
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
