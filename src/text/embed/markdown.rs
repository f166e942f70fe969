//! Shaders in the fences of a Markdown text.

use super::{Embedded, Language, Wrapping, extract_into};
use crate::text::kind::Evidence;

/// Finds them.
pub fn extract(text: &str, base: usize, found: &mut Vec<Embedded>) {
    let mut open: Option<Fence> = None;
    let mut at = 0;
    let mut chapter = 0;
    for line in text.split_inclusive('\n') {
        let start = at;
        at += line.len();
        let quoted = line.trim_start_matches(['>', ' ', '\t']);
        let mark = quoted.chars().next().unwrap_or(' ');
        let count = quoted.chars().take_while(|c| *c == mark).count();
        let is_mark = matches!(mark, '`' | '~') && count >= 3;
        let info = quoted.get(count..).unwrap_or("").trim();
        match &open {
            Some(fence)
                if is_mark && mark == fence.mark && count >= fence.count && info.is_empty() =>
            {
                take(text, fence, start, base, found);
                open = None;
            }
            None if is_mark && !info.contains('`') => {
                let label = info
                    .split([' ', ',', '{', '}', ':'])
                    .find(|w| !w.is_empty());
                open = Some(Fence {
                    mark,
                    count,
                    label: label
                        .unwrap_or("")
                        .trim_start_matches('.')
                        .to_ascii_lowercase(),
                    start: at,
                    chapter,
                });
            }
            None if line.starts_with("# ") || line.starts_with("## ") => chapter += 1,
            _ => {}
        }
    }
    if let Some(fence) = open {
        take(text, &fence, text.len(), base, found);
    }
}

/// A fence that has been opened.
struct Fence {
    mark: char,
    count: usize,
    /// The language that it names.
    label: String,
    /// Where its content starts.
    start: usize,
    /// Number of the chapter.
    chapter: u32,
}

fn take(text: &str, fence: &Fence, end: usize, base: usize, found: &mut Vec<Embedded>) {
    let Some(content) = text.get(fence.start..end) else {
        return;
    };
    let start = base + fence.start;
    let label = fence.label.as_str();
    if let Some(language) = language_of(label) {
        return extract_into(language, content, start, found);
    }
    let is_glsl = match label {
        "glsl" | "frag" | "vert" | "fragment" | "vertex" | "webgl" | "shadertoy" => true,
        "" | "c" | "cpp" | "c++" | "shader" | "text" => Evidence::of(content).is_glsl(),
        _ => false,
    };
    if !is_glsl || content.trim().is_empty() {
        return;
    }
    // A fence of GLSL that shows how a script holds it.
    if content.contains("= `") || content.contains("glsl`") {
        let count = found.len();
        extract_into(Language::Script, content, start, found);
        if found.len() > count {
            return;
        }
    }
    found.push(Embedded {
        start,
        code: mask(content),
        wrapping: Wrapping::Fence,
        has_holes: false,
        is_vertex: label.starts_with("vert"),
        chapter: fence.chapter,
    });
}

fn language_of(label: &str) -> Option<Language> {
    match label {
        "javascript" | "typescript" => Some(Language::Script),
        "md" | "markdown" => None,
        _ => Language::of_extension(label),
    }
}

/// Puts blanks in the place of quotation marks at the start of lines, and of `...`.
fn mask(content: &str) -> String {
    let mut code = String::with_capacity(content.len());
    for line in content.split_inclusive('\n') {
        let quote = line.len() - line.trim_start_matches(['>', ' ', '\t']).len();
        let (before, rest) = line.split_at_checked(quote).unwrap_or(("", line));
        code.push_str(&before.replace('>', " "));
        code.push_str(&rest.replace("...", "   ").replace('\u{2026}', "   "));
    }
    code
}

#[cfg(test)]
mod tests {
    use super::*;

    fn codes(text: &str) -> Vec<String> {
        let mut found = Vec::new();
        extract(text, 0, &mut found);
        for shader in &found {
            assert!(text.get(shader.start..shader.end()).is_some());
        }
        found.into_iter().map(|s| s.code).collect()
    }

    #[test]
    fn fences_are_told_apart() {
        let text = "```glsl\na\n```\n\n```\nvec3 c = vec2(1);\n```\n```python\nvec3 = vec2\n```\n~~~c\nint main() {}\n~~~\n";
        assert_eq!(codes(text), ["a\n", "vec3 c = vec2(1);\n"]);
    }

    #[test]
    fn quoted_and_open_fences() {
        assert_eq!(codes("> ```glsl\n> x ... y\n> ```\n"), ["  x     y\n"]);
        assert_eq!(codes("````glsl\n```\nx\n"), ["```\nx\n"]);
    }

    #[test]
    fn scripts_in_fences() {
        let text = "```js\nconst a = `#version 300 es\nx\n`;\n```\n```glsl\nconst b = `#version 300 es\nx\n`;\n```\n";
        assert_eq!(
            codes(text),
            ["#version 300 es\nx\n", "#version 300 es\nx\n"]
        );
    }
}
