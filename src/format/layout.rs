//! The layout pass: assigns a position to every item.

use super::columns;
use super::item::FormatItem;
use super::lines::Gap;
use super::operators;
use super::place::{ItemPlace, LineLayout};
use super::request::{Lines, TextExtent};
use super::spacing::has_blank;
use super::structure::{ItemRole, StatementStart};
use super::style::Style;

/// How a text is laid out.
pub struct LayoutSettings<'a> {
    pub style: &'a Style,
    pub extent: TextExtent,
    pub lines: Lines,
    /// The column of statements outside functions.
    pub base: u32,
}

/// Maximum number of layouts of a text.
const MAX_ROUNDS: usize = 4;

/// Assigns a position to every item. Lines that were too long are laid out again from where they
/// are now, so that formatting the result would not change it.
pub fn place(
    text: &str,
    items: &mut [FormatItem],
    roles: &[ItemRole],
    settings: &LayoutSettings,
) -> Vec<ItemPlace> {
    let (mut places, mut is_over) = place_once(text, items, roles, settings);
    for _ in 1..MAX_ROUNDS {
        if !is_over {
            break;
        }
        move_items(text, items, &places);
        let before = std::mem::take(&mut places);
        (places, is_over) = place_once(text, items, roles, settings);
        is_over &= places != before;
    }
    places
}

/// Moves items to their positions.
fn move_items(text: &str, items: &mut [FormatItem], places: &[ItemPlace]) {
    let (mut line, mut end) = (0, 0);
    for (item, place) in items.iter_mut().zip(places) {
        line += place.breaks;
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
            line += line_breaks(text.get(span).unwrap_or(""));
        }
    }
}

fn line_breaks(text: &str) -> u32 {
    let count = |text: &str, of| text.matches(of).count();
    (count(text, "\n") + count(text, "\r") - count(text, "\r\n")) as u32
}

/// Assigns a position to every item, and whether there were lines that were too long.
fn place_once(
    text: &str,
    items: &[FormatItem],
    roles: &[ItemRole],
    settings: &LayoutSettings,
) -> (Vec<ItemPlace>, bool) {
    let blanks = blanks(text, items, roles);
    let mut layout = LineLayout {
        items,
        roles,
        style: settings.style,
        extent: settings.extent,
        lines: settings.lines,
        base: settings.base,
        in_rows: Vec::new(),
        aligned: Vec::new(),
        filled: Vec::new(),
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
        steps: operators::steps(items, roles),
        operators_end_lines: operators::end_lines(items, roles),
        laid: 0,
        is_over: false,
        split: None,
        last: 0,
        after: 0,
    };
    layout.ends = layout.flat_ends();
    let rows = layout.rows();
    let mut cells = columns::cells(items, roles, &layout.blanks, &rows);
    layout.filled = layout.refilled(&rows);
    for (at, last) in layout.filled.iter().enumerate().filter(|(_, l)| **l > 0) {
        cells.remove(at..=*last);
    }
    layout.aligned = (0..items.len()).map(|at| cells.contain(at)).collect();
    layout.in_rows = layout.in_rows(&rows);
    layout.is_over = layout.filled.iter().any(|last| *last > 0);
    for at in 0..items.len() {
        layout.set(at);
    }
    let mut places = layout.places;
    let is_over = layout.is_over;
    columns::align(items, roles, &cells, &mut places);
    (places, is_over)
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
        if at < self.laid {
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
                self.split = role.level.checked_sub(1);
            }
            StatementStart::Statement | StatementStart::Close => self.split = None,
            _ => {}
        }
        if starts && !item.is_comment() {
            self.statement = at;
            self.statement_column = self.line_column();
            if let Some(outer) = self.siblings.first_mut() {
                *outer = [None; 3];
            }
        }
        if gap != Gap::Kept && (gap != Gap::Line || starts) {
            self.fit(at);
        }
    }
}
