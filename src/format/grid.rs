//! Tables of numbers inside brackets, whose layout is kept.

use super::item::{FormatItem, ItemKind};
use super::structure::ItemRole;
use super::style::Style;
use shaderlint_syntax::TokenKind as T;
use shaderlint_syntax::set::TokenSet;
use std::ops::Range;

/// Tokens that a table may contain, besides constructor calls.
const IN_TABLE: TokenSet = TokenSet::of(&[
    T::Int,
    T::Float,
    T::True,
    T::False,
    T::Comma,
    T::LeftParen,
    T::RightParen,
    T::LeftBrace,
    T::RightBrace,
]);
/// Tokens by which the last row may differ from the others.
const ENDS_ROW: TokenSet = TokenSet::of(&[T::Comma, T::RightParen, T::RightBrace]);

/// Keeps the white space inside tables that fit on their lines; their rows move with the bracket.
pub fn keep(
    text: &str,
    items: &mut [FormatItem],
    roles: &[ItemRole],
    blanks: &[bool],
    style: &Style,
) {
    let mut at = 0;
    while at < items.len() {
        let table = table(text, items, roles, blanks, at);
        match table.filter(|table| fits(items, roles, blanks, at..table.close, style)) {
            Some(table) => {
                keep_table(items, at, &table);
                at = table.close;
            }
            None => at += 1,
        }
    }
}

/// A table inside brackets.
struct BracketTable {
    close: usize,
    /// Whether its rows start at the column of the first one, rather than where they were.
    starts_alike: bool,
}

/// The table inside a bracket, if there is one.
fn table(
    text: &str,
    items: &[FormatItem],
    roles: &[ItemRole],
    blanks: &[bool],
    open: usize,
) -> Option<BracketTable> {
    let role = roles.get(open)?;
    let close = role.partner? as usize;
    let first = items.get(open)?;
    let is_list = first.is(T::LeftParen) || first.is(T::LeftBrace);
    let is_value = roles.get(close)?.bracket == Some(open as u32);
    let is_tall = close > open + 1 && items.get(close)?.line > first.line;
    if !(is_list && is_value && is_tall) {
        return None;
    }
    let inner = items.get(open + 1..close)?;
    let pairs = inner.iter().zip(items.get(open + 2..=close)?);
    let mut is_plain = true;
    let fits = |(item, next): (&FormatItem, &FormatItem)| match item.kind {
        ItemKind::LineComment | ItemKind::BlockComment => true,
        ItemKind::Token(kind) => {
            let is_sign = matches!(kind, T::Plus | T::Minus) && item.is_prefix;
            let is_called = matches!(kind, T::Identifier | T::Type) && next.is(T::LeftParen);
            is_plain &= is_sign || is_called || IN_TABLE.contains(kind);
            !matches!(kind, T::Bad | T::Semicolon)
        }
        ItemKind::Directive(_) | ItemKind::Idle => false,
    };
    let may_be_table = pairs.into_iter().all(fits);
    if !may_be_table {
        return None;
    }
    let blanks = blanks.get(open + 1..close)?;
    let start = |row: &[FormatItem]| row.first().map_or(0, |first| first.column);
    let is_table = is_plain && has_rows(inner) || are_lined_up(text, inner, blanks, |_| 0);
    // With tabs, rows may start where they should not.
    let starts_alike = !is_table && are_lined_up(text, inner, blanks, start);
    (is_table || starts_alike).then_some(BracketTable {
        close,
        starts_alike,
    })
}

/// Whether the rows of a table fit on their lines; one with comments is kept in any case.
fn fits(
    items: &[FormatItem],
    roles: &[ItemRole],
    blanks: &[bool],
    table: Range<usize>,
    style: &Style,
) -> bool {
    let inner = items.get(table.start + 1..table.end).unwrap_or(&[]);
    let level = roles.get(table.start).map_or(0, |role| role.level) * style.indent.width();
    let line = items.get(table.start).map(|open| open.line);
    let before = items.iter().zip(blanks).take(table.start + 1).rev();
    let before = before.take_while(|(item, _)| Some(item.line) == line);
    let before: u32 = before
        .map(|(item, blank)| item.width + u32::from(*blank))
        .sum();
    let mut rows = inner.chunk_by(|a, b| a.line == b.line);
    let is_over = rows.any(|row| {
        let (Some(first), Some(last)) = (row.first(), row.last()) else {
            return false;
        };
        let width = last.column + last.width - first.column;
        let before = if Some(first.line) == line { before } else { 0 };
        level + before + width > style.width
    });
    !is_over || inner.iter().any(FormatItem::is_comment)
}

/// Whether items form rows: each consists of numbers only, or has the same tokens as the previous
/// one.
fn has_rows(items: &[FormatItem]) -> bool {
    let rows = items.chunk_by(|a, b| a.line == b.line);
    let rows: Vec<Vec<T>> = rows.map(row).filter(|row| !row.is_empty()).collect();
    let is_number = |kind: &T| matches!(kind, T::Int | T::Float | T::True | T::False);
    let has_numbers = |row: &Vec<T>| row.iter().filter(|k| is_number(k)).count() >= 2;
    let is_plain = rows
        .iter()
        .flatten()
        .all(|k| is_number(k) || *k == T::Comma);
    // The last row may be shorter.
    let full = rows.len().saturating_sub(1).max(1);
    let pairs = rows.get(..full).unwrap_or(&[]).windows(2);
    let last = rows.first().zip(rows.last());
    let are_alike = pairs.into_iter().all(|pair| pair.first() == pair.last())
        && last.is_some_and(|(first, last)| first.starts_with(last));
    rows.iter().filter(|row| has_numbers(row)).count() >= 2 && (is_plain || are_alike)
}

/// Whether the commas between the elements of all rows are below one another, seen from where `start`
/// says that a row starts, only because of additional space.
fn are_lined_up(
    text: &str,
    items: &[FormatItem],
    blanks: &[bool],
    start: impl Fn(&[FormatItem]) -> u32,
) -> bool {
    let mut at = 0;
    let (mut rows, mut flat) = (Vec::new(), Vec::new());
    for row in items.chunk_by(|a, b| a.line == b.line) {
        let code = row.iter().zip(blanks.get(at..).unwrap_or(&[]));
        let code = code.filter(|(item, _)| !item.is_comment());
        let count = code.clone().count().saturating_sub(1);
        let mut end = 0;
        let (mut commas, mut closest) = (Vec::new(), Vec::new());
        for (n, (item, blank)) in code.take(count).enumerate() {
            if n > 0 && item.is(T::Comma) {
                commas.push(item.column - start(row));
                closest.push(end);
            }
            end += item.width + u32::from(*blank && n > 0);
        }
        rows.push(commas);
        flat.push(closest);
        at += row.len();
    }
    let are_equal = |rows: &[Vec<u32>]| rows.windows(2).all(|pair| pair.first() == pair.last());
    // The width of a tab depends on its column.
    let has_tab = |item: &FormatItem| {
        let before = item.span.start.checked_sub(1);
        let before = before.and_then(|at| text.as_bytes().get(at as usize));
        item.breaks == 0 && before == Some(&b'\t')
    };
    let is_wide = |item: &FormatItem| item.breaks == 0 && item.blanks > 1;
    rows.len() > 1
        && rows.first().is_some_and(|row| row.len() > 1)
        && are_equal(&rows)
        && !are_equal(&flat)
        && items.iter().any(is_wide)
        && !items.iter().any(has_tab)
}

/// The tokens of a row that distinguish it from others.
fn row(items: &[FormatItem]) -> Vec<T> {
    let tokens = items
        .iter()
        .filter(|i| !i.is_prefix)
        .filter_map(FormatItem::token);
    let mut row: Vec<T> = tokens
        .map(|kind| if kind == T::Int { T::Float } else { kind })
        .collect();
    while row.last().is_some_and(|kind| ENDS_ROW.contains(*kind)) {
        row.pop();
    }
    row
}

fn keep_table(items: &mut [FormatItem], open: usize, table: &BracketTable) {
    let line = items.get(open).map(|i| i.line);
    let before = items.iter().take(open).rev();
    let before = before.take_while(|i| Some(i.line) == line).count();
    let is_last = items.get(open + 1).is_some_and(|i| Some(i.line) != line);
    // If the bracket is the last item of its line, the rows move with that line.
    let anchor = if is_last { open - before } else { open };
    for item in items.iter_mut().take(table.close + 1).skip(open + 1) {
        if !table.starts_alike {
            item.anchor = Some(anchor as u32);
        }
        item.keeps |= item.breaks == 0;
    }
}
