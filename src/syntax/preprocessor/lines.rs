//! Line numbers as the compiler counts them, across all files and changed by `#line`.

use shaderlint_text::Sources;

/// Line counter. It computes nothing until `__LINE__` is used, which is rare.
#[derive(Default)]
pub(super) struct LineCount {
    /// The texts since the start or the last `#line`; the last one is current.
    texts: Vec<CountedText>,
    /// Offset of the compiler's line number from the line in the file, for the first of these
    /// texts, as set by `#line`; without one, the first compiled line is 1.
    shift: Option<i64>,
    /// Number of the current source string: 0, or the value from `#line`.
    pub(super) file: i32,
}

/// A text that contributes to the line count.
#[derive(Clone, Copy)]
struct CountedText {
    start: u32,
    end: u32,
    /// Whether a line break separates it from the next text, as after each Common pass.
    is_ended: bool,
}

impl LineCount {
    /// Adds the next text, given by its address range.
    pub(super) fn go_on(&mut self, start: u32, end: u32, is_ended: bool) {
        self.texts.push(CountedText {
            start,
            end,
            is_ended,
        });
    }

    /// `#line` sets the number of a line in the current text, and optionally the source string
    /// number.
    pub(super) fn set(&mut self, sources: &Sources, address: u32, number: i64, file: Option<i32>) {
        self.file = file.unwrap_or(self.file);
        self.shift = Some(number - own_line(sources, address));
        let before = self.texts.len().saturating_sub(1);
        self.texts.drain(..before);
    }

    /// Line number of an address in the current text.
    pub(super) fn at(&self, sources: &Sources, address: u32) -> i64 {
        let first = self.texts.first().map_or(0, |text| text.start);
        let mut shift = self.shift.unwrap_or_else(|| 1 - own_line(sources, first));
        for pair in self.texts.windows(2) {
            if let [text, next] = pair {
                let end = own_line(sources, text.end) + shift + i64::from(text.is_ended);
                shift = end - own_line(sources, next.start);
            }
        }
        own_line(sources, address) + shift
    }
}

/// Line of an address within its own file.
fn own_line(sources: &Sources, address: u32) -> i64 {
    let file = sources.file_at(address);
    file.map_or(0, |f| f.position(address).line as i64)
}
