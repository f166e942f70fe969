//! Shaders in the elements of a web page.

use super::embedded::{Embedded, ImportedTexts, NamedStage, Wrapping};
use super::tag::{Element, attribute, next_element};
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
            let has_holes = masked.is_some();
            let code = masked.unwrap_or_else(|| content.to_string());
            found.push(Embedded {
                has_holes,
                stage: NamedStage::of([Some(kind), Some(id)]),
                ..Embedded::new(base + element.start, code, Wrapping::Element)
            });
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

/// The offset and the text of the tag that opens an element, with its capital letters.
fn head_of<'t>(text: &'t str, element: &Element) -> (usize, &'t str) {
    let before = text.get(..element.start).unwrap_or("");
    let open = before.rfind('<').unwrap_or(0);
    (open, before.get(open..).unwrap_or(""))
}

/// The scripts of a page that are files: offsets of their elements, paths, and whether they are modules.
pub fn script_files(text: &str) -> Vec<(usize, &str, bool)> {
    let lower = text.to_ascii_lowercase();
    let mut found = Vec::new();
    let mut at = 0;
    while let Some(element) = next_script(&lower, at) {
        at = element.end;
        let (open, head) = head_of(text, &element);
        let kind = attribute(head, "type").unwrap_or("");
        if let Some(path) = attribute(head, "src").filter(|_| is_script(kind)) {
            found.push((open, path, kind == "module"));
        }
    }
    found
}

/// The contents of the script element with this `id`, and its `type`.
pub fn element_of(text: &str, id: &str) -> Option<(Range<usize>, String)> {
    let lower = text.to_ascii_lowercase();
    let mut at = 0;
    while let Some(element) = next_script(&lower, at) {
        at = element.end;
        let (_, head) = head_of(text, &element);
        if attribute(head, "id") == Some(id) {
            let kind = attribute(head, "type").unwrap_or("");
            return Some((element.start..element.end, kind.to_string()));
        }
    }
    None
}

/// The `id` of the element that contains a shader.
pub fn id_of<'a>(text: &'a str, shader: &Embedded) -> Option<&'a str> {
    if shader.wrapping != Wrapping::Element {
        return None;
    }
    let before = text.get(..shader.start)?.trim_end().strip_suffix('>')?;
    attribute(before.get(before.rfind('<')?..)?, "id")
}

/// The first script element of a page in lower case after an offset.
pub(super) fn next_script(lower: &str, at: usize) -> Option<Element<'_>> {
    next_element(lower, at, &["script"], &[])
}

/// Whether angle brackets are escaped as in the text of a page, which is not valid GLSL.
fn is_escaped(content: &str) -> bool {
    content.contains("&lt;") || content.contains("&gt;")
}

/// Whether a browser runs elements of this type.
fn is_script(kind: &str) -> bool {
    kind.is_empty() || kind == "module" || kind.contains("javascript") || kind.contains("babel")
}
