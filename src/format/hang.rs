//! The indentation of continuation lines.

use super::item::FormatItem;
use super::place::LineLayout;
use super::spacing::is_assignment;
use shaderlint_syntax::TokenKind as T;

/// Maximum number of items before the value that a statement assigns.
const HEAD: usize = 16;
/// The width of a `:` and the space after it.
const COLON: u32 = 2;

impl LineLayout<'_> {
    /// The column of a continuation line, and the item with which it is aligned.
    pub(super) fn continuation(&mut self, at: usize, item: &FormatItem) -> (u32, Option<u32>) {
        if let Some(anchor) = item.anchor {
            let moved = self.item(anchor as usize).map_or(0, |i| i.column);
            let column = item.column + self.placed(anchor as usize).column;
            return (column.saturating_sub(moved), Some(anchor));
        }
        let closes = self.role(at).partner.is_some_and(|p| (p as usize) < at);
        match self.lined_up(at, item).filter(|_| !closes) {
            Some(other) => (self.placed(other).column, Some(other as u32)),
            None => self.hanging(at),
        }
    }

    /// The column of a continuation line as determined by the brackets and operators around it.
    pub(super) fn hanging(&self, at: usize) -> (u32, Option<u32>) {
        if let Some(head) = self.chain(at) {
            let condition = self.placed(head);
            let is_far = condition.column > self.style.width * 2 / 5;
            if !is_far
                && condition.breaks == 0
                && condition.column >= self.point.statement_column + COLON
            {
                return (condition.column - COLON, Some(head as u32));
            }
        }
        let (column, depends_on) = self.hanging_in_bracket(at);
        let steps = self.steps.get(at).copied().unwrap_or(0);
        (
            column + u32::from(steps) * self.style.indent.width(),
            depends_on,
        )
    }

    fn hanging_in_bracket(&self, at: usize) -> (u32, Option<u32>) {
        let indent = self.style.indent.width();
        let Some(open) = self.role(at).bracket.map(|b| b as usize) else {
            // The bracket of a list that starts a line is not indented, like that of a block.
            let is_list = |open: &FormatItem| open.is(T::LeftParen) || open.is(T::LeftBrace);
            let next = self.item(at + 1).is_some_and(|next| next.breaks > 0);
            let is_close = self
                .role(at)
                .partner
                .is_some_and(|open| (open as usize) < at);
            if self.item(at).is_some_and(is_list) && next || is_close {
                return (self.point.statement_column, None);
            }
            return (self.point.statement_column + indent, None);
        };
        let bracket = self.placed(open);
        let line = self.starts.get(bracket.line as usize).copied().unwrap_or(0);
        let column = self.placed(line).column;
        // After a bracket at the end of a line there is nothing to align with.
        let is_last = open + 1 == at || self.placed(open + 1).line != bracket.line;
        let is_far = bracket.column > self.style.width * 2 / 5;
        let closes = self.role(at).partner == Some(open as u32);
        match (is_last || is_far, closes) {
            (true, true) => (column, None),
            (true, false) => (column + indent, None),
            (false, _) => (bracket.column + 1, Some(open as u32)),
        }
    }

    /// The item with which the author aligned this one: one on the line above, or the start of the
    /// last line of the same kind.
    fn lined_up(&mut self, at: usize, item: &FormatItem) -> Option<usize> {
        if let Some(sibling) = self.sibling(at).and_then(|s| *s)
            && let sibling = sibling as usize
            && self
                .item(sibling)
                .is_some_and(|i| i.column == item.column && i.breaks > 0)
        {
            return Some(sibling);
        }
        let line = self.before(at)?.line;
        let above = self
            .items
            .iter()
            .enumerate()
            .take(at)
            .skip(self.point.statement);
        let above = above.rev().take_while(|(_, i)| i.line == line);
        let mut above = above.filter(|(i, _)| *i != self.point.statement);
        let may_be_aligned = |kind| !matches!(kind, T::LeftParen | T::RightParen | T::Comma);
        let found =
            above.find(|(_, i)| i.column == item.column && i.token().is_some_and(may_be_aligned));
        // If the line above was broken, that item may be further up now.
        let last = self.starts.len().saturating_sub(1) as u32;
        let found = found.map(|(i, _)| i);
        found.filter(|i| self.placed(*i).line == last).or_else(|| {
            self.value(at)
                .filter(|i| self.item(*i).is_some_and(|i| i.column == item.column))
        })
    }

    /// The first item of the value that a statement assigns or returns, for a line outside brackets.
    fn value(&self, at: usize) -> Option<usize> {
        if self.role(at).bracket.is_some() {
            return None;
        }
        let start = self.point.statement;
        let items = self.items.iter().enumerate().take(at).skip(start);
        let mut tokens = items.take(HEAD).map(|(i, item)| (i, item.token()));
        let is_head = |kind: T| kind == T::Return || is_assignment(kind);
        let (head, _) = tokens.find(|(_, kind)| kind.is_some_and(is_head))?;
        (head + 1 < at).then_some(head + 1)
    }
}
