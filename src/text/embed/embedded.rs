//! A shader inside a file, and what may be written into it.

use crate::{Edit, Span};

/// A shader inside a file.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Embedded {
    /// Offset of its first byte.
    pub start: usize,
    /// What the compiler reads, as long as what it stands for.
    pub code: String,
    /// What stands around it.
    pub wrapping: Wrapping,
    /// Whether parts of the shader are put in when the program runs.
    pub has_holes: bool,
    /// Whether the text around says that it is a vertex shader.
    pub is_vertex: bool,
    /// Number of the chapter that it stands in; excerpts of one chapter go on from each other.
    pub chapter: u32,
}

impl Embedded {
    /// One past its last byte.
    pub fn end(&self) -> usize {
        self.start + self.code.len()
    }

    /// Whether an edit, whose span counts from the start of `outer`, leaves the outer language
    /// intact: what it takes away is GLSL as it stands, and what it puts in means the same there.
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
            Wrapping::Fence => !text.contains("```"),
            Wrapping::Listing => !text.contains(['<', '&']),
        };
        fits && self.is_verbatim(outer, edit.span)
    }

    /// Whether a stretch, counted from the start of `outer`, is GLSL as it stands there: nothing in it
    /// is put in by a program.
    pub fn is_verbatim(&self, outer: &str, span: Span) -> bool {
        let (from, to) = (span.start as usize, span.end as usize);
        let Some(inside) = from.checked_sub(self.start) else {
            return false;
        };
        let read = self.code.get(inside..inside + to.saturating_sub(from));
        read.is_some() && read == outer.get(from..to)
    }

    /// Takes `...` for something that is left out.
    pub(super) fn leave_out(&mut self) {
        if !self.code.contains("...") {
            return;
        }
        let mut at = 0;
        while let Some(rest) = self.code.get(at..).filter(|r| !r.is_empty()) {
            let length = if rest.starts_with("//") {
                rest.find('\n').unwrap_or(rest.len())
            } else if let Some(behind) = rest.strip_prefix("/*") {
                behind.find("*/").map_or(rest.len(), |end| end + 4)
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

    /// Leaves out the blanks in front, as the program does before it hands the shader over.
    pub fn trim_start(&mut self) {
        let blanks = self.code.len() - self.code.trim_start().len();
        self.code.drain(..blanks);
        self.start += blanks;
    }
}

/// What stands around a shader, which decides what may be written into it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Wrapping {
    /// An element of a page.
    Element,
    /// A template literal.
    Template,
    /// A string in quotes, or several put together.
    Quotes,
    /// A fence of a Markdown text.
    Fence,
    /// An element of a page that shows code.
    Listing,
}

/// What stands for `...` behind a text: a value behind an operator, nothing between statements.
pub(super) fn left_out(before: &str) -> &'static str {
    /// How far is looked back, in bytes.
    const NEAR: usize = 64;
    let mut near = before.bytes().rev().take(NEAR);
    let last = near.find(|b| !b.is_ascii_whitespace());
    match last.is_some_and(|b| b"=(,+-*<>?:&|!".contains(&b)) {
        true => "hhh",
        false => "   ",
    }
}
