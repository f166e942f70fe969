//! Preserves the alignment of items in consecutive lines.

use super::item::{FormatItem, ItemKind};
use super::place::ItemPlace;
use super::structure::{ItemRole, StatementStart};
use shaderlint_syntax::TokenKind as T;
use std::cmp::Ordering;
use std::ops::Range;

/// The group of an item that is not aligned.
const NONE: u32 = u32::MAX;

/// By item: the index of the column in which it starts a cell, i.e. items below one another in
/// consecutive lines, at least one of them after more than one space. `blanks` says before which
/// items a space belongs; `is_row` whether the statements of a line may share a line.
pub fn cells(
    items: &[FormatItem],
    roles: &[ItemRole],
    blanks: &[bool],
    is_row: impl Fn(Range<usize>) -> bool,
) -> Vec<u32> {
    let mut groups = vec![NONE; items.len()];
    let mut next = 0;
    let mut above = 0..0;
    let mut above_is_row = false;
    for line in items.chunk_by(|a, b| a.line == b.line) {
        let own = above.end..above.end + line.len();
        let own_is_row = is_row(own.clone());
        let is_cell = |i: usize| match roles.get(i).map(|r| r.start) {
            Some(StatementStart::Nothing | StatementStart::Comment) => blanks.get(i) == Some(&true),
            Some(StatementStart::Statement) => {
                let before = i.checked_sub(1).and_then(|i| items.get(i));
                above_is_row && own_is_row && before.is_some_and(|b| b.is(T::Semicolon))
            }
            _ => false,
        };
        let start = |i: usize| roles.get(i).map(|r| r.start);
        let mut pairs = below_one_another(items, above, own.clone());
        pairs.retain(|(a, b)| is_cell(*a) && is_cell(*b) && start(*a) == start(*b));
        let is_wide = |i: usize| items.get(i).is_some_and(|i| i.blanks > 1);
        let is_table = pairs.iter().any(|(a, b)| is_wide(*a) || is_wide(*b));
        for (a, b) in pairs {
            let is_statement = is_table && start(a) == Some(StatementStart::Statement);
            if is_statement || is_wide(a) || is_wide(b) {
                join(a, b, &mut groups, &mut next);
            }
        }
        (above, above_is_row) = (own, own_is_row);
    }
    groups
}

/// By item: whether it starts a statement that stays on the same line as the previous one, because
/// an item of its line is a cell.
pub fn in_rows(items: &[FormatItem], roles: &[ItemRole], groups: &[u32]) -> Vec<bool> {
    let mut stays = vec![false; items.len()];
    let mut from = 0;
    for line in items.chunk_by(|a, b| a.line == b.line) {
        let own = from + 1..from + line.len();
        from += line.len();
        let starts = |i: &usize| {
            let start = roles.get(*i).map(|r| r.start);
            start == Some(StatementStart::Statement)
        };
        let is_cell = |i: usize| groups.get(i).is_some_and(|g| *g != NONE);
        if own.clone().filter(starts).any(is_cell) {
            own.filter(starts).for_each(|i| {
                if let Some(stays) = stays.get_mut(i) {
                    *stays = true;
                }
            });
        }
    }
    stays
}

/// The items of two consecutive lines that start at the same column.
fn below_one_another(
    items: &[FormatItem],
    above: Range<usize>,
    below: Range<usize>,
) -> Vec<(usize, usize)> {
    let mut found = Vec::new();
    let last = above.end.checked_sub(1).and_then(|i| items.get(i));
    let (Some(last), Some(first)) = (last, items.get(below.start)) else {
        return found;
    };
    if last.is_tall || last.line + 1 != first.line {
        return found;
    }
    let (mut a, mut b) = (above.start + 1, below.start + 1);
    while a < above.end && b < below.end {
        let (Some(upper), Some(lower)) = (items.get(a), items.get(b)) else {
            break;
        };
        match upper.column.cmp(&lower.column) {
            Ordering::Less => a += 1,
            Ordering::Greater => b += 1,
            Ordering::Equal => {
                if are_alike(upper, lower) {
                    found.push((a, b));
                }
                a += 1;
                b += 1;
            }
        }
    }
    found
}

/// Adds an item to the column of the one above it, or to a new column.
fn join(above: usize, below: usize, groups: &mut [u32], next: &mut u32) {
    let group = match groups.get(above) {
        Some(&group) if group != NONE => group,
        _ => {
            *next += 1;
            *next - 1
        }
    };
    for at in [above, below] {
        if let Some(g) = groups.get_mut(at) {
            *g = group;
        }
    }
}

/// Whether two items may be cells of the same column.
fn are_alike(a: &FormatItem, b: &FormatItem) -> bool {
    let is_code = |i: &FormatItem| matches!(i.kind, ItemKind::Token(_));
    let may = |i: &FormatItem| !i.keeps && i.anchor.is_none() && !i.is_tall;
    may(a) && may(b) && ((is_code(a) && is_code(b)) || (a.is_comment() && b.is_comment()))
}

/// Aligns the cells of each column.
pub fn align(items: &[FormatItem], roles: &[ItemRole], groups: &[u32], places: &mut [ItemPlace]) {
    let mut columns = columns(items, roles, groups, places);
    columns.sort_by_key(|cells| cells.first().and_then(|i| items.get(*i)).map(|i| i.column));
    let lines = places
        .iter()
        .map(|p| p.line as usize + 1)
        .max()
        .unwrap_or(0);
    // The shift of each line so far, and the additional space before each cell.
    let mut moved = vec![0u32; lines];
    let mut pads = vec![0u32; places.len()];
    for cells in &columns {
        let column = |i: &usize| {
            let place = places.get(*i)?;
            Some(place.column + moved.get(place.line as usize)?)
        };
        let target = cells.iter().filter_map(column).max().unwrap_or(0);
        let missing: Vec<u32> = cells
            .iter()
            .map(|i| target - column(i).unwrap_or(target))
            .collect();
        for (i, missing) in cells.iter().zip(missing) {
            let line = places.get(*i).map_or(0, |p| p.line as usize);
            if let (Some(moved), Some(pad)) = (moved.get_mut(line), pads.get_mut(*i)) {
                *moved += missing;
                *pad += missing;
            }
        }
    }
    let (mut shift, mut line) = (0, 0);
    for (place, pad) in places.iter_mut().zip(pads) {
        if place.line != line {
            (shift, line) = (0, place.line);
        }
        shift += pad;
        place.column += shift;
    }
}

/// The columns whose cells are still in consecutive lines.
fn columns(
    items: &[FormatItem],
    roles: &[ItemRole],
    groups: &[u32],
    places: &[ItemPlace],
) -> Vec<Vec<usize>> {
    let held = held(items, roles, places);
    let count = groups.iter().filter(|g| **g != NONE).max();
    let mut open: Vec<Vec<usize>> = vec![Vec::new(); count.map_or(0, |c| *c as usize + 1)];
    let mut closed = Vec::new();
    for (at, group) in groups.iter().enumerate() {
        let (Some(cells), Some(place)) = (open.get_mut(*group as usize), places.get(at)) else {
            continue;
        };
        let line = place.line as usize;
        let is_comment = items.get(at).is_some_and(FormatItem::is_comment);
        let is_held = held.get(line).is_some_and(|held| at <= *held);
        if place.breaks > 0 || (is_held && !is_comment) {
            continue;
        }
        let last = cells.last().and_then(|i| places.get(*i));
        if last.is_some_and(|last| last.line as usize + 1 != line) {
            closed.push(std::mem::take(cells));
        }
        cells.push(at);
    }
    closed.append(&mut open);
    closed.retain(|cells| cells.len() > 1);
    closed
}

/// By line: the last item that must not move, because a later line is aligned with it. A line whose
/// statement continues on the next line without such alignment does not move at all.
fn held(items: &[FormatItem], roles: &[ItemRole], places: &[ItemPlace]) -> Vec<usize> {
    let line_of = |at: u32| places.get(at as usize).map(|p| p.line as usize);
    let lines = places.iter().map(|p| p.line as usize + 1).max();
    let mut held = vec![0; lines.unwrap_or(0)];
    for (at, place) in places.iter().enumerate() {
        if place.breaks == 0 || at == 0 {
            continue;
        }
        let other = place
            .depends_on
            .and_then(|other| Some((line_of(other)?, other)));
        if let Some((line, other)) = other
            && let Some(held) = held.get_mut(line)
        {
            *held = (*held).max(other as usize);
        }
        let above = (place.line as usize).saturating_sub(1);
        let goes_on = goes_on(items, roles, at);
        if goes_on
            && other.is_none_or(|(line, _)| line != above)
            && let Some(held) = held.get_mut(above)
        {
            *held = usize::MAX;
        }
    }
    held
}

/// Whether an item continues the statement of the item before it.
pub fn goes_on(items: &[FormatItem], roles: &[ItemRole], at: usize) -> bool {
    let is_inside = |r: &ItemRole| r.start == StatementStart::Nothing;
    let is_code = |i: &FormatItem| i.is_comment() || i.token().is_some();
    items.get(at).is_some_and(is_code) && roles.get(at).is_some_and(is_inside)
}
