//! Shaders in the text of a web page: in elements that show code, and in editors.
//!
//! Entities are decoded. Each is replaced by its character, preceded by blanks to keep the length;
//! consecutive entities are decoded to adjacent characters.

use super::embedded::NamedStage;
use super::embedded::{Embedded, Wrapping};
use super::tag::{attribute, tag_length};
use crate::kind::Scanned;
use shaderlint_text::markup;

/// Finds the shaders. `lower` is the text in lower case.
pub fn extract(text: &str, lower: &str, base: usize, found: &mut Vec<Embedded>) {
    let mut at = 0;
    while let Some(element) = next(lower, at) {
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
            found.push(Embedded {
                start: base + element.start,
                code,
                wrapping: match element.name {
                    "textarea" => Wrapping::Element,
                    _ => Wrapping::Listing,
                },
                has_holes: false,
                inserted: Vec::new(),
                is_part: false,
                stage: NamedStage::of(label),
                receivers: Vec::new(),
                chapter: 0,
            });
            at = element.end;
        }
    }
}

/// An element that shows code.
struct CodeElement<'a> {
    name: &'static str,
    head: &'a str,
    start: usize,
    end: usize,
}

fn next(lower: &str, mut at: usize) -> Option<CodeElement<'_>> {
    loop {
        let open = at + lower.get(at..)?.find('<')?;
        let rest = lower.get(open..)?;
        at = open + 1;
        if rest.starts_with("<!--") {
            at = open + rest.find("-->")? + 3;
            continue;
        }
        let skipped = ["script", "style"].into_iter().find(|n| opens(rest, n));
        if let Some(name) = skipped {
            at = open + rest.find(&format!("</{name}"))?;
            at += 1;
            continue;
        }
        let name = ["pre", "code", "textarea"]
            .into_iter()
            .find(|n| opens(rest, n));
        let Some(name) = name else { continue };
        let head = rest.get(1 + name.len()..)?;
        let length = tag_length(head)?;
        let start = open + 1 + name.len() + length + 1;
        let end = start + lower.get(start..)?.find(&format!("</{name}"))?;
        let head = head.get(..length)?;
        return Some(CodeElement {
            name,
            head,
            start,
            end,
        });
    }
}

/// Whether an element of this name starts here.
fn opens(rest: &str, name: &str) -> bool {
    let after = rest.get(1..).and_then(|r| r.strip_prefix(name));
    after.is_some_and(|b| b.starts_with(|c: char| c.is_ascii_whitespace() || c == '>'))
}

/// Whether an element contains a shader: according to an attribute, or clearly by its text.
fn is_taken(element: &CodeElement, code: &str) -> bool {
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

#[cfg(test)]
mod tests {
    use super::*;

    /// Joins the shaders of a page with `|`.
    #[track_caller]
    fn check(text: &str, expected: &str) {
        let mut found = Vec::new();
        extract(text, &text.to_ascii_lowercase(), 0, &mut found);
        for shader in &found {
            assert!(text.get(shader.start..shader.end()).is_some());
        }
        let codes: Vec<String> = found.into_iter().map(|s| s.code).collect();
        assert_eq!(codes.join("|"), expected, "{text}");
    }

    #[test]
    fn decoded_entities_keep_their_width() {
        check(
            "<pre class='language-glsl'>a&lt;b&amp;&amp;c&gt;=d;</pre>",
            "a   <b        &&c   >=d;",
        );
        check(
            "<PRE><code lang=glsl>a&#39;&#x3C;&copy;;</code></PRE>",
            "a         '<&copy;;",
        );
    }

    #[test]
    fn glsl_elements_are_found_by_class_or_content() {
        check(
            "<textarea>void main() { gl_FragColor = vec4(1 &lt; 2); }</textarea>",
            "void main() { gl_FragColor = vec4(1    < 2); }",
        );
        check(
            "<code class=\"glsl\"><span class='k'>float</span> a;</code>",
            "                float        a;",
        );
        check(
            "<code class='glsl'>vec3</code><pre>void main() in C</pre>",
            "",
        );
        check(
            "<pre class='language-c'>void main() { vec3(vec2(1)); }</pre>",
            "",
        );
        check("<script><pre class='glsl'>a;</pre></script>", "");
    }
}
