//! GLSL inside pages, scripts and texts.
//!
//! What is found is a stretch of the outer text and what the compiler reads in its place: just as
//! many bytes, with blanks where the outer language speaks. So every place in a shader is a place in
//! the file that holds it. Escapes of strings are read (`\n` is a line break), `${...}` becomes a
//! name that nothing declares.

mod chain;
mod component;
mod constants;
mod context;
mod holes;
mod html;
mod listing;
mod literal;
mod markdown;
mod script;
mod template;
mod together;
mod token;

pub use holes::mask;
pub use together::{Asked, asked, together};

use super::{Edit, Span};
use std::fmt;

/// The languages that GLSL is found in.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum DocumentLanguage {
    /// HTML: script elements, and literals in scripts.
    Html,
    /// JavaScript and TypeScript: literals.
    Script,
    /// Vue, Svelte and Astro: script elements, and literals in the text around them.
    Component,
    /// Markdown: fences.
    Markdown,
}

impl fmt::Display for DocumentLanguage {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            DocumentLanguage::Html => "HTML",
            DocumentLanguage::Script => "a script",
            DocumentLanguage::Component => "a component",
            DocumentLanguage::Markdown => "Markdown",
        })
    }
}

impl DocumentLanguage {
    /// The language of files with this ending.
    pub fn of_extension(extension: &str) -> Option<DocumentLanguage> {
        Some(match extension {
            "html" | "htm" | "xhtml" => DocumentLanguage::Html,
            "js" | "mjs" | "cjs" | "jsx" | "ts" | "mts" | "cts" | "tsx" => DocumentLanguage::Script,
            "vue" | "svelte" | "astro" => DocumentLanguage::Component,
            "md" | "markdown" | "mdx" => DocumentLanguage::Markdown,
            _ => return None,
        })
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
    fn leave_out(&mut self) {
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

/// What a file says of the shaders in it.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct Embedder {
    /// It asks for WebGL1, and nowhere for WebGL2.
    pub is_webgl1: bool,
    /// It hands shaders over to the browser itself, without a library.
    pub hands_over: bool,
    /// What it does with the blanks before a shader.
    pub front: Front,
}

/// What becomes of the blanks before a shader until the browser reads it.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub enum Front {
    /// Something else hands the shader over.
    #[default]
    Unknown,
    /// They are taken away.
    Trimmed,
    /// They stay.
    Kept,
}

impl Front {
    /// Reads what a page or script does.
    fn of(text: &str) -> Front {
        const TRIMS: [&str; 7] = [
            ".trim()",
            ".trimStart()",
            ".trimLeft()",
            ".replace(/^\\s",
            ".replace(/^[\\s",
            ".replace(/^\\n",
            ".replace(/^[\\n",
        ];
        if TRIMS.iter().any(|t| text.contains(t)) {
            Front::Trimmed
        } else if text.contains(HANDS_OVER) {
            Front::Kept
        } else {
            Front::Unknown
        }
    }
}

/// The call that hands a shader over to the browser.
const HANDS_OVER: &str = ".shaderSource(";

impl Embedder {
    /// Reads what a page or script says.
    pub fn of(text: &str) -> Embedder {
        let asks_for_webgl1 = || {
            text.match_indices("getContext(").any(|(at, call)| {
                let rest = text.get(at + call.len()..).unwrap_or("").trim_start();
                let word = rest.get(1..).unwrap_or("");
                word.starts_with("webgl") || word.starts_with("experimental-webgl")
            })
        };
        Embedder {
            is_webgl1: !text.contains("webgl2") && asks_for_webgl1(),
            hands_over: text.contains(HANDS_OVER),
            front: Front::of(text),
        }
    }
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

/// Finds the shaders in a file, in the order of the text.
pub fn extract(language: DocumentLanguage, text: &str) -> Vec<Embedded> {
    extract_named("", language, text)
}

/// Finds the shaders in a file of this name, which may speak of shaders itself.
pub fn extract_named(name: &str, language: DocumentLanguage, text: &str) -> Vec<Embedded> {
    let mut found = Vec::new();
    let words = [
        "void", "#version", "glsl", "GLSL", "shader", "```", "~~~", "uniform", "varying", "vec",
        "float",
    ];
    if !words.iter().any(|w| text.contains(w)) {
        return found;
    }
    match language {
        DocumentLanguage::Script => {
            script::extract(text, 0, context::is_file_of_shaders(name), &mut found);
        }
        _ => extract_into(language, text, 0, &mut found),
    }
    found.iter_mut().for_each(Embedded::leave_out);
    found
}

/// Finds the shaders in a part of a file that starts at `base`.
fn extract_into(language: DocumentLanguage, text: &str, base: usize, found: &mut Vec<Embedded>) {
    match language {
        DocumentLanguage::Html => html::extract(text, base, found),
        DocumentLanguage::Script => script::extract(text, base, false, found),
        DocumentLanguage::Component => component::extract(text, base, found),
        DocumentLanguage::Markdown => markdown::extract(text, base, found),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Span;

    #[test]
    fn edits_stay_inside_the_shader() {
        let text = "x = \"void main() {\\n}\";";
        let found = extract(DocumentLanguage::Script, text);
        let shader = &found[0];
        let at = |word: &str| text.find(word).unwrap() as u32;
        let edit = |from: u32, to: u32, with: &str| Edit::replace(Span::new(from, to), with);
        assert!(shader.admits(text, &edit(at("main"), at("()"), "foo")));
        assert!(!shader.admits(text, &edit(at("main"), at("()"), "\n")));
        assert!(!shader.admits(text, &edit(at("\\n"), at("\\n") + 2, "")));
        assert!(!shader.admits(text, &edit(0, 1, "y")));
    }

    #[test]
    fn a_host_says_what_it_is() {
        assert!(Embedder::of("c.getContext('webgl')").is_webgl1);
        assert!(!Embedder::of("c.getContext('webgl2') || c.getContext('webgl')").is_webgl1);
        assert!(!Embedder::of("c.getContext('2d')").is_webgl1);
    }
}
