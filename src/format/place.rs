//! Where each item goes: what has been set so far, line by line.

use super::item::{FormatItem, ItemKind};
use super::request::{Lines, TextExtent};
use super::spacing::precedence;
use super::structure::{ItemRole, StatementStart};
use super::style::Style;
use shaderlint_syntax::TokenKind as T;

/// Most empty lines in a row.
const MAX_EMPTY: u32 = 2;

/// Where an item goes.
#[derive(Clone, Copy, Debug, Default)]
pub struct ItemPlace {
    /// Line breaks before it.
    pub breaks: u32,
    /// Column that it starts at.
    pub column: u32,
    /// Levels that its line is indented by, where it is the first of it.
    pub level: u32,
    /// Number of its line among those that are set.
    pub line: u32,
    /// Whether the white space before it stays.
    pub keeps: bool,
    /// The item in a line above that its own is lined up with.
    pub hangs_on: Option<u32>,
}

/// What has been set so far.
pub struct LineLayout<'a> {
    pub items: &'a [FormatItem],
    pub roles: &'a [ItemRole],
    pub style: &'a Style,
    pub extent: TextExtent,
    pub lines: Lines,
    pub base: u32,
    /// For each item, whether it starts a statement that stays behind another.
    pub in_rows: Vec<bool>,
    pub blanks: Vec<bool>,
    /// Where each item would end if all stood in one line.
    pub ends: Vec<u32>,
    pub places: Vec<ItemPlace>,
    /// Of each line: its first item.
    pub starts: Vec<usize>,
    /// By bracket, and by what starts the line: the last item that a line inside it started with.
    pub siblings: Vec<[Option<usize>; 3]>,
    /// Column behind the last item.
    pub end: u32,
    /// The item that the statement starts with, and the column of its line.
    pub statement: usize,
    pub statement_column: u32,
    /// The last item of the block that stands in one line.
    pub inline: Option<usize>,
    /// The line of the source whose statements stay behind their label.
    pub labelled: Option<u32>,
    /// Items before this one need not be looked at to break a line again.
    pub scanned: usize,
}

impl LineLayout<'_> {
    pub(super) fn flat_ends(&self) -> Vec<u32> {
        let mut end = 0u32;
        let widths = self.items.iter().zip(&self.blanks).map(|(item, blank)| {
            end = end
                .saturating_add(item.width)
                .saturating_add(u32::from(*blank));
            end
        });
        widths.collect()
    }

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

    /// Level of an item that starts a line.
    pub(super) fn level(&self, at: usize, item: &FormatItem) -> u32 {
        let role = self.role(at);
        match item.kind {
            // What stands at the margin stays there; else it goes with the code around it.
            ItemKind::Directive(_) if item.column <= self.base => 0,
            _ => role.level,
        }
    }

    pub(super) fn line_column(&self) -> u32 {
        let first = self.starts.last().copied();
        first.map_or(0, |first| self.placed(first).column)
    }

    pub(super) fn keep(&mut self, at: usize, item: &FormatItem) {
        let is_first = item.breaks > 0 || item.is_spliced || at == 0;
        let column = match is_first {
            false => self.end + item.blanks,
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
        self.scanned = at;
        if let Some(place) = self.places.get_mut(at) {
            place.line = self.starts.len() as u32 - 1;
        }
        if self.role(at).start == StatementStart::Nothing
            && let Some(sibling) = self.sibling(at)
        {
            *sibling = Some(at);
        }
    }

    pub(super) fn put(&mut self, at: usize, place: ItemPlace) {
        if let Some(p) = self.places.get_mut(at) {
            *p = place;
        }
    }

    pub(super) fn finish(&mut self, item: &FormatItem, column: u32) {
        self.end = match item.is_tall {
            true => item.width,
            false => column + item.width,
        };
    }

    pub(super) fn go_on(&mut self, at: usize, item: &FormatItem) {
        let blank = self.blanks.get(at).copied().unwrap_or(false);
        // Statements in one line stand apart.
        let apart = u32::from(self.is_in_row(at));
        let column = self.end + u32::from(blank) + apart;
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
            // What stands before a file starts it.
            (Lines::Free, TextExtent::File) if at == 0 => 0,
            (Lines::Free, _) => item.breaks.clamp(1, MAX_EMPTY + 1),
        };
        self.put(
            at,
            ItemPlace {
                breaks,
                column,
                level,
                ..ItemPlace::default()
            },
        );
        self.new_line(at);
        self.finish(item, column);
    }

    /// The last item that started a line as this one does.
    pub(super) fn sibling(&mut self, at: usize) -> Option<&mut Option<usize>> {
        let bracket = self.role(at).bracket.map_or(0, |b| b as usize + 1);
        let sort = self.sort_of_line(at);
        self.siblings.get_mut(bracket)?.get_mut(sort)
    }

    /// What a line inside a statement starts with: an operator, an operand behind one, or one more
    /// of a list.
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

    /// Whether an item starts a statement that stays behind another, as a part of a table.
    pub(super) fn is_in_row(&self, at: usize) -> bool {
        self.in_rows.get(at) == Some(&true)
    }
}
