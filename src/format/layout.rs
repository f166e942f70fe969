//! The layout pass: assigns a position to every item.

use super::columns;
use super::item::FormatItem;
use super::lines::Gap;
use super::place::{ItemPlace, LineLayout};
use super::request::{Lines, TextExtent};
use super::spacing::has_blank;
use super::structure::{ItemRole, StatementStart};
use super::style::Style;

/// Assigns a position to every item.
pub fn place(
    text: &str,
    items: &[FormatItem],
    roles: &[ItemRole],
    style: &Style,
    extent: TextExtent,
    lines: Lines,
) -> Vec<ItemPlace> {
    let blanks = blanks(text, items, roles);
    let mut layout = LineLayout {
        items,
        roles,
        style,
        extent,
        lines,
        base: base(items, roles, extent),
        in_rows: Vec::new(),
        blanks,
        ends: Vec::new(),
        places: vec![ItemPlace::default(); items.len()],
        starts: Vec::new(),
        siblings: vec![[None; 3]; items.len() + 1],
        end: 0,
        statement: 0,
        statement_column: 0,
        inline: None,
        labelled: None,
        scanned: 0,
    };
    layout.ends = layout.flat_ends();
    let cells = columns::cells(items, roles, &layout.blanks, |line| layout.is_row(line));
    layout.in_rows = columns::in_rows(items, roles, &cells);
    for at in 0..items.len() {
        layout.set(at);
    }
    let mut places = layout.places;
    columns::align(items, roles, &cells, &mut places);
    places
}

/// The column of statements outside functions, if the text is embedded in another: that of the
/// first one that starts a line.
fn base(items: &[FormatItem], roles: &[ItemRole], extent: TextExtent) -> u32 {
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

/// By item: whether there is a space before it if it is on the same line.
fn blanks(text: &str, items: &[FormatItem], roles: &[ItemRole]) -> Vec<bool> {
    let pairs = items.iter().zip(items.iter().skip(1));
    let pairs = pairs.zip(roles.iter().skip(1));
    let blank = pairs.map(|((before, item), role)| has_blank(text, before, item, role));
    std::iter::once(false).chain(blank).collect()
}

impl LineLayout<'_> {
    fn set(&mut self, at: usize) {
        let Some(item) = self.items.get(at) else {
            return;
        };
        let gap = self.gap(at, item);
        self.note(at, item, gap);
        match gap {
            Gap::Kept => self.keep(at, item),
            Gap::Line => {
                self.go_on(at, item);
                self.fit(at);
            }
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
        if self.role(at).start != StatementStart::Nothing && !item.is_comment() {
            self.statement = at;
            self.statement_column = self.line_column();
            if let Some(outer) = self.siblings.first_mut() {
                *outer = [None; 3];
            }
        }
    }
}
