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
#[derive(Debug)]
pub struct LineIndex {
    starts: Vec<u32>,
    /// Whether every character is one byte, so that columns need no counting.
    is_ascii: bool,
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
            is_ascii: text.is_ascii(),
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

    /// Line and columns of `offset` in the text that the index was made from. An offset inside a
    /// character counts as the place before it.
    pub fn position(&self, text: &str, offset: u32) -> Position {
        let line = self.line(offset);
        let start = self.start(line).unwrap_or(0) as usize;
        let mut end = (offset as usize).min(text.len());
        while !text.is_char_boundary(end) {
            end -= 1;
        }
        let before = text.as_bytes().get(start..end).unwrap_or(&[]);
        if self.is_ascii {
            let column = before.len() as u32 + 1;
            return Position {
                line,
                column,
                utf16: column,
                byte: offset,
            };
        }
        // Every byte but a continuation starts a character; those of four bytes take two units.
        let characters = before.iter().filter(|&&b| b & 0xc0 != 0x80).count() as u32;
        let pairs = before.iter().filter(|&&b| b >= 0xf0).count() as u32;
        Position {
            line,
            column: characters + 1,
            utf16: characters + pairs + 1,
            byte: offset,
        }
    }
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
    }
}
