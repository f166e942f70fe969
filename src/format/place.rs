//! The position of each item, assigned line by line.

use super::item::{FormatItem, ItemKind};
use super::request::{Lines, TextExtent};
use super::spacing::precedence;
use super::structure::{ItemRole, StatementStart};
use super::style::Style;
use shaderlint_syntax::TokenKind as T;
use shaderlint_text::SetAt;

/// Maximum number of consecutive empty lines.
const MAX_EMPTY: u32 = 2;

/// The position of an item.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct ItemPlace {
    /// The number of line breaks before it.
    pub breaks: u32,
    /// The column at which it starts.
    pub column: u32,
    /// The indentation level of its line, if it is the first item.
    pub level: u32,
    /// The index of its line in the output.
    pub line: u32,
    /// Whether the white space before it is kept.
    pub keeps: bool,
    /// The item on a previous line with which its line is aligned.
    pub depends_on: Option<u32>,
}

/// Where the layout is in a text.
#[derive(Clone, Copy, Default)]
pub struct LayoutPoint {
    /// The column after the last item.
    pub end: u32,
    /// The first item of the current statement, and the column of its line.
    pub statement: usize,
    pub statement_column: u32,
    /// The last item of the block that is kept on one line.
    pub inline: Option<usize>,
    /// The source line whose statements stay on the line of their label.
    pub labelled: Option<u32>,
    /// The item after those of a line that was too long, which have their positions.
    pub laid: usize,
    /// Whether there was such a line.
    pub is_over: bool,
    /// The indentation level of an `if` whose body did not fit on its line.
    pub split: Option<u32>,
    /// While such a line is broken: the item after it, and the width of what must follow.
    pub last: usize,
    pub after: u32,
}

/// The items placed so far.
pub struct LineLayout<'a> {
    pub text: &'a str,
    pub items: &'a mut [FormatItem],
    pub roles: &'a [ItemRole],
    pub style: &'a Style,
    pub extent: TextExtent,
    pub lines: Lines,
    pub base: u32,
    /// By item: whether it starts a statement that stays on the same line as the previous one.
    pub in_rows: Vec<bool>,
    /// By item: the last item of the statement that starts there, if it fills the line before.
    pub filled: Vec<usize>,
    /// By item: whether it is aligned with items of other lines.
    pub aligned: Vec<bool>,
    pub blanks: Vec<bool>,
    /// By item: the column of its end if all items were on one line.
    pub ends: Vec<u32>,
    pub places: Vec<ItemPlace>,
    /// By line: its first item.
    pub starts: Vec<usize>,
    /// By bracket and kind of line start: the item that started the last such line inside the
    /// bracket.
    pub siblings: Vec<[Option<u32>; 3]>,
    /// By item: the additional indentation of a line that starts with it.
    pub steps: Vec<u8>,
    /// Of chains of `? :`: each `:`, and the first item of the first condition.
    pub chains: Vec<(u32, u32)>,
    /// By opening bracket: whether the elements of its list are of one kind, once that is known.
    pub lists: Vec<Option<bool>>,
    /// By item: whether it is in such a list that is filled again, so that the line break before it
    /// is not kept.
    pub joined: Vec<bool>,
    /// Whether such a list was found since the last layout of the block.
    pub found_list: bool,
    /// Whether lines end with operators, rather than start with them.
    pub operators_end_lines: bool,
    /// The item after the last one of the current block.
    pub block_end: usize,
    pub point: LayoutPoint,
}

impl LineLayout<'_> {
    pub(super) fn item(&self, at: usize) -> Option<&FormatItem> {
        self.items.get(at)
    }

    pub(super) fn role(&self, at: usize) -> ItemRole {
        self.roles.get(at).copied().unwrap_or_default()
    }

    pub(super) fn placed(&self, at: usize) -> ItemPlace {
        self.places.get(at).copied().unwrap_or_default()
    }

    pub(super) fn before(&self, at: usize) -> Option<&FormatItem> {
        at.checked_sub(1).and_then(|i| self.items.get(i))
    }

    /// Whether an item is the first of a line.
    pub(super) fn begins_line(&self, at: usize) -> bool {
        self.starts.last() == Some(&at)
    }

    /// The indentation level of an item that starts a line.
    pub(super) fn level(&self, at: usize, item: &FormatItem) -> u32 {
        let role = self.role(at);
        match item.kind {
            // Directives at the margin stay there; others are indented like the code around them.
            ItemKind::Directive(_) if item.column <= self.base => 0,
            _ => role.level,
        }
    }

    /// The indentation level of statements outside functions.
    pub(super) fn base_level(&self) -> u32 {
        self.base / self.style.indent.width().max(1)
    }

    pub(super) fn line_column(&self) -> u32 {
        let first = self.starts.last().copied();
        first.map_or(0, |first| self.placed(first).column)
    }

    pub(super) fn keep(&mut self, at: usize, item: &FormatItem) {
        let is_first = item.breaks > 0 || item.is_spliced || at == 0;
        let column = match is_first {
            false => self.point.end + item.blanks,
            true => item.column,
        };
        let line = self.starts.len().saturating_sub(1) as u32;
        self.put(
            at,
            ItemPlace {
                breaks: item.breaks,
                column,
                line,
                keeps: true,
                ..ItemPlace::default()
            },
        );
        if is_first {
            self.new_line(at);
        }
        self.finish(item, column);
    }

    pub(super) fn new_line(&mut self, at: usize) {
        self.starts.push(at);
        if let Some(place) = self.places.get_mut(at) {
            place.line = self.starts.len() as u32 - 1;
        }
        if self.role(at).start == StatementStart::Nothing
            && let Some(sibling) = self.sibling(at)
        {
            *sibling = Some(at as u32);
        }
    }

    pub(super) fn put(&mut self, at: usize, place: ItemPlace) {
        self.places.set_at(at, place);
    }

    pub(super) fn finish(&mut self, item: &FormatItem, column: u32) {
        self.point.end = match item.is_tall {
            true => item.width,
            false => column + item.width,
        };
    }

    pub(super) fn go_on(&mut self, at: usize, item: &FormatItem) {
        let blank = self.blanks.get(at).copied().unwrap_or(false);
        // Statements on one line are separated by an additional space if they were.
        let apart = u32::from(blank && self.is_in_row(at) && item.blanks > 1);
        let column = self.point.end + u32::from(blank) + apart;
        let line = self.starts.len().saturating_sub(1) as u32;
        self.put(
            at,
            ItemPlace {
                column,
                line,
                ..ItemPlace::default()
            },
        );
        self.finish(item, column);
    }

    pub(super) fn start_line(&mut self, at: usize, item: &FormatItem, column: u32, level: u32) {
        let breaks = match (self.lines, self.extent) {
            (Lines::Kept, _) => item.breaks,
            // No empty lines at the start of a file.
            (Lines::Free, TextExtent::File) if at == 0 => 0,
            (Lines::Free, _) => item.breaks.clamp(1, MAX_EMPTY + 1),
        };
        self.put(
            at,
            ItemPlace {
                breaks,
                column,
                level: level + self.base_level(),
                ..ItemPlace::default()
            },
        );
        self.new_line(at);
        self.finish(item, column);
    }

    /// The item that last started a line of the same kind in the same bracket.
    pub(super) fn sibling(&mut self, at: usize) -> Option<&mut Option<u32>> {
        let bracket = self.role(at).bracket.map_or(0, |b| b as usize + 1);
        let sort = self.sort_of_line(at);
        self.siblings.get_mut(bracket)?.get_mut(sort)
    }

    /// The kind of a line start within a statement: an operator, an operand after one, or another
    /// list element.
    fn sort_of_line(&self, at: usize) -> usize {
        let token = |i: Option<&FormatItem>| i.and_then(FormatItem::token);
        let before = token(self.before(at));
        let is_first = matches!(before, Some(T::Comma | T::LeftParen | T::LeftBrace));
        let is_operator = token(self.item(at)).is_some_and(|kind| precedence(kind).is_some());
        match (is_first, is_operator) {
            (true, _) => 0,
            (false, true) => 1,
            (false, false) => 2,
        }
    }

    /// Whether an item starts a statement that stays on the same line as the previous one, as part
    /// of a table.
    pub(super) fn is_in_row(&self, at: usize) -> bool {
        self.in_rows.get(at) == Some(&true)
    }
}
