//! Preserves the alignment of items in consecutive lines.

use super::item::FormatItem;
use super::place::ItemPlace;
use super::rows::{StatementRow, goes_on};
use super::spacing::{is_assignment, precedence};
use super::structure::{ItemRole, StatementStart};
use shaderlint_syntax::TokenKind as T;
use shaderlint_text::SetAt;
use std::cmp::Ordering;
use std::ops::Range;

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

/// A line of a block, and what may be below or above items of other lines.
#[derive(Default)]
struct CellLine {
    items: Range<usize>,
    /// Whether its statements may share a line.
    is_row: bool,
    /// The items but the first, with their columns.
    starts: Vec<(u32, usize)>,
    /// The numbers, from their signs on, with the columns at which they end.
    ends: Vec<(u32, usize)>,
}

impl CellLine {
    fn read(&mut self, items: &[FormatItem], line: Range<usize>) {
        self.starts.clear();
        self.ends.clear();
        let own = items.get(line.clone()).unwrap_or(&[]);
        for (at, item) in (line.start..).zip(own).skip(1) {
            self.starts.push((item.column, at));
            if matches!(item.token(), Some(T::Int | T::Float)) {
                let is_signed = items.get(at - 1).is_some_and(|sign| sign.is_prefix);
                let start = if is_signed { at - 1 } else { at };
                if start > line.start {
                    self.ends.push((item.column + item.width, start));
                }
            }
        }
        self.items = line;
    }
}

/// What is needed to find cells.
struct CellFinder<'a> {
    items: &'a [FormatItem],
    roles: &'a [ItemRole],
    blanks: &'a [bool],
}

impl CellFinder<'_> {
    fn start(&self, at: usize) -> Option<StatementStart> {
        self.roles.get(at).map(|role| role.start)
    }

    /// Whether items of a line may be cells: there is more space than usual before one, or there
    /// are numbers with and without space before them.
    fn may_have_cells(&self, block: Range<usize>) -> bool {
        let (mut is_apart, mut is_close) = (false, false);
        let items = self.items.iter().zip(self.blanks).enumerate();
        for (at, (item, blank)) in items.take(block.end).skip(block.start) {
            if item.breaks > 0 {
                continue;
            }
            if item.blanks > u32::from(*blank) {
                return true;
            }
            let number = if item.is_prefix { at + 1 } else { at };
            let number = self.items.get(number).and_then(FormatItem::token);
            if matches!(number, Some(T::Int | T::Float)) {
                is_apart |= item.blanks > 0;
                is_close |= item.blanks == 0 && *blank;
            }
        }
        is_apart && is_close
    }

    fn is_cell(&self, at: usize, are_rows: bool) -> bool {
        match self.start(at) {
            Some(StatementStart::Nothing | StatementStart::Comment) => {
                self.blanks.get(at) == Some(&true)
            }
            // A body on the line of its header.
            Some(StatementStart::Body | StatementStart::Open) => self.blanks.get(at) == Some(&true),
            Some(StatementStart::Statement) => {
                let before = at.checked_sub(1).and_then(|at| self.items.get(at));
                let is_labelled = at.checked_sub(1).and_then(|at| self.roles.get(at));
                are_rows && before.is_some_and(|before| before.is(T::Semicolon))
                    || is_labelled.is_some_and(|label| label.is_label)
            }
            _ => false,
        }
    }

    fn is_wide(&self, at: usize) -> bool {
        let usual = u32::from(self.blanks.get(at) == Some(&true));
        // A statement may be aligned by space before the semicolon of the one before.
        let before = at.checked_sub(1).and_then(|at| self.items.get(at));
        let before = before.filter(|_| self.start(at) == Some(StatementStart::Statement));
        self.items.get(at).is_some_and(|item| item.blanks > usual)
            || before.is_some_and(|before| before.is(T::Semicolon) && before.blanks > 0)
    }

    /// The items of consecutive lines that are below one another and alike.
    fn pairs(&self, above: &CellLine, own: &CellLine) -> Vec<CellPair> {
        let numbers = meet(&above.ends, &own.ends).into_iter();
        let column = |at: usize| self.items.get(at).map(|item| item.column);
        let numbers = numbers.map(|(above, below)| CellPair {
            above,
            below,
            side: (column(above) != column(below)).then_some(CellSide::End),
        });
        let starts = meet(&above.starts, &own.starts).into_iter();
        let starts = starts.map(|(above, below)| CellPair {
            above,
            below,
            side: Some(CellSide::Start),
        });
        let are_rows = above.is_row && own.is_row;
        let is_cell = |pair: &CellPair| {
            self.is_cell(pair.above, are_rows) && self.is_cell(pair.below, are_rows)
        };
        // A line that continues a statement is not in a table with the next statement.
        let starts_statement = |line: &CellLine| {
            let start = self.start(line.items.start);
            start.is_some_and(|start| start != StatementStart::Nothing)
        };
        let is_next = starts_statement(own) && !starts_statement(above);
        let is_comment = |at: usize| self.items.get(at).is_some_and(FormatItem::is_comment);
        let pairs = numbers.chain(starts.filter(is_cell));
        let pairs = pairs.filter(|pair| {
            (!is_next || is_comment(pair.below))
                && are_alike(self.items, self.roles, pair)
                && self.blanks.get(pair.above) == self.blanks.get(pair.below)
        });
        pairs.collect()
    }

    /// Whether there is more space than usual before one of two items.
    fn are_apart(&self, pair: &CellPair, is_single: bool) -> bool {
        let space = |at: usize| {
            let item = self.items.get(at);
            item.map(|item| item.column.saturating_sub(item.blanks))
        };
        // A number that is shorter than the other has more space.
        let is_padded = is_single
            && pair.side == Some(CellSide::End)
            && space(pair.above) == space(pair.below)
            && follow_alike(self.items, self.roles, pair);
        is_padded || self.is_wide(pair.above) || self.is_wide(pair.below)
    }
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

impl Cells {
    /// No cells of a text with this number of items.
    pub fn new(count: usize) -> Cells {
        Cells {
            columns: vec![NONE; count],
            sides: Vec::new(),
            padded: Vec::new(),
        }
    }

    /// Finds the columns of a block. `blanks` says before which items a space belongs; `rows` lists
    /// the lines whose statements may share a line.
    pub fn find(
        &mut self,
        items: &[FormatItem],
        roles: &[ItemRole],
        blanks: &[bool],
        block: Range<usize>,
        rows: &[StatementRow],
    ) {
        self.remove(block.clone());
        self.sides.clear();
        self.padded.clear();
        let finder = CellFinder {
            items,
            roles,
            blanks,
        };
        if !finder.may_have_cells(block.clone()) {
            return;
        }
        let (mut above, mut own) = (CellLine::default(), CellLine::default());
        own.items = block.start..block.start;
        let mut rows = rows.iter().peekable();
        let inner = items.get(block.clone()).unwrap_or(&[]);
        for line in inner.chunk_by(|a, b| a.line == b.line) {
            std::mem::swap(&mut above, &mut own);
            own.read(items, above.items.end..above.items.end + line.len());
            let row = rows.next_if(|row| row.from == own.items.start);
            own.is_row = row.is_some_and(|row| row.fits);
            if !are_consecutive(items, &above.items, &own.items) {
                continue;
            }
            let semicolons = line.iter().filter(|i| i.is(T::Semicolon));
            let is_single = semicolons.count() < 2;
            let pairs = finder.pairs(&above, &own);
            let is_table = pairs.iter().any(|pair| finder.are_apart(pair, is_single));
            for pair in pairs {
                let start = finder.start(pair.above);
                let is_padded = is_table && start == Some(StatementStart::Statement)
                    || finder.are_apart(&pair, is_single);
                if is_padded || pair.side.is_none() {
                    self.join(&pair, is_padded);
                }
            }
        }
        self.remove_unpadded(blanks, block);
    }

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
    pub fn remove(&mut self, range: Range<usize>) {
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
            self.columns.set_at(at, column);
        }
    }

    /// Removes columns without additional space, and cells before which no space belongs, such as
    /// first arguments, unless they are aligned at their ends.
    fn remove_unpadded(&mut self, blanks: &[bool], block: Range<usize>) {
        let (sides, padded) = (&self.sides, &self.padded);
        let columns = self.columns.iter_mut().zip(blanks);
        for (column, blank) in columns.take(block.end).skip(block.start) {
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
        && (matches!(role.start, StatementStart::Body | StatementStart::Open)
            || sort(items, pair.above) == sort(items, pair.below))
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

impl Cells {
    /// Aligns the cells of each column of a block.
    pub fn align(
        &self,
        items: &[FormatItem],
        roles: &[ItemRole],
        block: Range<usize>,
        places: &mut [ItemPlace],
    ) {
        if self.sides.is_empty() {
            return;
        }
        let lines = BlockLines::of(places, block);
        let mut columns = self.still_aligned(items, roles, &lines, places);
        columns.sort_by_key(|cells| cells.first().and_then(|i| items.get(*i)).map(|i| i.column));
        // The width of a cell that is aligned at its end.
        let width = |at: usize| -> u32 {
            let column = self.column(at);
            if column.and_then(|column| self.side(column)) != Some(CellSide::End) {
                return 0;
            }
            let item = items.get(at);
            let number = items
                .get(at + 1)
                .filter(|_| item.is_some_and(|i| i.is_prefix));
            item.map_or(0, |i| i.width) + number.map_or(0, |i| i.width)
        };
        // The shift of each line so far, and the additional space before each cell.
        let mut moved = vec![0u32; lines.count];
        let mut pads = vec![0u32; lines.block.len()];
        // The column of each bracket that contains a cell.
        let mut opened = vec![None; lines.block.len()];
        for cells in &columns {
            let now = cells.iter().filter_map(|at| {
                let place = places.get(*at)?;
                let line = lines.of_place(place);
                let shift = moved.get(line).copied()?;
                let bracket = roles.get(*at)?.bracket.map(|open| open as usize);
                let bracket = bracket.and_then(|open| {
                    let bracket = places.get(open).filter(|b| b.line == place.line)?;
                    let opened = opened.get_mut(open.checked_sub(lines.block.start)?)?;
                    Some(*opened.get_or_insert(bracket.column + shift))
                });
                Some(CellNow {
                    at: *at,
                    line,
                    column: place.column + width(*at) + shift,
                    // Numbers are aligned where their brackets are.
                    bracket: bracket.filter(|_| width(*at) > 0),
                })
            });
            let now: Vec<CellNow> = now.collect();
            for cells in now.chunk_by(|a, b| a.bracket == b.bracket) {
                let target = cells.iter().map(|cell| cell.column).max().unwrap_or(0);
                for cell in cells {
                    let pad = pads.get_mut(cell.at - lines.block.start);
                    if let (Some(moved), Some(pad)) = (moved.get_mut(cell.line), pad) {
                        *moved += target - cell.column;
                        *pad += target - cell.column;
                    }
                }
            }
        }
        let (mut shift, mut line) = (0, 0);
        let places = places.get_mut(lines.block).unwrap_or(&mut []);
        for (place, pad) in places.iter_mut().zip(pads) {
            if place.line != line {
                (shift, line) = (0, place.line);
            }
            shift += pad;
            place.column += shift;
        }
    }

    /// The columns whose cells are still in consecutive lines.
    fn still_aligned(
        &self,
        items: &[FormatItem],
        roles: &[ItemRole],
        lines: &BlockLines,
        places: &[ItemPlace],
    ) -> Vec<Vec<usize>> {
        let held = lines.held(items, roles, places);
        let mut open: Vec<Vec<usize>> = vec![Vec::new(); self.sides.len()];
        let mut closed = Vec::new();
        for at in lines.block.clone() {
            let column = self.column(at).map(|column| column as usize);
            let cells = column.and_then(|column| open.get_mut(column));
            let (Some(cells), Some(place)) = (cells, places.get(at)) else {
                continue;
            };
            let line = lines.of_place(place);
            let is_comment = items.get(at).is_some_and(FormatItem::is_comment);
            let is_held = held.get(line).is_some_and(|held| at <= *held);
            // The brace of a block of several lines.
            let opens = roles.get(at).filter(|r| r.start == StatementStart::Open);
            let close = opens.and_then(|role| places.get(role.partner? as usize));
            let is_open = close.is_some_and(|close| close.line != place.line);
            if place.breaks > 0 || is_open || (is_held && !is_comment) {
                continue;
            }
            let last = cells.last().and_then(|i| places.get(*i));
            if last.is_some_and(|last| lines.of_place(last) + 1 != line) {
                closed.push(std::mem::take(cells));
            }
            cells.push(at);
        }
        closed.append(&mut open);
        closed.retain(|cells| cells.len() > 1);
        closed
    }
}

/// A cell while columns are aligned.
struct CellNow {
    at: usize,
    line: usize,
    column: u32,
    /// The column of the bracket around a number on its line.
    bracket: Option<u32>,
}

/// The lines of a block in the output.
struct BlockLines {
    block: Range<usize>,
    first: u32,
    count: usize,
}

impl BlockLines {
    fn of(places: &[ItemPlace], block: Range<usize>) -> BlockLines {
        let own = places.get(block.clone()).unwrap_or(&[]);
        let first = own.first().map_or(0, |place| place.line);
        let last = own.last().map_or(0, |place| place.line);
        BlockLines {
            block,
            first,
            count: last.saturating_sub(first) as usize + 1,
        }
    }

    /// The index of the line of a place.
    fn of_place(&self, place: &ItemPlace) -> usize {
        place.line.saturating_sub(self.first) as usize
    }

    /// By line: the last item that must not move, because a later line is aligned with it. A line
    /// whose statement continues on the next line without such alignment does not move at all.
    fn held(&self, items: &[FormatItem], roles: &[ItemRole], places: &[ItemPlace]) -> Vec<usize> {
        let mut held = vec![0; self.count];
        for at in self.block.clone().skip(1) {
            let place = places.get(at).filter(|place| place.breaks > 0);
            let Some(place) = place else {
                continue;
            };
            let other = place
                .depends_on
                .and_then(|other| Some((self.of_place(places.get(other as usize)?), other)));
            if let Some((line, other)) = other
                && let Some(held) = held.get_mut(line)
            {
                *held = (*held).max(other as usize);
            }
            let above = self.of_place(place).saturating_sub(1);
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
}
