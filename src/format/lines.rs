//! Decides where lines end.

use super::item::{FormatItem, ItemKind};
use super::place::LineLayout;
use super::request::{Lines, TextExtent};
use super::structure::{ItemRole, StatementStart};
use super::style::Brace;
use shaderlint_syntax::TokenKind as T;

/// The gap between an item and the one before it.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Gap {
    /// No line break.
    Line,
    /// A line break; the line is indented to the level of the item.
    Level,
    /// A line break within a statement.
    Inside,
    /// The original white space.
    Kept,
}

impl LineLayout<'_> {
    /// The gap before an item.
    pub(super) fn gap(&self, at: usize, item: &FormatItem) -> Gap {
        let Some(before) = self.before(at) else {
            return match (self.extent, item.breaks) {
                _ if item.keeps => Gap::Kept,
                (TextExtent::Inside, 0) => Gap::Kept,
                _ => Gap::Level,
            };
        };
        if item.keeps {
            return Gap::Kept;
        }
        let start = self.role(at).start;
        let inside = match start {
            StatementStart::Nothing => Gap::Inside,
            _ => Gap::Level,
        };
        if matches!(item.kind, ItemKind::Directive(_) | ItemKind::Idle) {
            return Gap::Level;
        }
        if before.ends_line() {
            return inside;
        }
        if self.lines == Lines::Kept || item.is_comment() {
            return match item.breaks {
                0 => Gap::Line,
                _ => inside,
            };
        }
        if self.point.inline.is_some_and(|end| at <= end) {
            return Gap::Line;
        }
        // A comment stays on the line of the code that follows it.
        if before.is_comment() && item.breaks == 0 && self.begins_line(at - 1) {
            return Gap::Line;
        }
        match start {
            StatementStart::Nothing => self.gap_inside(at, item, before),
            StatementStart::Comment => Gap::Level,
            StatementStart::Statement | StatementStart::Label => self.gap_statement(at, item),
            StatementStart::Body => {
                let is_split = self.point.split.is_some()
                    && self.point.split == self.role(at).level.checked_sub(1);
                let is_header_broken = self.starts.last().is_some_and(|first| {
                    *first > self.point.statement
                        && self.item(*first).is_some_and(|i| i.breaks == 0)
                });
                let stays = item.breaks == 0 && !is_split && !is_header_broken;
                match stays && self.ends_here(at) {
                    true => Gap::Line,
                    false => Gap::Level,
                }
            }
            StatementStart::Tail => self.gap_tail(at, item, before),
            StatementStart::Open => match self.style.brace {
                Brace::Same => Gap::Line,
                Brace::Next if self.stays_inline(at, self.point.end + 1) => Gap::Line,
                Brace::Next => Gap::Level,
            },
            StatementStart::Close => Gap::Level,
        }
    }

    /// Whether the construct that starts here fits on this line, as far as it was on one line in
    /// the source.
    fn ends_here(&self, at: usize) -> bool {
        let end = self.role(at).end.map_or(at, |end| end as usize);
        // A body of several lines is measured up to its first line break.
        let items = self.items.iter().enumerate().take(end + 1).skip(at + 1);
        let mut lines = items.take(self.style.width as usize);
        let broken = lines.find(|(_, item)| item.breaks > 0).map(|(i, _)| i - 1);
        self.fits(at, broken.unwrap_or(end), self.point.end + 1)
    }

    fn gap_inside(&self, at: usize, item: &FormatItem, before: &FormatItem) -> Gap {
        match item.breaks > 0 && !self.joins(at, item, before) {
            true => Gap::Inside,
            false => Gap::Line,
        }
    }

    /// Whether an item inside a statement always stays on the line of the one before it.
    pub(super) fn joins(&self, at: usize, item: &FormatItem, before: &FormatItem) -> bool {
        let is_else_if = item.is(T::If) && before.is(T::Else);
        is_else_if
            || self.role(at - 1).start == StatementStart::Close
            || self.joined.get(at) == Some(&true)
    }

    fn gap_statement(&self, at: usize, item: &FormatItem) -> Gap {
        if let Some(last) = self.filled.get(at).copied().filter(|last| *last > 0) {
            return match self.fits(at, last, self.point.end + 1) {
                true => Gap::Line,
                false => Gap::Level,
            };
        }
        let ends = |before: &FormatItem| before.is(T::Semicolon) || before.is(T::RightBrace);
        let is_empty = item.is(T::Semicolon) && self.before(at).is_some_and(ends);
        let is_after_label = || self.point.labelled == Some(item.line) && self.line_fits(at, item);
        match item.breaks == 0 && (is_empty || self.is_in_row(at) || is_after_label()) {
            true => Gap::Line,
            false => Gap::Level,
        }
    }

    fn gap_tail(&self, at: usize, item: &FormatItem, before: &FormatItem) -> Gap {
        let is_do = item.is(T::While);
        let was_inline = self
            .role(at - 1)
            .partner
            .is_some_and(|open| self.placed(open as usize).line == self.placed(at - 1).line);
        // `else` at the end of a line belongs to the `if` on the next one.
        let is_apart = self
            .item(at + 1)
            .is_some_and(|next| next.is(T::If) && next.breaks > 0);
        let stays = item.breaks == 0 && !is_apart && !self.is_on_tail(at) && self.ends_here(at);
        let is_joined = match (before.is(T::RightBrace), was_inline) {
            (true, false) => self.style.brace == Brace::Same || is_do,
            (true, true) => stays || is_do,
            // After a body without braces, on the line of its `if`.
            (false, _) => stays && self.statement_starts_line_with_head(),
        };
        match is_joined {
            true => Gap::Line,
            false => Gap::Level,
        }
    }

    /// Whether the last statement is on the line of its header.
    fn statement_starts_line_with_head(&self) -> bool {
        !self.begins_line(self.point.statement)
            || self.role(self.point.statement).start == StatementStart::Statement
    }

    /// Whether the current line starts with another tail of the construct of the tail at `at`.
    fn is_on_tail(&self, at: usize) -> bool {
        let first = self
            .starts
            .last()
            .map_or(ItemRole::default(), |first| self.role(*first));
        first.start == StatementStart::Tail && first.level == self.role(at).level
    }

    /// Records what is kept on one line.
    pub(super) fn note(&mut self, at: usize, item: &FormatItem, gap: Gap) {
        if self.point.inline.is_some_and(|end| at > end) {
            self.point.inline = None;
        }
        let start = self.role(at).start;
        let starts_line = gap != Gap::Line && start != StatementStart::Nothing;
        if starts_line || start == StatementStart::Close {
            self.point.labelled = None;
        }
        if self.role(at).is_label {
            self.point.labelled = Some(item.line);
        }
        let column = match gap {
            Gap::Line => self.point.end + 1,
            _ => self.base + self.role(at).level * self.style.indent.width(),
        };
        if item.is(T::LeftBrace) && self.point.inline.is_none() && self.stays_inline(at, column) {
            self.point.inline = self.role(at).partner.map(|end| end as usize);
        }
    }

    /// Whether the block that opens here is kept on one line, starting at `column`.
    fn stays_inline(&self, at: usize, column: u32) -> bool {
        let role = self.role(at);
        let (Some(open), Some(partner)) = (self.item(at), role.partner) else {
            return false;
        };
        let partner = partner as usize;
        let is_block = matches!(
            role.start,
            StatementStart::Open | StatementStart::Statement | StatementStart::Body
        );
        if !is_block {
            return false;
        }
        if partner == at + 1 {
            return self.lines == Lines::Free || self.item(partner).is_some_and(|p| p.breaks == 0);
        }
        let is_near = partner < self.block_end;
        let is_one_line = is_near && self.item(partner).is_some_and(|p| p.line == open.line);
        let is_plain = |i: &FormatItem| !i.parts_lines() && !i.keeps;
        let is_row = || {
            let inner = self.items.get(at..=partner).unwrap_or(&[]);
            self.is_table_row(at, partner) && inner.iter().all(is_plain)
        };
        is_one_line && (self.fits(at, partner, column) || is_row())
    }

    /// Whether the rest of the source line fits on the current line.
    fn line_fits(&self, at: usize, item: &FormatItem) -> bool {
        let items = self.items.iter().enumerate().skip(at);
        let line = items.take_while(|(_, i)| i.line == item.line && !i.ends_line());
        let line = line.take(self.style.width as usize + 1);
        self.fits(at, line.last().map_or(at, |(i, _)| i), self.point.end + 1)
    }

    /// Whether a range of items fits on one line without line breaks, if the first starts at
    /// `column`.
    pub(super) fn fits(&self, from: usize, to: usize, column: u32) -> bool {
        let parts = |i: &FormatItem| i.parts_lines() || i.keeps;
        let items = self.items.get(from..=to).unwrap_or(&[]);
        let end = |i: usize| self.ends.get(i).copied().unwrap_or(0);
        let first = self.item(from).map_or(0, |i| i.width);
        let width = end(to) - end(from) + first;
        // The width is checked first, which keeps the total time linear.
        column + width <= self.style.width && !items.iter().any(parts)
    }
}
