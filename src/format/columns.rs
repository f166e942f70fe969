//! Preserves the alignment of items in consecutive lines.

use super::item::FormatItem;
use super::place::ItemPlace;
use super::rows::{StatementRow, goes_on};
use super::spacing::{is_assignment, precedence};
use super::structure::{ItemRole, StatementStart};
use shaderlint_syntax::TokenKind as T;
use std::cmp::Ordering;
use std::ops::{Range, RangeInclusive};

/// The column of an item that is not aligned.
const NONE: u32 = u32::MAX;

/// Columns of cells: items of the same sort below one another in consecutive lines, at least one of
/// them after more space than usual.
pub struct Cells {
    /// By item: the index of the column in which it starts a cell.
    columns: Vec<u32>,
    /// By column: the side at which its cells are aligned, if it is known.
    sides: Vec<Option<CellSide>>,
    /// By column: whether there is more space than usual before one of its cells.
    padded: Vec<bool>,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum CellSide {
    Start,
    /// Of numbers.
    End,
}

/// Two items, one below the other, and the side at which they are aligned.
struct CellPair {
    above: usize,
    below: usize,
    side: Option<CellSide>,
}

/// The columns of a text. `blanks` says before which items a space belongs; `rows` lists the lines
/// whose statements may share a line.
pub fn cells(
    items: &[FormatItem],
    roles: &[ItemRole],
    blanks: &[bool],
    rows: &[StatementRow],
) -> Cells {
    let mut cells = Cells {
        columns: vec![NONE; items.len()],
        sides: Vec::new(),
        padded: Vec::new(),
    };
    let mut above = 0..0;
    let mut above_is_row = false;
    let mut rows = rows.iter().peekable();
    for line in items.chunk_by(|a, b| a.line == b.line) {
        let own = above.end..above.end + line.len();
        let row = rows.next_if(|row| row.from == own.start);
        let own_is_row = row.is_some_and(|row| row.fits);
        let semicolons = line.iter().filter(|i| i.is(T::Semicolon));
        let own_is_single = semicolons.count() < 2;
        let is_cell = |i: usize| match roles.get(i).map(|r| r.start) {
            Some(StatementStart::Nothing | StatementStart::Comment) => blanks.get(i) == Some(&true),
            Some(StatementStart::Statement) => {
                let before = i.checked_sub(1).and_then(|i| items.get(i));
                above_is_row && own_is_row && before.is_some_and(|b| b.is(T::Semicolon))
            }
            _ => false,
        };
        let start = |i: usize| roles.get(i).map(|r| r.start);
        let is_wide = |i: usize| {
            let usual = u32::from(blanks.get(i) == Some(&true));
            items.get(i).is_some_and(|i| i.blanks > usual)
        };
        if are_consecutive(items, &above, &own) {
            let first = above.start;
            let mut pairs = numbers_below_one_another(items, above.clone(), own.clone());
            let starts = starts_below_one_another(items, above, own.clone());
            pairs.extend(starts.filter(|p| is_cell(p.above) && is_cell(p.below)));
            // A line that continues a statement is not in a table with the next statement.
            let starts = |line: usize| start(line).is_some_and(|s| s != StatementStart::Nothing);
            let is_next = starts(own.start) && !starts(first);
            let is_comment = |i: usize| items.get(i).is_some_and(FormatItem::is_comment);
            pairs.retain(|pair| !is_next || is_comment(pair.below));
            pairs.retain(|pair| {
                are_alike(items, roles, pair) && blanks.get(pair.above) == blanks.get(pair.below)
            });
            let space = |i: usize| items.get(i).map(|i| i.column.saturating_sub(i.blanks));
            let wide = |pair: &CellPair| {
                // A number that is shorter than the other has more space.
                let is_padded = match (pair.side, space(pair.above), space(pair.below)) {
                    (Some(CellSide::End), Some(above), Some(below)) if own_is_single => {
                        above == below && follow_alike(items, roles, pair)
                    }
                    _ => false,
                };
                is_padded || is_wide(pair.above) || is_wide(pair.below)
            };
            let is_table = pairs.iter().any(wide);
            for pair in pairs {
                let is_statement = is_table && start(pair.above) == Some(StatementStart::Statement);
                let is_padded = is_statement || wide(&pair);
                if is_padded || pair.side.is_none() {
                    cells.join(&pair, is_padded);
                }
            }
        }
        (above, above_is_row) = (own, own_is_row);
    }
    cells.remove_unpadded(blanks);
    cells
}

/// Whether one line of the source follows another.
fn are_consecutive(items: &[FormatItem], above: &Range<usize>, below: &Range<usize>) -> bool {
    let last = above.end.checked_sub(1).and_then(|i| items.get(i));
    let first = items.get(below.start);
    last.zip(first)
        .is_some_and(|(last, first)| !last.is_tall && last.line + 1 == first.line)
}

/// The elements of two lists that are at the same column, in order.
fn meet<A: Copy>(above: &[(u32, A)], below: &[(u32, A)]) -> Vec<(A, A)> {
    let mut found = Vec::new();
    let (mut a, mut b) = (0, 0);
    while let (Some(upper), Some(lower)) = (above.get(a), below.get(b)) {
        match upper.0.cmp(&lower.0) {
            Ordering::Less => a += 1,
            Ordering::Greater => b += 1,
            Ordering::Equal => {
                found.push((upper.1, lower.1));
                (a, b) = (a + 1, b + 1);
            }
        }
    }
    found
}

/// The items of two lines that start at the same column.
fn starts_below_one_another(
    items: &[FormatItem],
    above: Range<usize>,
    below: Range<usize>,
) -> impl Iterator<Item = CellPair> {
    let starts = |line: Range<usize>| -> Vec<(u32, usize)> {
        let rest = line.skip(1);
        rest.filter_map(|i| Some((items.get(i)?.column, i)))
            .collect()
    };
    let found = meet(&starts(above), &starts(below));
    found.into_iter().map(|(above, below)| CellPair {
        above,
        below,
        side: Some(CellSide::Start),
    })
}

/// The numbers of two lines that end at the same column, from their signs on.
fn numbers_below_one_another(
    items: &[FormatItem],
    above: Range<usize>,
    below: Range<usize>,
) -> Vec<CellPair> {
    let ends = |line: Range<usize>| -> Vec<(u32, usize)> {
        let numbers = line.clone().filter_map(|i| {
            let item = items.get(i)?;
            let is_number = matches!(item.token(), Some(T::Int | T::Float));
            let sign = i
                .checked_sub(1)
                .filter(|i| items.get(*i).is_some_and(|i| i.is_prefix));
            let start = sign.unwrap_or(i);
            (is_number && start > line.start).then_some((item.column + item.width, start))
        });
        numbers.collect()
    };
    let column = |i: usize| items.get(i).map(|i| i.column);
    let found = meet(&ends(above), &ends(below)).into_iter();
    let pairs = found.map(|(above, below)| CellPair {
        above,
        below,
        side: (column(above) != column(below)).then_some(CellSide::End),
    });
    pairs.collect()
}

impl Cells {
    fn column(&self, at: usize) -> Option<u32> {
        self.columns
            .get(at)
            .copied()
            .filter(|column| *column != NONE)
    }

    fn side(&self, column: u32) -> Option<CellSide> {
        self.sides.get(column as usize).copied().flatten()
    }

    /// Whether an item is in a column.
    pub fn contain(&self, at: usize) -> bool {
        self.column(at).is_some()
    }

    /// Removes items that do not keep their lines.
    pub fn remove(&mut self, range: RangeInclusive<usize>) {
        if let Some(columns) = self.columns.get_mut(range) {
            columns.fill(NONE);
        }
    }

    /// Adds an item to the column of the one above it, or to a new column.
    fn join(&mut self, pair: &CellPair, is_padded: bool) {
        if self.contain(pair.below) {
            return;
        }
        let column = self.column(pair.above).unwrap_or(self.sides.len() as u32);
        if column as usize == self.sides.len() {
            self.sides.push(None);
            self.padded.push(false);
        }
        if let Some(side) = self.sides.get_mut(column as usize) {
            match (*side, pair.side) {
                (Some(own), Some(other)) if own != other => return,
                (own, other) => *side = own.or(other),
            }
        }
        if let Some(padded) = self.padded.get_mut(column as usize) {
            *padded |= is_padded;
        }
        for at in [pair.above, pair.below] {
            if let Some(c) = self.columns.get_mut(at) {
                *c = column;
            }
        }
    }

    /// Removes columns without additional space, and cells before which no space belongs, such as
    /// first arguments, unless they are aligned at their ends.
    fn remove_unpadded(&mut self, blanks: &[bool]) {
        let (sides, padded) = (&self.sides, &self.padded);
        for (column, blank) in self.columns.iter_mut().zip(blanks) {
            let side = sides.get(*column as usize).copied().flatten();
            let is_padded = padded.get(*column as usize) == Some(&true);
            if !is_padded || !blank && side != Some(CellSide::End) {
                *column = NONE;
            }
        }
    }
}

/// Whether two items may be cells of the same column: what they are and where they are is alike.
fn are_alike(items: &[FormatItem], roles: &[ItemRole], pair: &CellPair) -> bool {
    let (Some(upper), Some(lower)) = (items.get(pair.above), items.get(pair.below)) else {
        return false;
    };
    let (Some(role), Some(other)) = (roles.get(pair.above), roles.get(pair.below)) else {
        return false;
    };
    let may = |i: &FormatItem| !i.keeps && i.anchor.is_none() && !i.is_tall;
    let is_inside = |r: &ItemRole| (r.start, r.level);
    may(upper)
        && may(lower)
        && sort(items, pair.above) == sort(items, pair.below)
        && (upper.is_comment() || is_inside(role) == is_inside(other))
}

/// Number of tokens before two numbers that are compared.
const COMPARED: usize = 8;

/// Whether the same tokens precede two numbers in their brackets, or in their lines.
fn follow_alike(items: &[FormatItem], roles: &[ItemRole], pair: &CellPair) -> bool {
    let before = |at: usize| {
        let open = roles
            .get(at)
            .and_then(|r| r.bracket)
            .map_or(0, |b| b as usize);
        let line = items.get(at).map(|i| i.line);
        let items = items.get(open..at).unwrap_or(&[]).iter().rev();
        let own = items.take_while(move |i| Some(i.line) == line);
        let tokens = own.filter(|i| !i.is_prefix).map(FormatItem::token);
        tokens.map(|kind| match kind {
            Some(T::Int) => Some(T::Float),
            Some(kind) if is_assignment(kind) => Some(T::Equal),
            Some(kind) if precedence(kind).is_some() => Some(T::Plus),
            kind => kind,
        })
    };
    before(pair.above)
        .take(COMPARED)
        .eq(before(pair.below).take(COMPARED))
}

/// What an item is, as far as it matters in a table.
#[derive(PartialEq, Eq)]
enum CellSort {
    Comment,
    /// The operand of an operator, an argument, or an assigned value.
    Operand,
    /// A name after its type.
    Name,
    Assignment,
    Operator,
    Other(Option<T>),
}

fn sort(items: &[FormatItem], at: usize) -> CellSort {
    let Some(item) = items.get(at) else {
        return CellSort::Other(None);
    };
    let before = at
        .checked_sub(1)
        .and_then(|i| items.get(i))
        .and_then(FormatItem::token);
    let is_word = |kind| matches!(kind, T::Identifier | T::Type);
    match (before, item.token()) {
        _ if item.is_comment() => CellSort::Comment,
        (_, Some(kind)) if is_assignment(kind) => CellSort::Assignment,
        (_, Some(kind)) if precedence(kind).is_some() && !item.is_prefix => CellSort::Operator,
        (Some(before), Some(kind)) if is_word(before) && is_word(kind) => CellSort::Name,
        (Some(T::Comma | T::LeftParen | T::LeftBrace | T::Return), _) => CellSort::Operand,
        (Some(before), _) if is_assignment(before) || precedence(before).is_some() => {
            CellSort::Operand
        }
        (_, kind) => CellSort::Other(kind),
    }
}

/// Aligns the cells of each column.
pub fn align(items: &[FormatItem], roles: &[ItemRole], cells: &Cells, places: &mut [ItemPlace]) {
    let mut columns = columns(items, roles, cells, places);
    columns.sort_by_key(|cells| cells.first().and_then(|i| items.get(*i)).map(|i| i.column));
    // The width of a cell that is aligned at its end.
    let width = |at: usize| -> u32 {
        let column = cells.column(at);
        if column.and_then(|column| cells.side(column)) != Some(CellSide::End) {
            return 0;
        }
        let item = items.get(at);
        let number = items
            .get(at + 1)
            .filter(|_| item.is_some_and(|i| i.is_prefix));
        item.map_or(0, |i| i.width) + number.map_or(0, |i| i.width)
    };
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
            Some(place.column + width(*i) + moved.get(place.line as usize)?)
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
    cells: &Cells,
    places: &[ItemPlace],
) -> Vec<Vec<usize>> {
    let held = held(items, roles, places);
    let mut open: Vec<Vec<usize>> = vec![Vec::new(); cells.sides.len()];
    let mut closed = Vec::new();
    for (at, column) in cells.columns.iter().enumerate() {
        let (Some(cells), Some(place)) = (open.get_mut(*column as usize), places.get(at)) else {
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
            && other.is_none()
            && let Some(held) = held.get_mut(above)
        {
            *held = usize::MAX;
        }
    }
    held
}
