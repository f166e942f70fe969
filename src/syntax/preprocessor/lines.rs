//! The compiler's number of a line, which goes on through all texts; `#line` sets it.

use shaderlint_text::Sources;

/// The count of lines. Nothing is counted before `__LINE__` asks, which few shaders do.
#[derive(Default)]
pub(super) struct LineCount {
    /// The texts since the start or the last `#line`, of which the last is being read.
    texts: Vec<CountedText>,
    /// How far the compiler's count is ahead of the file's own in the first of them, as `#line` says;
    /// without one the first line that is compiled is 1.
    shift: Option<i64>,
    /// The number of the text that is being read: 0, or what `#line` says.
    file: i32,
}

/// A text whose lines count.
#[derive(Clone, Copy)]
struct CountedText {
    start: u32,
    end: u32,
    /// Whether a line break comes between it and the next, as behind each Common.
    is_ended: bool,
}

impl LineCount {
    /// A text comes next, from one address to another.
    pub(super) fn go_on(&mut self, start: u32, end: u32, is_ended: bool) {
        self.texts.push(CountedText {
            start,
            end,
            is_ended,
        });
    }

    /// `#line` gives a line of the text that is being read another number, and maybe the text itself.
    pub(super) fn set(&mut self, sources: &Sources, address: u32, number: i64, file: Option<i32>) {
        self.file = file.unwrap_or(self.file);
        self.shift = Some(number - own_line(sources, address));
        let before = self.texts.len().saturating_sub(1);
        self.texts.drain(..before);
    }

    /// The number of the text that is being read.
    pub(super) fn file(&self) -> i32 {
        self.file
    }

    /// The number of the line of an address in the text that is being read.
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

/// The line of an address in its file.
fn own_line(sources: &Sources, address: u32) -> i64 {
    let file = sources.file_at(address);
    file.map_or(0, |f| f.position(address).line as i64)
}
