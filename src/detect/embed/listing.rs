//! Shaders in the text of a web page: in elements that show code, and in editors.
//!
//! Entities are decoded. Each is replaced by its character, preceded by blanks to keep the length;
//! consecutive entities are decoded to adjacent characters.

use super::embedded::{Embedded, NamedStage, Wrapping};
use super::tag::{Element, attribute, next_element};
use crate::kind::Scanned;
use shaderlint_text::markup;

/// The elements that show code.
const SHOWN: [&str; 3] = ["pre", "code", "textarea"];

/// Finds the shaders. `lower` is the text in lower case.
pub fn extract(text: &str, lower: &str, base: usize, found: &mut Vec<Embedded>) {
    let mut at = 0;
    while let Some(element) = next_element(lower, at, &SHOWN, &["script", "style"]) {
        at = element.start;
        let Some(content) = text.get(element.start..element.end) else {
            return;
        };
        // The code is in an inner element.
        if element.name == "pre"
            && content
                .trim_start()
                .to_ascii_lowercase()
                .starts_with("<code")
        {
            continue;
        }
        let code = decode(content);
        if is_taken(&element, &code) {
            let label = [
                attribute(element.head, "id"),
                attribute(element.head, "class"),
            ];
            let wrapping = match element.name {
                "textarea" => Wrapping::Element,
                _ => Wrapping::Listing,
            };
            found.push(Embedded {
                stage: NamedStage::of(label),
                ..Embedded::new(base + element.start, code, wrapping)
            });
            at = element.end;
        }
    }
}

/// Whether an element contains a shader: according to an attribute, or clearly by its text.
fn is_taken(element: &Element, code: &str) -> bool {
    let names = ["class", "lang", "data-lang", "data-language", "id", "name"];
    let values = names.iter().filter_map(|n| attribute(element.head, n));
    let words = || {
        let split = |v| str::split(v, |c: char| !c.is_ascii_alphanumeric());
        values.clone().flat_map(split)
    };
    if words().any(|w| w == "glsl") {
        return code.contains([';', '{', '#']);
    }
    // An attribute names another language.
    let is_other = words().any(|w| matches!(w, "language" | "lang"));
    let scanned = Scanned::of(code);
    let is_clear = || scanned.evidence().is_glsl() || element.name == "textarea";
    !is_other && scanned.is_shader() && is_clear()
}

/// The text of an element as shown by a browser, with the same length.
fn decode(content: &str) -> String {
    let mut code = String::with_capacity(content.len());
    let mut rest = content;
    while let Some(c) = rest.chars().next() {
        let taken = match c {
            '<' => tag(rest, &mut code),
            '&' => entities(rest, &mut code),
            _ => 0,
        };
        let length = if taken > 0 {
            taken
        } else {
            code.push(c);
            c.len_utf8()
        };
        rest = rest.get(length..).unwrap_or("");
    }
    code
}

/// Skips a tag of syntax highlighting; 0 if there is none.
fn tag(rest: &str, code: &mut String) -> usize {
    let inner = rest.get(1..).unwrap_or("");
    let inner = inner.strip_prefix('/').unwrap_or(inner);
    let names = [
        "span", "code", "b", "i", "em", "strong", "a", "mark", "br", "pre", "div",
    ];
    let name = inner.split(|c: char| !c.is_ascii_alphanumeric()).next();
    let is_tag = names.contains(&name.unwrap_or("").to_ascii_lowercase().as_str());
    let Some(end) = rest.find('>').filter(|_| is_tag) else {
        return 0;
    };
    let tag = rest.get(..end + 1).unwrap_or("");
    code.extend(tag.bytes().map(|b| if b == b'\n' { '\n' } else { ' ' }));
    tag.len()
}

/// Decodes consecutive entities; returns their length, 0 if there are none.
fn entities(rest: &str, code: &mut String) -> usize {
    let mut length = 0;
    let mut read = String::new();
    while let Some((c, own)) = rest.get(length..).and_then(entity) {
        read.push(c);
        length += own;
    }
    code.extend(std::iter::repeat_n(' ', length - read.len()));
    code.push_str(&read);
    length
}

/// The character of an entity that encodes one byte, and its length.
fn entity(rest: &str) -> Option<(char, usize)> {
    let inner = rest.strip_prefix('&')?;
    let end = inner.bytes().take(8).position(|b| b == b';')?;
    let name = inner.get(..end)?;
    let c = match markup::entity(name)? {
        '\u{a0}' => ' ',
        c => c,
    };
    c.is_ascii().then_some((c, end + 2))
}
