//! From byte offsets to lines and columns.

use memchr::memchr2_iter;

/// A place as people and editors count it. All numbers but `byte` are 1-based.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Position {
    /// Line; `\n`, `\r\n` and a lone `\r` end one, as GLSL ES 3.00 section 3.1 has it.
    pub line: u32,
    /// Column in Unicode scalar values.
    pub column: u32,
    /// Column in UTF-16 code units.
    pub utf16: u32,
    /// Offset in bytes from the start of the file, 0-based.
    pub byte: u32,
}

/// The offsets at which a text's lines start.
#[derive(Clone, Debug)]
pub struct LineIndex {
    starts: Vec<u32>,
    /// The characters of more than one byte, so that no column needs counting, however long its
    /// line is.
    wide: Vec<Wide>,
}

/// A character of more than one byte.
#[derive(Clone, Copy, Default, Debug)]
struct Wide {
    /// Its offset.
    at: u32,
    /// How many bytes more than one such characters have, this one and all before it together.
    extra: u32,
    /// How many of them, this one included, take two UTF-16 units.
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

    /// Number of lines; a text that ends with a line break has an empty last one.
    pub fn count(&self) -> u32 {
        self.starts.len() as u32
    }

    /// Offset of the first byte of a 1-based line.
    pub fn start(&self, line: u32) -> Option<u32> {
        self.starts.get((line as usize).checked_sub(1)?).copied()
    }

    /// The 1-based line that holds `offset`.
    pub fn line(&self, offset: u32) -> u32 {
        self.starts.partition_point(|&s| s <= offset) as u32
    }

    /// Offsets of the first byte of the line that holds `offset`, and of the first behind it: of
    /// the next line, or `length` of the whole text.
    pub fn bounds(&self, offset: u32, length: u32) -> (u32, u32) {
        let line = self.line(offset);
        let start = self.start(line).unwrap_or(0);
        (start, self.start(line + 1).unwrap_or(length))
    }

    /// Line and columns of `offset` in the text that the index was made from. An offset inside a
    /// character counts as the place before it.
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

    /// The last character of more than one byte that starts before an offset.
    fn wide_before(&self, offset: usize) -> Wide {
        let behind = self.wide.partition_point(|w| (w.at as usize) < offset);
        let last = behind.checked_sub(1).and_then(|i| self.wide.get(i));
        last.copied().unwrap_or_default()
    }
}

/// Stretch of a text that is passed by at once where it is ASCII.
const CHUNK: usize = 64;

/// Finds the characters of more than one byte.
fn wide(text: &str) -> Vec<Wide> {
    let mut last = Wide::default();
    let mut found = Vec::new();
    for (start, chunk) in (0..).step_by(CHUNK).zip(text.as_bytes().chunks(CHUNK)) {
        if chunk.is_ascii() {
            continue;
        }
        for (at, byte) in (start..).zip(chunk) {
            // The first byte of a character says how long it is (RFC 3629).
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
