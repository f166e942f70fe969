//! Lines of several statements that stay on one line, because they are rows of a table.

use super::item::FormatItem;
use super::place::LineLayout;
use super::spacing::is_assignment;
use super::structure::{ItemRole, StatementStart};
use shaderlint_syntax::TokenKind as T;
use std::ops::Range;

/// Minimum number of equal statements that stay on one line.
const EQUAL: usize = 3;

/// A line whose statements may share a line.
pub struct StatementRow {
    /// Its first item, and the item after the last one.
    pub from: usize,
    to: usize,
    line: u32,
    /// Whether it fits on a line.
    pub fits: bool,
}

impl LineLayout<'_> {
    /// The lines that consist of statements which may share a line.
    pub(super) fn rows(&self) -> Vec<StatementRow> {
        let mut to = 0;
        let lines = self.items.chunk_by(|a, b| a.line == b.line);
        let rows = lines.map(|line| {
            let from = to;
            to += line.len();
            let line = line.first().map_or(0, |first| first.line);
            let fits = self.is_row(from..to)?;
            Some(StatementRow {
                from,
                to,
                line,
                fits,
            })
        });
        rows.flatten().collect()
    }

    /// Whether a source line fits on a line; `None` unless it consists of statements that may share
    /// a line.
    fn is_row(&self, line: Range<usize>) -> Option<bool> {
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
        is_row.then_some(fits)
    }

    /// By item: the last item of the statement that starts there, if it goes on the line before as
    /// far as there is space: in consecutive lines of equal statements one of which is too long.
    pub(super) fn refilled(&self, rows: &[StatementRow]) -> Vec<usize> {
        let mut filled = vec![0; self.items.len()];
        let forms: Vec<Option<Vec<T>>> = rows.iter().map(|row| self.form(row)).collect();
        let mut from = 0;
        while let Some(form) = forms.get(from) {
            let rest = rows.get(from..).unwrap_or(&[]).windows(2);
            let near = rest.take_while(|pair| matches!(pair, [a, b] if a.line + 1 == b.line));
            let same = forms.iter().skip(from + 1).take_while(|next| *next == form);
            let to = from + 1 + near.count().min(same.count());
            let block = rows.get(from..to).unwrap_or(&[]);
            if form.is_some() && block.iter().any(|row| !row.fits) {
                let first = block.first().map_or(0, |row| row.from);
                let end = block.last().map_or(0, |row| row.to);
                let mut last = end;
                for at in (first + 1..end).rev() {
                    if self.role(at).start != StatementStart::Nothing {
                        if let Some(filled) = filled.get_mut(at) {
                            *filled = last - 1;
                        }
                        last = at;
                    }
                }
            }
            from = to;
        }
        filled
    }

    /// The tokens of each statement of a row, if all are equal and there is nothing else.
    fn form(&self, row: &StatementRow) -> Option<Vec<T>> {
        let items = self.items.get(row.from..row.to)?;
        let is_plain = |i: &FormatItem| i.token().is_some() && !i.keeps;
        let mut statements = self.statements(row);
        statements.dedup();
        let form = statements.pop()?;
        (items.iter().all(is_plain) && statements.is_empty()).then_some(form)
    }

    /// By item: whether it starts a statement that stays on the same line as the previous one:
    /// because an item of its line is a cell, because the next line or the one before has
    /// statements of the same form, or because all statements of its line are equal.
    pub(super) fn in_rows(&self, rows: &[StatementRow]) -> Vec<bool> {
        let mut stays = vec![false; self.items.len()];
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
        for (n, row) in rows.iter().enumerate().filter(|(_, row)| row.fits) {
            let starts =
                (row.from + 1..row.to).filter(|i| self.role(*i).start == StatementStart::Statement);
            let stay = starts.clone().any(|i| self.is_aligned(i))
                || is_like(n, n + 1)
                || n.checked_sub(1).is_some_and(|before| is_like(n, before))
                || self.are_equal(row);
            for i in starts.filter(|_| stay) {
                if let Some(stays) = stays.get_mut(i) {
                    *stays = true;
                }
            }
        }
        stays
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
        let mut statements = self.statements(row);
        if statements.len() < 2 {
            return Vec::new();
        }
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
        statements.len() >= EQUAL && are_equal
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
