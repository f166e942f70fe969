//! A page of a rule or a compile error: what it says, and its examples.
//!
//! A page starts with `# name` and a generated head, a line of bold words. The next paragraph is the
//! summary, which is also used in tables and hovers. Code fences are tests: `glsl bad` is reported, the
//! `text` after it is exactly what is printed, `glsl fixed` is exactly what `--fix` writes
//! (`glsl suggested`: what `--unsafe-fixes` writes), and `glsl good` has no findings. A word after these
//! is the file name of the example; its extension decides the stage. `html bad` and `html good` are
//! pages that hold several shaders.

use std::ops::Range;

/// Name of an example's file where the fence gives none.
const FILE: &str = "example.glsl";

/// A parsed page.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Page<'a> {
    /// Name of the rule or compile error.
    pub name: &'a str,
    /// The line between title and summary; empty where a new page has none yet.
    pub head: &'a str,
    /// The first paragraph after the head, in one line.
    pub summary: String,
    /// The fences, in order.
    pub fences: Vec<Fence<'a>>,
}

/// A code fence of a page.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Fence<'a> {
    /// What the content is tested for.
    pub kind: FenceKind,
    /// File name under which the content is checked.
    pub file: &'a str,
    /// Byte range of the content in the page.
    pub range: Range<usize>,
}

/// What a fence shows.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum FenceKind {
    /// Code that is reported.
    Bad,
    /// The findings printed for the code before.
    Text,
    /// The code before after its safe fixes.
    Fixed,
    /// The code before after all its fixes.
    Suggested,
    /// Code that is not reported.
    Good,
    /// Anything else.
    Other,
}

impl<'a> Page<'a> {
    /// Parses the text of a page.
    pub fn new(text: &'a str) -> Page<'a> {
        let mut paragraphs = text.split("\n\n").map(str::trim).filter(|p| !p.is_empty());
        let title = paragraphs.next().unwrap_or("");
        let mut summary = paragraphs.next().unwrap_or("");
        let mut head = "";
        if summary.starts_with("**") {
            head = summary;
            summary = paragraphs.next().unwrap_or("");
        }
        Page {
            name: title.trim_start_matches('#').trim(),
            head,
            summary: summary.lines().map(str::trim).collect::<Vec<_>>().join(" "),
            fences: fences(text),
        }
    }
}

fn fences(text: &str) -> Vec<Fence<'_>> {
    let mut found = Vec::new();
    let mut open: Option<Fence> = None;
    let mut at = 0;
    for line in text.split_inclusive('\n') {
        let start = at;
        at += line.len();
        let Some(info) = line.strip_prefix("```") else {
            continue;
        };
        match open.take() {
            Some(mut fence) => {
                fence.range.end = start;
                found.push(fence);
            }
            None => {
                let mut words = info.split_whitespace();
                let kind = match (words.next(), words.next()) {
                    (Some("glsl" | "html"), Some("bad")) => FenceKind::Bad,
                    (Some("glsl"), Some("fixed")) => FenceKind::Fixed,
                    (Some("glsl"), Some("suggested")) => FenceKind::Suggested,
                    (Some("glsl" | "html"), Some("good")) => FenceKind::Good,
                    (Some("text"), None) => FenceKind::Text,
                    _ => FenceKind::Other,
                };
                open = Some(Fence {
                    kind,
                    file: words.next().unwrap_or(FILE),
                    range: at..at,
                });
            }
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_parts_of_a_page_are_read() {
        let text = "# a-name\n\n**Group:** x\n\nOne\nparagraph.\n\nMore.\n\n```glsl bad x.vert\nfoo\n```\n```text\nbar\n```\n";
        let page = Page::new(text);
        assert_eq!(
            (page.name, page.head, page.summary.as_str()),
            ("a-name", "**Group:** x", "One paragraph.")
        );
        let contents: Vec<_> = page
            .fences
            .iter()
            .map(|f| (f.kind, f.file, &text[f.range.clone()]))
            .collect();
        assert_eq!(
            contents,
            [
                (FenceKind::Bad, "x.vert", "foo\n"),
                (FenceKind::Text, FILE, "bar\n")
            ]
        );
    }
}
