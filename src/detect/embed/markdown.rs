//! Shaders in fenced code blocks of Markdown.

use super::DocumentLanguage;
use super::changes;
use super::embedded::{Embedded, NamedStage, NoModules, Wrapping, left_out};
use super::{component, holes, html, kdl, script};
use crate::kind::{Evidence, sections};
use pulldown_cmark::{CodeBlockKind, Event, HeadingLevel, Parser, Tag, TagEnd};
use std::borrow::Cow;
use std::ops::Range;

/// Number of bytes at the start of a line that may open quotations and lists.
const MAX_NESTING: usize = 100;

/// Finds the shaders in a file of this name.
pub fn extract(name: &str, text: &str, found: &mut Vec<Embedded>) {
    let mut chapter = 0;
    let mut open: Option<MarkdownFence> = None;
    let is_mdx = name.to_ascii_lowercase().ends_with(".mdx");
    let structure = structure(text, is_mdx);
    for (event, range) in Parser::new(&structure).into_offset_iter() {
        match event {
            Event::Start(Tag::Heading { level, .. }) => {
                chapter += u32::from(level <= HeadingLevel::H2);
            }
            Event::Start(Tag::CodeBlock(CodeBlockKind::Fenced(info))) => {
                open = Some(MarkdownFence {
                    label: label(&info),
                    lines: Vec::new(),
                    chapter,
                });
            }
            Event::Text(_) => open.iter_mut().for_each(|f| f.lines.push(range.clone())),
            Event::End(TagEnd::CodeBlock) => {
                if let Some(fence) = open.take() {
                    take(text, &fence, found);
                }
            }
            _ => {}
        }
    }
}

/// The text for the parser, with the same length.
///
/// The elements of MDX are no blocks of HTML: there may be fences in them. And the parser looks at all
/// lists around each line, so that a line with thousands of them would cost as much in all lines after it.
fn structure(text: &str, is_mdx: bool) -> Cow<'_, str> {
    let is_start = |c: char| {
        matches!(
            c,
            ' ' | '\t' | '>' | '-' | '+' | '*' | '.' | ')' | '0'..='9'
        )
    };
    let is_nested = |line: &str| line.find(|c| !is_start(c)).unwrap_or(line.len()) > MAX_NESTING;
    if !is_mdx && !text.lines().any(is_nested) {
        return Cow::Borrowed(text);
    }
    let mut changed = String::with_capacity(text.len());
    for line in text.split_inclusive('\n') {
        let start = line.find(|c| !is_start(c)).unwrap_or(line.len());
        let mut chars = line.char_indices().peekable();
        while let Some((at, c)) = chars.next() {
            let ends = chars.peek().is_none_or(|(_, next)| next.is_whitespace());
            let opens = c == '>' || ends && matches!(c, '-' | '+' | '*' | '.' | ')');
            let is_deep = (MAX_NESTING..start).contains(&at) && opens;
            let is_markup = is_mdx && c == '<';
            changed.push(if is_deep || is_markup { 'x' } else { c });
        }
    }
    Cow::Owned(changed)
}

/// A fenced code block.
struct MarkdownFence {
    label: String,
    /// Where its text is: without the marks of quotations and the indentation of lists.
    lines: Vec<Range<usize>>,
    chapter: u32,
}

/// The text of a fence.
struct FenceText {
    /// Offset of its first line in the file.
    start: usize,
    /// Its lines with the length that they have in the file: what does not belong to them is blank.
    code: String,
    /// Its lines as they are shown.
    shown: String,
}

impl MarkdownFence {
    fn read(&self, text: &str) -> Option<FenceText> {
        let first = self.lines.first()?.start;
        let start = text.get(..first)?.rfind('\n').map_or(0, |at| at + 1);
        let (mut code, mut shown) = (String::new(), String::new());
        let mut at = start;
        for line in &self.lines {
            let before = text.get(at..line.start)?;
            code.extend(before.bytes().map(|b| match b {
                b'\n' | b'\r' | b'\t' => char::from(b),
                _ => ' ',
            }));
            let own = text.get(line.clone())?;
            code.push_str(own);
            shown.push_str(own);
            at = line.end;
        }
        Some(FenceText { start, code, shown })
    }
}

/// The language that the first line of a fence names.
fn label(info: &str) -> String {
    let is_between = |c: char| c.is_whitespace() || matches!(c, ',' | '{' | '}' | ':');
    let mut words = info.split(is_between).filter(|word| !word.is_empty());
    let word = words.next().unwrap_or("");
    word.trim_start_matches('.').to_ascii_lowercase()
}

fn take(text: &str, fence: &MarkdownFence, found: &mut Vec<Embedded>) {
    let label = fence.label.as_str();
    let language = language_of(label);
    let is_named = matches!(
        label,
        "glsl" | "frag" | "vert" | "fragment" | "vertex" | "webgl" | "shadertoy"
    );
    let is_any = matches!(label, "" | "c" | "cpp" | "c++" | "shader" | "text" | "diff");
    if language.is_none() && !is_named && !is_any {
        return;
    }
    let Some(FenceText { start, code, shown }) = fence.read(text) else {
        return;
    };
    let changed = changes::renewed(&shown, &code, label == "diff");
    let content = changed.unwrap_or(code);
    let content = content.as_str();
    if let Some(language) = language {
        return match language {
            DocumentLanguage::Html => html::extract(content, start, &NoModules, found),
            DocumentLanguage::Script => script::extract(content, start, false, &NoModules, found),
            DocumentLanguage::Component => component::extract(content, start, &NoModules, found),
            DocumentLanguage::Kdl => kdl::extract(content, start, found),
            // A document that shows how to write documents.
            DocumentLanguage::Markdown | DocumentLanguage::Sections => {}
        };
    }
    let is_glsl = is_named || Evidence::of(content).is_glsl();
    if !is_glsl || content.trim().is_empty() {
        return;
    }
    // A GLSL fence that shows a web page.
    if content.trim_start().starts_with('<') {
        return html::extract(content, start, &NoModules, found);
    }
    // A GLSL fence that shows a script.
    if content.contains("= `") || content.contains("glsl`") {
        let count = found.len();
        script::extract(content, start, false, &NoModules, found);
        if found.len() > count {
            return;
        }
    }
    let parts = sections(content);
    if !parts.is_empty() {
        return found.extend(parts.into_iter().map(|part| Embedded {
            start: start + part.start,
            wrapping: Wrapping::Fence,
            chapter: fence.chapter,
            ..Embedded::from(part)
        }));
    }
    let code = mask(content);
    let masked = holes::mask(&code);
    found.push(Embedded {
        has_holes: masked.is_some(),
        stage: NamedStage::of([Some(label)]),
        chapter: fence.chapter,
        ..Embedded::new(start, masked.unwrap_or(code), Wrapping::Fence)
    });
}

fn language_of(label: &str) -> Option<DocumentLanguage> {
    match label {
        "javascript" | "typescript" => Some(DocumentLanguage::Script),
        _ => DocumentLanguage::of_extension(label),
    }
}

/// Replaces `...` with blanks.
fn mask(content: &str) -> String {
    let mut code = String::with_capacity(content.len());
    let mut rest = content;
    while let Some(at) = rest.find(['.', '\u{2026}']) {
        let (before, after) = rest.split_at_checked(at).unwrap_or((rest, ""));
        code.push_str(before);
        let is_left_out = after.starts_with("...") || after.starts_with('\u{2026}');
        let length = if is_left_out { 3 } else { 1 };
        let (dots, more) = after.split_at_checked(length).unwrap_or((after, ""));
        let shown = if is_left_out { left_out(&code) } else { dots };
        code.push_str(shown);
        rest = more;
    }
    code.push_str(rest);
    code
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(name: &str, text: &str) -> Vec<Embedded> {
        let mut found = Vec::new();
        extract(name, text, &mut found);
        for shader in &found {
            let original = text.get(shader.start..shader.end()).unwrap();
            let breaks = |text: &str| text.bytes().map(|b| b == b'\n').collect::<Vec<_>>();
            assert_eq!(breaks(original), breaks(&shader.code), "{text}");
        }
        found
    }

    /// The codes of a text, each with the number of its chapter.
    fn codes(name: &str, text: &str) -> String {
        let found = read(name, text).into_iter();
        let shown = found.map(|shader| match shader.chapter {
            0 => shader.code,
            chapter => format!("{chapter} {}", shader.code),
        });
        shown.collect::<Vec<_>>().join(" | ")
    }

    #[test]
    fn fences_are_read_as_markdown_shows_them() {
        let visible = |text: &str| {
            text.replace('\n', "↵")
                .replace('\t', "⇥")
                .replace('\r', "␍")
        };
        let cases = include_str!("markdown.txt").lines();
        for case in cases.filter(|case| !case.starts_with("# ")) {
            let (text, expected) = case.split_once(" ⇒ ").unwrap();
            let (name, text) = match text.strip_prefix("mdx ") {
                Some(text) => ("a.mdx", text),
                None => ("a.md", text),
            };
            let text = text
                .replace('↵', "\n")
                .replace('⇥', "\t")
                .replace('␍', "\r");
            let shown = visible(&codes(name, &text));
            assert_eq!(shown, expected.trim_start_matches("none"), "{case}");
        }
    }

    #[test]
    fn template_expressions_in_fences_are_holes() {
        let found = read("", "```glsl\nfloat a = {{ b }};\n```\n");
        assert!(found[0].has_holes && found[0].code == "float a = hhhhhhh;\n");
    }

    #[test]
    fn deep_nesting_is_read_as_text() {
        let line = "- > 1. ".repeat(1000);
        let read = structure(&line, false);
        assert_eq!(read.len(), line.len());
        assert!(read.find('x').is_some_and(|at| (100..110).contains(&at)));
        assert!(!read[110..].contains(['-', '>', '.']));
        // A rule of many dashes is none.
        let rule = format!("{}\n", "-".repeat(1000));
        assert!(structure(&rule, false).matches('x').count() <= 1);
    }
}
