//! A shader embedded in a file, and which edits are safe.

use super::receiver::ShaderReceiver;
use crate::kind::Section;
use shaderlint_text::{Edit, Span};
use std::ops::Range;
use std::sync::Arc;

/// A stage that names around a shader show.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum NamedStage {
    /// The vertex stage.
    Vertex,
    /// The fragment stage.
    Fragment,
}

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
    /// The texts that the script inserts into the code, in order.
    pub inserted: Vec<InsertedPart>,
    /// Whether it is only a part of other shaders of the file, which insert it.
    pub is_part: bool,
    /// The stage that the context names.
    pub stage: Option<NamedStage>,
    /// What the script hands it to; empty if it goes elsewhere, or is changed first.
    pub receivers: Vec<ShaderReceiver>,
    /// Number of its chapter; excerpts of a chapter continue each other.
    pub chapter: u32,
    /// The name of a chunk of a library; empty for a text that only imports some.
    pub chunk: Option<String>,
}

impl From<Section> for Embedded {
    fn from(section: Section) -> Embedded {
        Embedded {
            has_holes: section.is_open,
            stage: section.is_vertex.then_some(NamedStage::Vertex),
            chunk: section.chunk,
            ..Embedded::new(section.start, section.code, Wrapping::Element)
        }
    }
}

impl Embedded {
    /// A text that is complete as it is.
    pub(super) fn new(start: usize, code: String, wrapping: Wrapping) -> Embedded {
        Embedded {
            start,
            code,
            wrapping,
            has_holes: false,
            inserted: Vec::new(),
            is_part: false,
            stage: None,
            receivers: Vec::new(),
            chapter: 0,
            chunk: None,
        }
    }

    /// Offset after its last byte.
    pub fn end(&self) -> usize {
        self.start + self.code.len()
    }

    /// Whether a byte of its file belongs to it or to what is inserted into it.
    pub fn holds(&self, at: usize) -> bool {
        (self.start..self.end()).contains(&at) || hold(&self.inserted, at)
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
            Wrapping::Fence => {
                let is_line_added = text.contains(['\n', '\r']);
                !(text.contains("```") || is_line_added && self.is_prefixed(outer))
            }
            Wrapping::Listing => !text.contains(['<', '&']),
        };
        fits && self.is_verbatim(outer, edit.span)
    }

    /// Whether something precedes each line of its fence: the marks of a quotation, or the indentation
    /// of a list.
    fn is_prefixed(&self, outer: &str) -> bool {
        let before = outer.get(..self.start).and_then(|text| text.lines().last());
        before.is_some_and(|fence| !fence.starts_with(['`', '~']))
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
        let first = self
            .inserted
            .first()
            .map_or(usize::MAX, |part| part.at.start);
        let blanks = self.code.len() - self.code.trim_start().len();
        self.cut(blanks.min(first));
    }

    /// Removes the first bytes.
    pub(super) fn cut(&mut self, count: usize) {
        self.code.drain(..count.min(self.code.len()));
        self.start += count;
        for part in &mut self.inserted {
            part.at = part.at.start.saturating_sub(count)..part.at.end.saturating_sub(count);
        }
    }

    /// Moves it by the offset of its script.
    pub(super) fn shift(&mut self, base: usize) {
        self.start += base;
        shift(&mut self.inserted, base);
    }
}

/// A text that a script inserts into a shader.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct InsertedPart {
    /// The range in the code around it that it replaces; that is blank.
    pub at: Range<usize>,
    /// Start offset in its file; `None` if no file contains it.
    pub start: Option<usize>,
    /// The code; of the same length as in the file.
    pub code: String,
    /// The file that contains it, if it is another one.
    pub module: Option<ModuleFile>,
    /// The texts that are inserted into it.
    pub inserted: Vec<InsertedPart>,
    /// Whether unknown parts are inserted.
    pub has_holes: bool,
    /// Whether it is one of several alternatives.
    pub is_choice: bool,
}

/// A file that contains a text.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct ModuleFile {
    /// Its path.
    pub path: Arc<str>,
    /// Its complete text.
    pub text: Arc<str>,
}

impl InsertedPart {
    /// A text that no file contains.
    pub fn known(code: String) -> InsertedPart {
        InsertedPart {
            at: 0..0,
            start: None,
            code,
            module: None,
            inserted: Vec::new(),
            has_holes: false,
            is_choice: false,
        }
    }

    /// The text of a file.
    pub fn whole(text: &str) -> InsertedPart {
        // Tools include other files in it.
        let completes = |line: &str| {
            let directive = line.trim_start().strip_prefix('#').map(str::trim_start);
            let all = ["include", "import", "pragma"];
            directive.is_some_and(|d| all.iter().any(|word| d.starts_with(word)))
        };
        let is_completed = text.lines().any(completes);
        InsertedPart {
            start: Some(0),
            has_holes: is_completed,
            ..InsertedPart::known(text.to_string())
        }
    }

    /// Says which file contains it, unless that is known.
    pub fn is_of(&mut self, file: &ModuleFile) {
        if self.start.is_some() && self.module.is_none() {
            self.module = Some(file.clone());
        }
        self.inserted.iter_mut().for_each(|part| part.is_of(file));
    }

    /// Several texts, one after the other.
    pub(super) fn several(all: Vec<InsertedPart>) -> InsertedPart {
        let mut joined = InsertedPart::known(String::new());
        joined.has_holes = all.iter().any(|one| one.has_holes);
        joined.is_choice = all.iter().any(|one| one.is_choice);
        joined.inserted = all;
        joined
    }

    /// Several texts, each in lines of its own, perhaps with a line break at the end or at the start.
    pub(super) fn lines(all: Vec<InsertedPart>, ends: bool, starts: bool) -> InsertedPart {
        let line = || InsertedPart::known("\n".to_string());
        let count = all.len();
        let mut parts = Vec::new();
        for (index, part) in all.into_iter().enumerate() {
            if index > 0 || starts {
                parts.push(line());
            }
            parts.push(part);
            if ends && index + 1 == count {
                parts.push(line());
            }
        }
        InsertedPart::several(parts)
    }

    /// The first and the last byte of the whole text, if it has any.
    pub(super) fn ends(&self) -> Option<(u8, u8)> {
        let text = self.joined();
        Some((text.bytes().next()?, text.bytes().next_back()?))
    }

    /// The text, if it may replace an expression in its place.
    pub(super) fn short(&self) -> Option<&str> {
        let is_short =
            self.inserted.is_empty() && !self.has_holes && !self.code.contains(['\n', '\r', '\\']);
        is_short.then_some(self.code.as_str())
    }

    /// Length in bytes, with what is inserted.
    pub(super) fn length(&self) -> usize {
        let inner = self
            .inserted
            .iter()
            .map(InsertedPart::length)
            .sum::<usize>();
        self.code.len() + inner
    }

    /// The whole text.
    pub fn joined(&self) -> String {
        joined(&self.code, &self.inserted)
    }
}

/// Moves texts of a script by its offset.
fn shift(inserted: &mut [InsertedPart], base: usize) {
    for part in inserted.iter_mut().filter(|part| part.module.is_none()) {
        part.start = part.start.map(|start| start + base);
        shift(&mut part.inserted, base);
    }
}

/// Whether a byte of the file belongs to one of the texts.
fn hold(inserted: &[InsertedPart], at: usize) -> bool {
    let own = inserted.iter().filter(|part| part.module.is_none());
    own.clone().any(|part| {
        let is_in = |start| (start..start + part.code.len()).contains(&at);
        part.start.is_some_and(is_in) || hold(&part.inserted, at)
    })
}

/// Code with what is inserted into it.
pub fn joined(code: &str, inserted: &[InsertedPart]) -> String {
    let mut text = String::new();
    let mut from = 0;
    for part in inserted {
        text.push_str(code.get(from..part.at.start).unwrap_or(""));
        text.push_str(&part.joined());
        from = part.at.end;
    }
    text.push_str(code.get(from..).unwrap_or(""));
    text
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

/// Reads the modules that a script imports.
pub trait ImportedTexts {
    /// The text that a module exports under a name; `default` is the default export, and the whole text
    /// of a file that is no script.
    fn text(&self, path: &str, name: &str) -> Option<InsertedPart>;
}

/// No module can be read.
pub struct NoModules;

impl ImportedTexts for NoModules {
    fn text(&self, _: &str, _: &str) -> Option<InsertedPart> {
        None
    }
}
