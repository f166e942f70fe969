//! Breaks lines that are too long.

use super::place::{ItemPlace, LineLayout};
use super::request::Lines;
use super::spacing::{is_assignment, precedence};
use super::structure::StatementStart;
use shaderlint_syntax::TokenKind as T;

impl LineLayout<'_> {
    /// Breaks the current line if an item exceeds the width.
    pub(super) fn fit(&mut self, at: usize) {
        if self.end <= self.style.width || self.lines == Lines::Kept || self.inline.is_some() {
            return;
        }
        if self.item(at).is_none_or(|i| i.is_comment()) {
            return;
        }
        while self.end > self.style.width {
            let Some(from) = self.best_break(at) else {
                self.scanned = at;
                return;
            };
            self.break_before(from);
            for i in from + 1..=at {
                if let Some(item) = self.items.get(i) {
                    self.go_on(i, item);
                }
            }
        }
    }

    /// Starts a new line before an item, although the source does not.
    fn break_before(&mut self, at: usize) {
        let Some(item) = self.items.get(at) else {
            return;
        };
        let (column, depends_on) = self.hanging(at);
        let level = self.role(at).level;
        let place = ItemPlace {
            breaks: 1,
            column,
            level,
            depends_on,
            ..ItemPlace::default()
        };
        self.put(at, place);
        self.new_line(at);
        self.finish(item, column);
    }

    /// The best position to break the line before the end of `at`: the outermost one, and the last
    /// of several, such that the part before it fits and is not too short; if none fits, the first.
    fn best_break(&self, at: usize) -> Option<usize> {
        let start = self.line_column();
        let width = self.style.width;
        let candidates = (self.scanned + 1..=at).filter_map(|i| {
            let before = self.item(i - 1).map_or(0, |i| i.width);
            let end = self.placed(i - 1).column + before;
            let is_stub = 3 * end.saturating_sub(start) < width.saturating_sub(start);
            let cost = self.cost(i)?;
            Some(match end <= width {
                true => ((0, is_stub, cost, usize::MAX - i), i),
                false => ((1, false, 0, i), i),
            })
        });
        candidates.min().map(|(_, i)| i)
    }

    /// The cost of a line break before an item; `None` where it is not allowed.
    fn cost(&self, at: usize) -> Option<u32> {
        let (item, before, role) = (self.item(at)?, self.before(at)?, self.role(at));
        let (kind, before_kind) = (item.token()?, before.token()?);
        if role.start != StatementStart::Nothing || item.keeps || self.labels(at) {
            return None;
        }
        /// Higher than any other cost; a statement has at most 200 nested brackets.
        const LAST: u32 = 1 << 16;
        let inner = match before_kind {
            _ if kind == T::Semicolon => return None,
            T::Semicolon => 0,
            T::Comma => 1,
            before if is_assignment(before) => LAST,
            T::LeftParen if kind != T::RightParen => return Some(2 * LAST - role.depth),
            _ if item.is_prefix => return None,
            _ => precedence(kind)?,
        };
        Some(role.depth * 32 + inner)
    }

    /// Whether an item belongs to a label.
    fn labels(&self, at: usize) -> bool {
        self.role(at).is_label || self.role(self.statement).start == StatementStart::Label
    }
}
