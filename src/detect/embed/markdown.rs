//! Shaders in fenced code blocks of Markdown.

use super::DocumentLanguage;
use super::embedded::{Embedded, Wrapping, left_out};
use super::modules::NoModules;
use super::{component, holes, html, kdl, script};
use crate::kind::Evidence;

/// Finds the shaders.
pub fn extract(text: &str, base: usize, found: &mut Vec<Embedded>) {
    let mut open: Option<OpenFence> = None;
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
                open = Some(OpenFence {
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

struct OpenFence {
    mark: char,
    count: usize,
    label: String,
    start: usize,
    chapter: u32,
}

fn take(text: &str, fence: &OpenFence, end: usize, base: usize, found: &mut Vec<Embedded>) {
    let Some(content) = text.get(fence.start..end) else {
        return;
    };
    let start = base + fence.start;
    let label = fence.label.as_str();
    if let Some(language) = language_of(label) {
        return match language {
            DocumentLanguage::Html => html::extract(content, start, &NoModules, found),
            DocumentLanguage::Script => script::extract(content, start, false, &NoModules, found),
            DocumentLanguage::Component => component::extract(content, start, &NoModules, found),
            DocumentLanguage::Markdown => extract(content, start, found),
            DocumentLanguage::Kdl => kdl::extract(content, start, found),
        };
    }
    let is_named = matches!(
        label,
        "glsl" | "frag" | "vert" | "fragment" | "vertex" | "webgl" | "shadertoy"
    );
    let is_diff = label == "diff" || is_named && is_diff(content);
    let changed = is_diff.then(|| renewed(content));
    let content = changed.as_deref().unwrap_or(content);
    let is_glsl = match label {
        _ if is_named => true,
        "" | "c" | "cpp" | "c++" | "shader" | "text" | "diff" => Evidence::of(content).is_glsl(),
        _ => false,
    };
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
    let code = mask(content);
    let masked = holes::mask(&code);
    found.push(Embedded {
        start,
        has_holes: masked.is_some(),
        inserted: Vec::new(),
        is_part: false,
        code: masked.unwrap_or(code),
        wrapping: Wrapping::Fence,
        is_vertex: label.starts_with("vert"),
        chapter: fence.chapter,
    });
}

fn language_of(label: &str) -> Option<DocumentLanguage> {
    match label {
        "javascript" | "typescript" => Some(DocumentLanguage::Script),
        "md" | "markdown" => None,
        _ => DocumentLanguage::of_extension(label),
    }
}

/// Whether a GLSL fence shows a diff: lines start with `+` or `-` and do not continue an
/// expression.
fn is_diff(content: &str) -> bool {
    let mut is_open = false;
    let mut changes = 0;
    for line in content.lines() {
        let code = line.split("//").next().unwrap_or("").trim_end();
        let mark = line.chars().next().filter(|c| matches!(c, '+' | '-'));
        if let Some(mark) = mark {
            // `++i;` is a statement.
            if is_open || line.chars().nth(1) == Some(mark) {
                return false;
            }
            changes += 1;
        } else if !code.is_empty() {
            let ends = code.ends_with([';', '{', '}', '/', ':']) || line.trim().starts_with('#');
            is_open = !ends;
        }
    }
    changes > 0
}

/// The text after a diff, with the same length: removed lines are blank.
fn renewed(content: &str) -> String {
    let mut text = String::with_capacity(content.len());
    for line in content.split_inclusive('\n') {
        if line.starts_with(['-', '@']) || line.starts_with("+++") {
            text.extend(line.bytes().map(|b| if b == b'\n' { '\n' } else { ' ' }));
        } else if let Some(rest) = line.strip_prefix('+') {
            text.push(' ');
            text.push_str(rest);
        } else {
            text.push_str(line);
        }
    }
    text
}

/// Replaces quotation marks at the start of lines, and `...`, with blanks.
fn mask(content: &str) -> String {
    let mut code = String::with_capacity(content.len());
    for line in content.split_inclusive('\n') {
        let quote = line.len() - line.trim_start_matches(['>', ' ', '\t']).len();
        let (before, rest) = line.split_at_checked(quote).unwrap_or(("", line));
        code.push_str(&before.replace('>', " "));
        let mut rest = rest;
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
    fn only_fences_with_glsl_are_read() {
        let text = "```glsl\na\n```\n\n```\nvec3 c = vec2(1);\n```\n```python\nvec3 = vec2\n```\n~~~c\nint main() {}\n~~~\n";
        assert_eq!(codes(text), ["a\n", "vec3 c = vec2(1);\n"]);
    }

    #[test]
    fn quoted_and_unclosed_fences_are_read() {
        assert_eq!(codes("> ```glsl\n> x ... y\n> ```\n"), ["  x     y\n"]);
        assert_eq!(codes("````glsl\n```\nx\n"), ["```\nx\n"]);
    }

    #[test]
    fn diffs_are_read_as_the_code_after_the_change() {
        assert_eq!(
            codes("```diff\n vec3 a;\n-vec3 b = vec3(1);\n+vec3 c = vec3(1);\n```\n"),
            [" vec3 a;\n                  \n vec3 c = vec3(1);\n"]
        );
        assert_eq!(
            codes("```glsl\nfloat a;\n-b;\n+c;\n```\n```glsl\nfloat a = b\n+ c;\n++a;\n```\n"),
            ["float a;\n   \n c;\n", "float a = b\n+ c;\n++a;\n"]
        );
        assert_eq!(codes("```diff\n-npm i a\n+npm i b\n```\n"), [""; 0]);
    }

    #[test]
    fn template_expressions_in_fences_are_holes() {
        let mut found = Vec::new();
        extract("```glsl\nfloat a = {{ b }};\n```\n", 0, &mut found);
        assert!(found[0].has_holes && found[0].code == "float a = hhhhhhh;\n");
    }

    #[test]
    fn shaders_in_script_fences_are_read() {
        let text = "```js\nconst a = `#version 300 es\nx\n`;\n```\n```glsl\nconst b = `#version 300 es\nx\n`;\n```\n";
        assert_eq!(
            codes(text),
            ["#version 300 es\nx\n", "#version 300 es\nx\n"]
        );
    }
}
