//! Lines of several statements that stay on one line, because they are rows of a table.

use super::item::FormatItem;
use super::place::LineLayout;
use super::spacing::is_assignment;
use super::structure::{ItemRole, StatementStart};
use shaderlint_syntax::TokenKind as T;
use shaderlint_text::SetAt;
use std::ops::Range;

/// Minimum number of equal statements that stay on one line.
const EQUAL: usize = 3;
/// The same, if there is more than one space between them.
const EQUAL_APART: usize = 2;

/// A line whose statements may share a line.
pub struct StatementRow {
    /// Its first item, and the item after the last one.
    pub from: usize,
    to: usize,
    /// The item after the last one that is not a comment.
    end: usize,
    line: u32,
    /// The number of its statements.
    count: usize,
    /// Whether it fits on a line.
    pub fits: bool,
}

impl LineLayout<'_> {
    /// The lines of a block that consist of statements which may share a line.
    pub(super) fn rows(&self, block: Range<usize>) -> Vec<StatementRow> {
        let mut to = block.start;
        let items = self.items.get(block).unwrap_or(&[]);
        let lines = items.chunk_by(|a, b| a.line == b.line);
        let rows = lines.map(|line| {
            let from = to;
            to += line.len();
            self.row(from..to)
        });
        rows.flatten().collect()
    }

    /// A source line, if it consists of statements that may share a line.
    fn row(&self, line: Range<usize>) -> Option<StatementRow> {
        let role = self.role(line.start);
        let roles = self.roles.get(line.clone()).unwrap_or(&[]);
        let starts = |r: &&ItemRole| {
            r.start != StatementStart::Nothing && r.start != StatementStart::Comment
        };
        let statements = roles.iter().filter(starts);
        let are_plain = statements
            .clone()
            .all(|r| r.start == StatementStart::Statement && r.level == role.level);
        let comment = |i: usize| self.item(i).is_some_and(FormatItem::is_comment);
        let last = line.clone().rev().find(|i| !comment(*i));
        let column = self.base + role.level * self.style.indent.width();
        // Another space is put between statements that had several.
        let line_items = self.items.get(line.clone()).unwrap_or(&[]);
        let apart = line_items.iter().skip(1).filter(|i| i.blanks > 1).count() as u32;
        let is_row = role.start == StatementStart::Statement
            && are_plain
            && !goes_on(self.items, self.roles, line.end);
        let fits = last.is_some_and(|last| self.fits(line.start, last, column + apart));
        is_row.then(|| StatementRow {
            from: line.start,
            to: line.end,
            end: last.map_or(line.end, |last| last + 1),
            line: self.item(line.start).map_or(0, |first| first.line),
            count: statements.count(),
            fits,
        })
    }

    /// Determines which statements go on the line before as far as there is space: those of
    /// consecutive lines of equal statements one of which is too long. Returns the items of these
    /// lines.
    pub(super) fn refill(
        &mut self,
        block: Range<usize>,
        rows: &[StatementRow],
    ) -> Vec<Range<usize>> {
        let mut refilled = Vec::new();
        if let Some(filled) = self.filled.get_mut(block) {
            filled.fill(0);
        }
        if rows.iter().all(|row| row.fits || row.count < 2) {
            return refilled;
        }
        let forms: Vec<Option<Vec<T>>> = rows.iter().map(|row| self.form(row)).collect();
        let mut from = 0;
        while let Some(form) = forms.get(from) {
            let rest = rows.get(from..).unwrap_or(&[]).windows(2);
            let near = rest
                .take_while(|pair| matches!(pair, [a, b] if a.line + 1 == b.line && a.end == a.to));
            let same = forms.iter().skip(from + 1).take_while(|next| *next == form);
            let to = from + 1 + near.count().min(same.count());
            let equal = rows.get(from..to).unwrap_or(&[]);
            if form.is_some() && equal.iter().any(|row| !row.fits && row.count > 1) {
                refilled.push(self.refill_rows(equal));
            }
            from = to;
        }
        refilled
    }

    /// Fills rows of equal statements again: calls from one row to the next, others each row for
    /// itself.
    fn refill_rows(&mut self, rows: &[StatementRow]) -> Range<usize> {
        let first = rows.first().map_or(0, |row| row.from);
        let end = rows.last().map_or(0, |row| row.end);
        let mut last = end;
        let are_calls = self
            .item(first + 1)
            .is_some_and(|item| item.is(T::LeftParen));
        for at in (first + 1..end).rev() {
            if self.role(at).start != StatementStart::Nothing {
                let starts_line = self.item(at).is_some_and(|item| item.breaks > 0);
                let filled = self.filled.get_mut(at);
                if let Some(filled) = filled.filter(|_| are_calls || !starts_line) {
                    *filled = last - 1;
                }
                last = at;
            }
        }
        self.point.is_over = true;
        last..end
    }

    /// The tokens of each statement of a row, if all are equal and there is nothing else.
    fn form(&self, row: &StatementRow) -> Option<Vec<T>> {
        let items = self.items.get(row.from..row.end)?;
        let is_plain = |i: &FormatItem| i.token().is_some() && !i.keeps;
        let mut statements = self.statements(row);
        statements.dedup();
        // Empty statements stay where they are.
        let form = statements.pop().filter(|form| form.len() > 1)?;
        (items.iter().all(is_plain) && statements.is_empty()).then_some(form)
    }

    /// Determines which statements stay on the line of the previous one: because an item of their
    /// line is a cell, because the next line or the one before has statements of the same form, or
    /// because all statements of the line are equal.
    pub(super) fn keep_rows(&mut self, block: Range<usize>, rows: &[StatementRow]) {
        if let Some(stays) = self.in_rows.get_mut(block) {
            stays.fill(false);
        }
        if rows.iter().all(|row| row.count < 2) {
            return;
        }
        let forms: Vec<Vec<Vec<T>>> = rows.iter().map(|row| self.forms(row)).collect();
        let is_like = |n: usize, other: usize| match (rows.get(n), rows.get(other)) {
            (Some(row), Some(next)) => {
                let form = forms.get(n);
                let is_near = row.line.abs_diff(next.line) == 1;
                row.fits
                    && next.fits
                    && is_near
                    && form == forms.get(other)
                    && form.is_some_and(|f| !f.is_empty())
            }
            _ => false,
        };
        let shared = |row: &StatementRow| row.fits && row.count > 1;
        for (n, row) in rows.iter().enumerate().filter(|(_, row)| shared(row)) {
            let roles = self.roles.iter().enumerate().take(row.to);
            let roles = roles.skip(row.from + 1);
            let starts = roles.filter(|(_, role)| role.start == StatementStart::Statement);
            let starts = starts.map(|(at, _)| at);
            let stay = starts.clone().any(|i| self.is_aligned(i))
                || is_like(n, n + 1)
                || n.checked_sub(1).is_some_and(|before| is_like(n, before))
                || self.are_equal(row);
            for at in starts.filter(|_| stay) {
                self.in_rows.set_at(at, true);
            }
        }
    }

    /// Whether an item is aligned with items of other lines.
    pub(super) fn is_aligned(&self, at: usize) -> bool {
        self.aligned.get(at) == Some(&true)
    }

    /// The tokens of the statements of a row.
    fn statements(&self, row: &StatementRow) -> Vec<Vec<T>> {
        let line = self.items.get(row.from..row.to).unwrap_or(&[]);
        let code = line.iter().filter(|i| !i.is_comment() && !i.is_prefix);
        let tokens: Vec<T> = code.filter_map(FormatItem::token).map(sort).collect();
        let statements = tokens.split_inclusive(|kind| *kind == T::Semicolon);
        statements.map(<[T]>::to_vec).collect()
    }

    /// The forms of the statements of a row: the tokens of each up to the assignment or call,
    /// without a type. Equal ones count once; a row of one statement has none.
    fn forms(&self, row: &StatementRow) -> Vec<Vec<T>> {
        if row.count < 2 {
            return Vec::new();
        }
        let mut statements = self.statements(row);
        for tokens in &mut statements {
            let is_end = |kind: &T| is_assignment(*kind) || *kind == T::LeftParen;
            let end = tokens.iter().position(is_end);
            let end = end.map_or(tokens.len(), |end| end + 1);
            let types = tokens.iter().take(end.saturating_sub(2));
            let from = types.take_while(|kind| is_word(**kind)).count();
            *tokens = tokens.get(from..end).unwrap_or(&[]).to_vec();
        }
        statements.dedup();
        statements
    }

    /// Whether a row consists of equal statements, apart from names and numbers.
    fn are_equal(&self, row: &StatementRow) -> bool {
        let statements = self.statements(row);
        let are_equal = statements
            .windows(2)
            .all(|pair| pair.first() == pair.last());
        let is_apart = |at: usize| {
            let starts = self.role(at).start == StatementStart::Statement;
            starts && self.item(at).is_some_and(|item| item.blanks > 1)
        };
        let least = match (row.from + 1..row.to).any(is_apart) {
            true => EQUAL_APART,
            false => EQUAL,
        };
        statements.len() >= least && are_equal
    }
}

fn is_word(kind: T) -> bool {
    matches!(kind, T::Identifier | T::Type | T::Const)
}

/// A kind of token, the same for all numbers and for all assignments.
fn sort(kind: T) -> T {
    match kind {
        T::Int | T::True | T::False => T::Float,
        kind if is_assignment(kind) => T::Equal,
        kind => kind,
    }
}

/// Whether an item continues the statement of the item before it.
pub fn goes_on(items: &[FormatItem], roles: &[ItemRole], at: usize) -> bool {
    let is_inside = |r: &ItemRole| r.start == StatementStart::Nothing;
    let is_code = |i: &FormatItem| i.is_comment() || i.token().is_some();
    items.get(at).is_some_and(is_code) && roles.get(at).is_some_and(is_inside)
}
