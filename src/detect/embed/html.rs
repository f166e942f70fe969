//! Shaders in the elements of a web page.

use super::DocumentLanguage;
use super::embedded::{Embedded, ImportedTexts, NamedStage, Wrapping};
use super::embedder::{Embedder, LeadingBlanks};
use super::tag::{attribute, tag_length};
use super::{holes::mask, listing, script};
use crate::kind::Scanned;
use std::ops::Range;

/// Finds the shaders of a page.
pub fn extract(text: &str, base: usize, modules: &dyn ImportedTexts, found: &mut Vec<Embedded>) {
    let count = found.len();
    elements(text, base, modules, found);
    listing::extract(text, &text.to_ascii_lowercase(), base, found);
    if let Some(own) = found.get_mut(count..) {
        own.sort_by_key(|e| e.start);
    }
}

/// Finds the shaders in script elements.
pub fn elements(text: &str, base: usize, modules: &dyn ImportedTexts, found: &mut Vec<Embedded>) {
    let lower = text.to_ascii_lowercase();
    let embedder = Embedder::of(DocumentLanguage::Html, text);
    let trims = embedder.leading_blanks == LeadingBlanks::Trimmed;
    let mut at = 0;
    while let Some(element) = next_script(&lower, at) {
        at = element.end;
        let Some(content) = text.get(element.start..element.end) else {
            return;
        };
        let kind = attribute(element.head, "type").unwrap_or("");
        if is_script(kind) {
            script::extract(content, base + element.start, false, modules, found);
        } else if !is_escaped(content)
            && (kind.contains("shader")
                || kind.contains("glsl")
                || Scanned::of(content).is_shader())
        {
            let id = attribute(element.head, "id").unwrap_or("");
            let masked = mask(content);
            let mut shader = Embedded {
                start: base + element.start,
                has_holes: masked.is_some(),
                code: masked.unwrap_or_else(|| content.to_string()),
                inserted: Vec::new(),
                is_part: false,
                wrapping: Wrapping::Element,
                stage: NamedStage::of([Some(kind), Some(id)]),
                receivers: Vec::new(),
                chapter: 0,
            };
            if trims {
                shader.trim_start();
            }
            found.push(shader);
        }
    }
}

/// The contents of elements that a browser runs as scripts.
pub fn scripts(text: &str) -> Vec<Range<usize>> {
    let lower = text.to_ascii_lowercase();
    let mut found = Vec::new();
    let mut at = 0;
    while let Some(element) = next_script(&lower, at) {
        at = element.end;
        if is_script(attribute(element.head, "type").unwrap_or("")) {
            found.push(element.start..element.end);
        }
    }
    found
}

/// The `id` of the element that contains a shader.
pub fn id_of<'a>(text: &'a str, shader: &Embedded) -> Option<&'a str> {
    if shader.wrapping != Wrapping::Element {
        return None;
    }
    let before = text.get(..shader.start)?.trim_end().strip_suffix('>')?;
    attribute(before.get(before.rfind('<')?..)?, "id")
}

/// A script element of the page in lower case.
pub(super) struct Element<'a> {
    head: &'a str,
    /// Start of the content.
    pub start: usize,
    /// End of the content.
    pub end: usize,
}

/// The first script element after an offset.
pub(super) fn next_script(lower: &str, mut at: usize) -> Option<Element<'_>> {
    loop {
        let open = at + lower.get(at..)?.find('<')?;
        let rest = lower.get(open..)?;
        if rest.starts_with("<!--") {
            at = open + rest.find("-->")? + 3;
            continue;
        }
        let Some(head) = rest.strip_prefix("<script") else {
            at = open + 1;
            continue;
        };
        if !head.starts_with(|c: char| c.is_ascii_whitespace() || c == '>' || c == '/') {
            at = open + 1;
            continue;
        }
        let length = tag_length(head)?;
        let start = open + "<script".len() + length + 1;
        let end = start + lower.get(start..)?.find("</script")?;
        let head = head.get(..length)?;
        return Some(Element { head, start, end });
    }
}

/// Whether angle brackets are escaped as in the text of a page, which is not valid GLSL.
fn is_escaped(content: &str) -> bool {
    content.contains("&lt;") || content.contains("&gt;")
}

/// Whether a browser runs elements of this type.
fn is_script(kind: &str) -> bool {
    kind.is_empty() || kind == "module" || kind.contains("javascript") || kind.contains("babel")
}

#[cfg(test)]
mod tests {
    use super::super::embedded::NoModules;
    use super::*;

    fn found(text: &str) -> Vec<Embedded> {
        let mut found = Vec::new();
        extract(text, 0, &NoModules, &mut found);
        found
    }

    #[test]
    fn shaders_are_found_in_elements_and_scripts() {
        let text = "<!-- <script type='x-shader/x-fragment'>no</script> -->\
            <SCRIPT id=\"a>b\" type=\"x-shader/x-vertex\">\nvoid f() {}</script>\
            <script>x = `#version 300 es\nvoid main() {}`;</script>\
            <script type=\"application/json\">{\"a\": 1}</script>";
        let all = found(text);
        let codes: Vec<&str> = all.iter().map(|s| s.code.as_str()).collect();
        assert_eq!(codes, ["\nvoid f() {}", "#version 300 es\nvoid main() {}"]);
        for shader in &all {
            assert_eq!(
                text.get(shader.start..shader.end()),
                Some(shader.code.as_str())
            );
        }
        assert_eq!(all[0].stage, Some(NamedStage::Vertex));
        assert_ne!(all[1].stage, all[0].stage);
    }

    #[test]
    fn leading_newlines_are_dropped_if_the_page_trims_them() {
        let text = "<script type='x-shader/x-fragment'>\n#version 300 es\n</script>\
            <script>s(document.querySelector('script').textContent.trim())</script>";
        assert!(found(text)[0].code.starts_with("#version"));
    }
}
