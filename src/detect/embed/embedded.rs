//! A shader embedded in a file, and which edits are safe.

use shaderlint_text::{Edit, Span};

/// A shader embedded in a file.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Embedded {
    /// Offset of its first byte in the file.
    pub start: usize,
    /// The code to compile, of the same length as in the file.
    pub code: String,
    /// The construct that contains it.
    pub wrapping: Wrapping,
    /// Whether parts of the shader are inserted at run time.
    pub has_holes: bool,
    /// Whether the context says that it is a vertex shader.
    pub is_vertex: bool,
    /// Number of its chapter; excerpts of a chapter continue each other.
    pub chapter: u32,
}

impl Embedded {
    /// Offset after its last byte.
    pub fn end(&self) -> usize {
        self.start + self.code.len()
    }

    /// Whether an edit, relative to the start of `outer`, keeps the outer language intact: the
    /// replaced text is literal GLSL, and the replacement means the same there.
    pub fn admits(&self, outer: &str, edit: &Edit) -> bool {
        let (from, to) = (edit.span.start as usize, edit.span.end as usize);
        if from < self.start || to > self.end() {
            return false;
        }
        let text = edit.text.as_str();
        let fits = match self.wrapping {
            Wrapping::Element => !text.contains("</"),
            Wrapping::Template => !text.contains(['`', '\\', '$']),
            Wrapping::Quotes => !text.contains(['"', '\'', '\\', '\n', '\r']),
            Wrapping::Raw => !text.contains('"'),
            Wrapping::Fence => !text.contains("```"),
            Wrapping::Listing => !text.contains(['<', '&']),
        };
        fits && self.is_verbatim(outer, edit.span)
    }

    /// Whether a span, relative to the start of `outer`, is literal GLSL without interpolation.
    pub fn is_verbatim(&self, outer: &str, span: Span) -> bool {
        let (from, to) = (span.start as usize, span.end as usize);
        let Some(inside) = from.checked_sub(self.start) else {
            return false;
        };
        let read = self.code.get(inside..inside + to.saturating_sub(from));
        read.is_some() && read == outer.get(from..to)
    }

    /// Replaces `...` that marks an omission.
    pub(super) fn leave_out(&mut self) {
        if !self.code.contains("...") {
            return;
        }
        let mut at = 0;
        while let Some(rest) = self.code.get(at..).filter(|r| !r.is_empty()) {
            let length = if rest.starts_with("//") {
                rest.find('\n').unwrap_or(rest.len())
            } else if let Some(after) = rest.strip_prefix("/*") {
                after.find("*/").map_or(rest.len(), |end| end + 4)
            } else if rest.starts_with("...") {
                let before = self.code.get(..at).unwrap_or("");
                let dots = left_out(before);
                self.code.replace_range(at..at + 3, dots);
                self.has_holes = true;
                3
            } else {
                rest.chars().next().map_or(1, char::len_utf8)
            };
            at += length;
        }
    }

    /// Removes leading white space, as the program does before it compiles the shader.
    pub fn trim_start(&mut self) {
        let blanks = self.code.len() - self.code.trim_start().len();
        self.code.drain(..blanks);
        self.start += blanks;
    }
}

/// The construct that contains a shader, which limits safe edits.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Wrapping {
    /// An element of a web page.
    Element,
    /// A template literal.
    Template,
    /// A string literal, or several that are concatenated.
    Quotes,
    /// A string literal with line breaks and without escape sequences.
    Raw,
    /// A fenced code block of Markdown.
    Fence,
    /// An element of a web page that shows code.
    Listing,
}

/// The replacement of `...`: a value after an operator, nothing between statements.
pub(super) fn left_out(before: &str) -> &'static str {
    /// Maximum distance in bytes.
    const NEAR: usize = 64;
    let mut near = before.bytes().rev().take(NEAR);
    let last = near.find(|b| !b.is_ascii_whitespace());
    match last.is_some_and(|b| b"=(,+-*<>?:&|!".contains(&b)) {
        true => "hhh",
        false => "   ",
    }
}
