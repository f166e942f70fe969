//! Converts byte offsets to lines and columns.

use memchr::memchr2_iter;
use serde::Serialize;

/// A position as people and editors count it. All numbers except `byte` start at 1.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, Serialize)]
pub struct Position {
    /// Line number; `\n`, `\r\n` and a lone `\r` end a line (GLSL ES 3.00 section 3.1).
    pub line: u32,
    /// Column in Unicode scalar values.
    pub column: u32,
    /// Column in UTF-16 code units.
    pub utf16: u32,
    /// Offset in bytes from the start of the file, from 0.
    pub byte: u32,
}

/// The offsets of line starts.
#[derive(Clone, Debug)]
pub struct LineIndex {
    starts: Vec<u32>,
    /// The multi-byte characters, so that columns are found without scanning long lines.
    wide: Vec<Wide>,
}

/// A multi-byte character.
#[derive(Clone, Copy, Default, Debug)]
struct Wide {
    /// Byte offset.
    at: u32,
    /// Total number of bytes beyond one per character, up to and including this character.
    extra: u32,
    /// Total number of characters that need two UTF-16 units, up to and including this one.
    pairs: u32,
}

impl LineIndex {
    /// Finds the lines of `text`, whose length must fit 32 bits.
    pub fn new(text: &str) -> LineIndex {
        let bytes = text.as_bytes();
        let mut starts = vec![0];
        for i in memchr2_iter(b'\n', b'\r', bytes) {
            let goes_on = bytes.get(i) == Some(&b'\r') && bytes.get(i + 1) == Some(&b'\n');
            if !goes_on {
                starts.push(i as u32 + 1);
            }
        }
        LineIndex {
            starts,
            wide: wide(text),
        }
    }

    /// Number of lines; a text that ends with a line break has an empty last line.
    pub fn count(&self) -> u32 {
        self.starts.len() as u32
    }

    /// Offset of the first byte of a line, numbered from 1.
    pub fn start(&self, line: u32) -> Option<u32> {
        self.starts.get((line as usize).checked_sub(1)?).copied()
    }

    /// Number of the line that contains `offset`, from 1.
    pub fn line(&self, offset: u32) -> u32 {
        self.starts.partition_point(|&s| s <= offset) as u32
    }

    /// Offsets of the start and the end of the line that contains `offset`. The end is the start of
    /// the next line, or `length` in the last line.
    pub fn bounds(&self, offset: u32, length: u32) -> (u32, u32) {
        let line = self.line(offset);
        let start = self.start(line).unwrap_or(0);
        (start, self.start(line + 1).unwrap_or(length))
    }

    /// Line and columns of `offset` in the text of the index. An offset inside a character counts
    /// as its start.
    pub fn position(&self, text: &str, offset: u32) -> Position {
        let line = self.line(offset);
        let start = self.start(line).unwrap_or(0) as usize;
        let mut end = (offset as usize).min(text.len());
        while !text.is_char_boundary(end) {
            end -= 1;
        }
        let (from, to) = (self.wide_before(start), self.wide_before(end));
        let bytes = end.saturating_sub(start) as u32;
        let characters = bytes - (to.extra - from.extra);
        let pairs = to.pairs - from.pairs;
        Position {
            line,
            column: characters + 1,
            utf16: characters + pairs + 1,
            byte: offset,
        }
    }

    /// The last multi-byte character that starts before an offset.
    fn wide_before(&self, offset: usize) -> Wide {
        let after = self.wide.partition_point(|w| (w.at as usize) < offset);
        let last = after.checked_sub(1).and_then(|i| self.wide.get(i));
        last.copied().unwrap_or_default()
    }
}

/// Number of bytes that are skipped at once if they are ASCII.
const CHUNK: usize = 64;

/// Finds the multi-byte characters.
fn wide(text: &str) -> Vec<Wide> {
    let mut last = Wide::default();
    let mut found = Vec::new();
    for (start, chunk) in (0..).step_by(CHUNK).zip(text.as_bytes().chunks(CHUNK)) {
        if chunk.is_ascii() {
            continue;
        }
        for (at, byte) in (start..).zip(chunk) {
            // The first byte determines the length (RFC 3629).
            let length = match byte {
                0xc0..0xe0 => 2,
                0xe0..0xf0 => 3,
                0xf0.. => 4,
                _ => continue,
            };
            last = Wide {
                at,
                extra: last.extra + length - 1,
                pairs: last.pairs + u32::from(length == 4),
            };
            found.push(last);
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(text: &str, offset: u32, line: u32, column: u32, utf16: u32) {
        let p = LineIndex::new(text).position(text, offset);
        assert_eq!(
            (p.line, p.column, p.utf16, p.byte),
            (line, column, utf16, offset)
        );
    }

    #[test]
    fn lines_end_as_in_glsl() {
        check("a\nb", 2, 2, 1, 1);
        check("a\r\nb", 3, 2, 1, 1);
        check("a\rb", 2, 2, 1, 1);
        check("a\n", 2, 2, 1, 1);
    }

    #[test]
    fn columns_count_characters_and_utf16_units() {
        check("é𝄞x", 6, 1, 3, 4);
        check("é𝄞x", 3, 1, 2, 2);
        check("é𝄞x\né𝄞x", 14, 2, 3, 4);
    }
}
