//! How edits move offsets and change the errors of a text.

use super::look::Look;
use shaderlint_diagnostic::{Diagnostic, Facet, Severity};
use shaderlint_text::{Edit, Span};

/// Maps offsets after edits to offsets before them; both may be very many.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct Moves(Vec<Move>);

/// How one edit moves offsets.
#[derive(Clone, PartialEq, Eq, Debug)]
struct Move {
    /// Span of the inserted text after all edits.
    inserted: Span,
    /// Start of the removed text before all edits.
    from: u32,
    /// Bytes removed and inserted by this edit and all before it.
    removed: u32,
    added: u32,
}

impl Moves {
    /// The moves of sorted edits.
    pub fn of(edits: &[Edit]) -> Moves {
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

    /// Maps an offset after the edits to one before them. Inserted text maps to the start of the text
    /// that it replaces.
    pub fn before(&self, offset: u32) -> u32 {
        let after = self.0.partition_point(|m| m.inserted.start <= offset);
        match after.checked_sub(1).and_then(|i| self.0.get(i)) {
            None => offset,
            Some(last) if offset < last.inserted.end => last.from,
            Some(last) => offset + last.removed - last.added,
        }
    }

    /// Whether an offset after the edits is in inserted text.
    fn has_inserted(&self, offset: u32) -> bool {
        let after = self.0.partition_point(|m| m.inserted.start <= offset);
        let last = after.checked_sub(1).and_then(|i| self.0.get(i));
        last.is_some_and(|m| offset < m.inserted.end)
    }
}

/// The errors among the findings of a checked text.
pub(super) fn errors(look: &Look) -> impl Iterator<Item = &Diagnostic> {
    let all = look.diagnostics.iter();
    all.filter(|d| d.severity == Severity::Error)
}

/// Compares the errors of a text before and after edits.
pub(super) struct ErrorChange<'a> {
    seen: &'a Look,
    after: &'a Look,
    moves: Moves,
    fixed: &'a [&'a Diagnostic],
}

impl<'a> ErrorChange<'a> {
    pub fn new(
        seen: &'a Look,
        after: &'a Look,
        edits: &[Edit],
        fixed: &'a [&'a Diagnostic],
    ) -> ErrorChange<'a> {
        let mut edits: Vec<Edit> = edits.to_vec();
        for edit in &mut edits {
            edit.span.start -= seen.span.start;
            edit.span.end -= seen.span.start;
        }
        edits.sort_by_key(|e| e.span);
        ErrorChange {
            seen,
            after,
            moves: Moves::of(&edits),
            fixed,
        }
    }

    /// The span before the edits of an error found after them.
    fn origin(&self, d: &Diagnostic) -> Span {
        let of = |address: u32| {
            let offset = address.saturating_sub(self.after.span.start);
            self.seen.span.start + self.moves.before(offset)
        };
        Span::new(of(d.span.start), of(d.span.end))
    }

    /// The same error before the edits, if they were not meant to fix it.
    fn known(&self, d: &Diagnostic, place: Span) -> Option<&'a Diagnostic> {
        let is_same = |s: &Diagnostic| {
            s.span.start == place.start && s.rule == d.rule && s.message == d.message
        };
        errors(self.seen).find(|s| is_same(s) && !self.fixed.iter().any(|m| std::ptr::eq(*m, *s)))
    }

    fn is_known(&self, d: &Diagnostic, place: Span) -> bool {
        self.known(d, place).is_some()
    }

    /// Whether the edits remove the errors that they fix, instead of only moving them.
    pub fn fixes_all(&self) -> bool {
        let remains = |d: &Diagnostic| {
            let place = self.origin(d);
            let is_at = |m: &&Diagnostic| {
                let mut edits = m.fix.iter().flat_map(|f| &f.edits);
                let extent = edits.clone().fold(m.span, |all, e| all.to(e.span));
                let is_error = m.severity == Severity::Error && m.rule == d.rule;
                let is_inside = extent.start <= place.start && place.start < extent.end;
                is_error && (is_inside || edits.any(|e| e.span.start == place.start))
            };
            self.fixed.iter().any(is_at) && !self.is_known(d, place)
        };
        !errors(self.after).any(remains)
    }

    /// Whether a line that the edits change has another error for which there is no fix: a new one, or one
    /// that was there before, of the same mistake.
    pub fn leaves_line_broken(&self, text: &str) -> bool {
        let line = |address: u32| {
            let offset = address.saturating_sub(self.seen.span.start) as usize;
            let before = text.get(..offset).unwrap_or(text);
            before.rfind('\n')
        };
        let edits = self
            .fixed
            .iter()
            .flat_map(|d| &d.fix)
            .flat_map(|f| &f.edits);
        let lines: Vec<Option<usize>> = edits.map(|e| line(e.span.start)).collect();
        errors(self.after).any(|d| {
            let place = self.origin(d);
            let is_fixable = self
                .known(d, place)
                .is_some_and(|known| known.fix.is_some());
            !is_fixable && lines.contains(&line(place.start))
        })
    }

    /// Whether all new errors were hidden before: each is where the code could not be checked, and not
    /// in inserted text.
    pub fn only_reveals(&self) -> bool {
        let Some(checked_spans) = &self.seen.checked_spans else {
            return false;
        };
        errors(self.after).all(|d| {
            let place = self.origin(d);
            let offset = d.span.start.saturating_sub(self.after.span.start);
            let is_hidden = !self.moves.has_inserted(offset) && !checked_spans.has_seen(place);
            self.is_known(d, place) || (is_hidden && !d.has(Facet::Reads))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn offsets_are_mapped_back_through_edits() {
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
}
