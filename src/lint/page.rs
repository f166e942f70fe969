//! A page of a rule or a compile error: what it says, and its examples.
//!
//! A page starts with `# name`; its first paragraph is the summary that stands everywhere. Its code
//! fences are tests: `glsl bad` is reported, the `text` behind it is exactly what is printed,
//! `glsl fixed` is exactly what `--fix` makes of it (`glsl suggested`: what `--unsafe-fixes` makes),
//! and `glsl good` stays silent. A word behind these is the name of the file that the example stands
//! for; its ending tells the stage. `html bad` and `html good` are pages that hold several shaders.

use std::ops::Range;

/// Name of an example's file where the fence gives none.
const FILE: &str = "example.glsl";

/// A page, read.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Page<'a> {
    /// Name of the rule.
    pub name: &'a str,
    /// The first paragraph, in one line.
    pub summary: String,
    /// The fences, in order.
    pub fences: Vec<Fence<'a>>,
}

/// A code fence of a page.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Fence<'a> {
    /// What it shows.
    pub kind: FenceKind,
    /// Name of the file that it stands for.
    pub file: &'a str,
    /// Where its content stands in the page.
    pub range: Range<usize>,
}

/// What a fence shows.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum FenceKind {
    /// Code that is reported.
    Bad,
    /// What is printed of the code before.
    Text,
    /// What the safe fixes make of the code before.
    Fixed,
    /// What all fixes make of the code before.
    Suggested,
    /// Code that is not reported.
    Good,
    /// Anything else.
    Other,
}

impl<'a> Page<'a> {
    /// Reads a page.
    pub fn new(text: &'a str) -> Page<'a> {
        let mut lines = text.lines();
        let title = lines.next().unwrap_or("");
        let paragraph = lines.skip_while(|l| l.trim().is_empty());
        let paragraph = paragraph.take_while(|l| !l.trim().is_empty());
        Page {
            name: title.trim_start_matches('#').trim(),
            summary: paragraph.map(str::trim).collect::<Vec<_>>().join(" "),
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
    fn a_page_is_read() {
        let text = "# a-name\n\nOne\nparagraph.\n\nMore.\n\n```glsl bad x.vert\nfoo\n```\n```text\nbar\n```\n";
        let page = Page::new(text);
        assert_eq!(
            (page.name, page.summary.as_str()),
            ("a-name", "One paragraph.")
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
