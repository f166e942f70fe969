//! The layout pass: assigns a position to every item, block by block.

use super::columns::Cells;
use super::item::FormatItem;
use super::lines::Gap;
use super::operators;
use super::place::{ItemPlace, LayoutPoint, LineLayout};
use super::request::{Lines, TextExtent};
use super::structure::{ItemRole, StatementStart};
use super::style::Style;
use shaderlint_text::SetAt;
use std::ops::Range;

/// How a text is laid out.
pub struct LayoutSettings<'a> {
    pub style: &'a Style,
    pub extent: TextExtent,
    pub lines: Lines,
    /// The column of statements outside functions.
    pub base: u32,
}

/// Maximum number of layouts of a block.
const MAX_ROUNDS: usize = 6;

/// Assigns a position to every item.
pub fn place(
    text: &str,
    items: &mut [FormatItem],
    roles: &[ItemRole],
    blanks: Vec<bool>,
    settings: &LayoutSettings,
) -> Vec<ItemPlace> {
    let count = items.len();
    let mut layout = LineLayout {
        text,
        roles,
        style: settings.style,
        extent: settings.extent,
        lines: settings.lines,
        base: settings.base,
        in_rows: vec![false; count],
        aligned: vec![false; count],
        filled: vec![0; count],
        ends: flat_ends(items, &blanks),
        blanks,
        places: vec![ItemPlace::default(); count],
        starts: Vec::new(),
        siblings: vec![[None; 3]; count + 1],
        steps: operators::steps(items, roles),
        chains: operators::chains(items, roles),
        lists: vec![None; count],
        joined: vec![false; count],
        found_list: false,
        operators_end_lines: operators::end_lines(items, roles),
        items,
        block_end: 0,
        point: LayoutPoint::default(),
    };
    let mut cells = Cells::new(count);
    let mut from = 0;
    while from < count {
        let starts_block = |at: &usize| layout.starts_block(*at);
        let to = (from + 1..count).find(starts_block).unwrap_or(count);
        layout.place_block(from..to, &mut cells);
        from = to;
    }
    layout.places
}

/// The column of statements outside functions, if the text is embedded in another: that of the
/// first one that starts a line.
pub fn base(items: &[FormatItem], roles: &[ItemRole], extent: TextExtent) -> u32 {
    let is_outer = |(item, role): &(&FormatItem, &ItemRole)| {
        item.breaks > 0 && role.start == StatementStart::Statement && role.level == 0
    };
    match extent {
        TextExtent::File => 0,
        TextExtent::Inside => {
            let outer = items.iter().zip(roles).find(is_outer);
            outer.map_or(0, |(item, _)| item.column)
        }
    }
}

/// By item: the column of its end if all items were on one line.
fn flat_ends(items: &[FormatItem], blanks: &[bool]) -> Vec<u32> {
    let mut end = 0u32;
    let ends = items.iter().zip(blanks).map(|(item, blank)| {
        end = end
            .saturating_add(item.width)
            .saturating_add(u32::from(*blank));
        end
    });
    ends.collect()
}

fn line_breaks(text: &str) -> u32 {
    let count = |text: &str, of| text.matches(of).count();
    (count(text, "\n") + count(text, "\r") - count(text, "\r\n")) as u32
}

impl LineLayout<'_> {
    /// Whether the layout of what follows does not depend on the lines before: after an empty line
    /// between statements, or after the end of a function.
    fn starts_block(&self, at: usize) -> bool {
        let (Some(item), Some(before)) = (self.item(at), self.before(at)) else {
            return false;
        };
        let role = self.role(at);
        let is_between = match role.start {
            StatementStart::Statement | StatementStart::Comment => !item.keeps,
            _ => false,
        };
        let is_after_function = || {
            let last = self.role(at - 1);
            (last.start, last.level, role.level) == (StatementStart::Close, 0, 0)
                && before.breaks > 0
                && !before.keeps
        };
        is_between && (item.breaks > 1 || item.breaks > 0 && is_after_function())
    }

    /// Assigns positions to the items of a block. If lines were too long, it is laid out again from
    /// where its items are now, so that formatting the result would not change it.
    fn place_block(&mut self, block: Range<usize>, cells: &mut Cells) {
        let (before, lines) = (self.point, self.starts.len());
        let outer = self.siblings.first().copied().unwrap_or_default();
        let mut last: Option<Vec<ItemPlace>> = None;
        for _ in 0..MAX_ROUNDS {
            if let Some(brackets) = self.siblings.get_mut(block.start + 1..=block.end) {
                brackets.fill([None; 3]);
            }
            self.siblings
                .first_mut()
                .into_iter()
                .for_each(|first| *first = outer);
            self.starts.truncate(lines);
            self.point = before;
            self.place_once(block.clone(), cells);
            if std::mem::take(&mut self.found_list) {
                continue;
            }
            let places = self.places.get(block.clone()).unwrap_or(&[]);
            if !self.point.is_over || last.as_deref() == Some(places) {
                break;
            }
            last = Some(places.to_vec());
            self.move_items(block.clone());
        }
        self.point.is_over = false;
    }

    fn place_once(&mut self, block: Range<usize>, cells: &mut Cells) {
        self.block_end = block.end;
        let rows = self.rows(block.clone());
        cells.find(self.items, self.roles, &self.blanks, block.clone(), &rows);
        for refilled in self.refill(block.clone(), &rows) {
            cells.remove(refilled);
        }
        for at in block.clone() {
            if self.joined.get(at) == Some(&true) {
                cells.remove(at..at + 1);
            }
            self.aligned.set_at(at, cells.contain(at));
        }
        self.keep_rows(block.clone(), &rows);
        for at in block.clone() {
            self.set(at);
        }
        cells.align(self.items, self.roles, block, &mut self.places);
    }

    /// Moves the items of a block to their positions.
    fn move_items(&mut self, block: Range<usize>) {
        let mut line = self.item(block.start).map_or(0, |first| first.line);
        let mut end = 0;
        let items = self.items.iter_mut().zip(&self.places).enumerate();
        for (at, (item, place)) in items.take(block.end).skip(block.start) {
            if at > block.start {
                line += place.breaks;
            }
            item.breaks = place.breaks;
            item.blanks = match place.breaks {
                0 => place.column.saturating_sub(end),
                _ => place.column,
            };
            item.line = line;
            item.column = place.column;
            end = match item.is_tall {
                true => item.width,
                false => place.column + item.width,
            };
            if item.is_tall {
                let span = item.span.start as usize..item.span.end as usize;
                line += line_breaks(self.text.get(span).unwrap_or(""));
            }
        }
    }

    fn set(&mut self, at: usize) {
        let Some(item) = self.items.get(at).copied() else {
            return;
        };
        let item = &item;
        if at < self.point.laid {
            return self.note(at, item, Gap::Line);
        }
        let gap = self.gap(at, item);
        self.note(at, item, gap);
        match gap {
            Gap::Kept => self.keep(at, item),
            Gap::Line => self.go_on(at, item),
            Gap::Level => {
                let level = self.level(at, item);
                let column = self.base + level * self.style.indent.width();
                self.start_line(at, item, column, level);
            }
            Gap::Inside => {
                let (column, depends_on) = self.continuation(at, item);
                self.start_line(at, item, column, self.role(at).level);
                if let Some(place) = self.places.get_mut(at) {
                    place.depends_on = depends_on;
                }
            }
        }
        let role = self.role(at);
        let starts = role.start != StatementStart::Nothing;
        match role.start {
            StatementStart::Body if gap == Gap::Level && item.breaks == 0 => {
                self.point.split = role.level.checked_sub(1);
            }
            StatementStart::Statement | StatementStart::Close => self.point.split = None,
            _ => {}
        }
        if starts && !item.is_comment() {
            self.point.statement = at;
            self.point.statement_column = self.line_column();
            if let Some(outer) = self.siblings.first_mut() {
                *outer = [None; 3];
            }
        }
        if gap != Gap::Kept && (gap != Gap::Line || starts) {
            self.fit(at);
        }
    }
}
