//! Positions of the protocol: lines and columns in the unit that the client chooses.

use gen_lsp_types::{Position, Range, TextEdit};
use shaderlint_text::{Edit, LineIndex, Span};

/// The unit of columns.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Columns {
    /// Bytes.
    Utf8,
    /// UTF-16 code units, the default of the protocol.
    #[default]
    Utf16,
    /// Unicode scalar values.
    Utf32,
}

impl Columns {
    /// The cheapest unit among those that a client offers.
    pub fn choose(offered: &[&str]) -> Columns {
        let offers = |columns: Columns| offered.contains(&columns.name());
        if offers(Columns::Utf8) {
            Columns::Utf8
        } else if offers(Columns::Utf32) && !offers(Columns::Utf16) {
            Columns::Utf32
        } else {
            Columns::Utf16
        }
    }

    /// The name of the unit in the protocol.
    pub fn name(self) -> &'static str {
        match self {
            Columns::Utf8 => "utf-8",
            Columns::Utf16 => "utf-16",
            Columns::Utf32 => "utf-32",
        }
    }

    /// The length of a text in this unit.
    pub fn count(self, text: &str) -> u32 {
        match self {
            Columns::Utf8 => text.len() as u32,
            Columns::Utf16 => text.encode_utf16().count() as u32,
            Columns::Utf32 => text.chars().count() as u32,
        }
    }
}

/// A text with its line offsets.
#[derive(Clone, Copy)]
pub struct TextLines<'t> {
    /// The complete text.
    pub text: &'t str,
    /// Offsets of its lines.
    pub index: &'t LineIndex,
    /// Unit of columns.
    pub columns: Columns,
}

impl TextLines<'_> {
    /// Converts an offset to a position.
    pub fn position(&self, offset: u32) -> Position {
        let at = self
            .index
            .position(self.text, offset.min(self.text.len() as u32));
        let start = self.index.start(at.line).unwrap_or(0);
        let character = match self.columns {
            Columns::Utf8 => at.byte - start,
            Columns::Utf16 => at.utf16 - 1,
            Columns::Utf32 => at.column - 1,
        };
        Position {
            line: at.line - 1,
            character,
        }
    }

    /// Converts a span to a range.
    pub fn range(&self, span: Span) -> Range {
        Range {
            start: self.position(span.start),
            end: self.position(span.end),
        }
    }

    /// Converts a position to an offset. Positions after the end of a line or of the text mean that
    /// end, as the protocol defines.
    pub fn offset(&self, position: Position) -> u32 {
        let Some(start) = self.index.start(position.line.saturating_add(1)) else {
            return self.text.len() as u32;
        };
        let (_, end) = self.index.bounds(start, self.text.len() as u32);
        let line = self.text.get(start as usize..end as usize).unwrap_or("");
        let line = line.trim_end_matches(['\n', '\r']);
        let mut left = position.character;
        for (at, c) in line.char_indices() {
            let mut units = [0; 4];
            let size = self.columns.count(c.encode_utf8(&mut units));
            if left < size || left == 0 {
                return start + at as u32;
            }
            left -= size;
        }
        start + line.len() as u32
    }

    /// Converts a range to a span.
    pub fn span(&self, range: Range) -> Span {
        let start = self.offset(range.start);
        Span::new(start, self.offset(range.end).max(start))
    }
}

/// Converts edits of one text.
pub fn text_edits(lines: TextLines, edits: &[Edit]) -> Vec<TextEdit> {
    let edit = |edit: &Edit| TextEdit {
        range: lines.range(edit.span),
        new_text: edit.text.clone(),
    };
    edits.iter().map(edit).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn offsets_and_positions_convert_in_each_encoding() {
        let text = "a𝄞é\r\nx\n\ty";
        let index = LineIndex::new(text);
        for columns in [Columns::Utf8, Columns::Utf16, Columns::Utf32] {
            let lines = TextLines {
                text,
                index: &index,
                columns,
            };
            let ends = text.char_indices().map(|(at, _)| at).chain([text.len()]);
            for at in ends.filter(|at| text.as_bytes().get(*at) != Some(&b'\n')) {
                let position = lines.position(at as u32);
                assert_eq!(lines.offset(position), at as u32, "{columns:?} {at}");
            }
            let beyond = Position {
                line: 0,
                character: 99,
            };
            assert_eq!(lines.offset(beyond), 7);
            let after = Position {
                line: 9,
                character: 0,
            };
            assert_eq!(lines.offset(after), text.len() as u32);
        }
    }
}
