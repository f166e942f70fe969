//! How a script uses its shaders: which ones it combines to a program, and which uniforms it sets.

use super::DocumentLanguage;
use super::embedded::Embedded;
use super::html;
use super::token::{ScriptToken, ScriptTokenKind, tokens};
use std::collections::HashMap;
use std::ops::Range;

/// Maximum number of shaders in one pair of brackets.
const MAX_GROUP: usize = 8;

/// The shaders that occur together in a pair of brackets of a script: a call, an object, the body
/// of a function. Indices refer to `all`.
pub fn together(language: DocumentLanguage, text: &str, all: &[Embedded]) -> Vec<Vec<usize>> {
    let mut groups = Vec::new();
    for script in scripts(language, text) {
        let read = tokens(text.get(script.clone()).unwrap_or(""));
        let names = ShaderNames::of(text, script.start, &read, all);
        names.groups(&read, &mut groups);
    }
    groups.sort();
    groups.dedup();
    groups
}

/// The scripts in a file.
pub fn scripts(language: DocumentLanguage, text: &str) -> Vec<Range<usize>> {
    match language {
        DocumentLanguage::Script => std::iter::once(0..text.len()).collect(),
        DocumentLanguage::Markdown | DocumentLanguage::Kdl => Vec::new(),
        _ => html::scripts(text),
    }
}

/// The contents of quoted strings in the scripts of a file.
pub fn strings(language: DocumentLanguage, text: &str) -> Vec<Range<usize>> {
    let mut found = Vec::new();
    for script in scripts(language, text) {
        let read = tokens(text.get(script.clone()).unwrap_or("")).into_iter();
        let quoted = read.filter(|t| t.kind == ScriptTokenKind::Quoted);
        found.extend(quoted.map(|t| script.start + t.range.start..script.start + t.range.end));
    }
    found
}

/// The names of shaders in a script.
struct ShaderNames<'a> {
    text: &'a str,
    base: usize,
    all: &'a [Embedded],
    /// By variable, or by `id` of an element: the shader; `None` if several have the same name.
    named: HashMap<&'a str, Option<usize>>,
}

impl<'a> ShaderNames<'a> {
    fn of(
        text: &'a str,
        base: usize,
        tokens: &[ScriptToken],
        all: &'a [Embedded],
    ) -> ShaderNames<'a> {
        let mut names = ShaderNames {
            text,
            base,
            all,
            named: HashMap::new(),
        };
        for (index, shader) in all.iter().enumerate() {
            if let Some(id) = html::id_of(text, shader) {
                names.add(id, index);
            }
        }
        for (at, token) in tokens.iter().enumerate() {
            if let (Some(index), Some(name)) = (names.literal(token), names.variable(tokens, at)) {
                names.add(name, index);
            }
        }
        names
    }

    fn add(&mut self, name: &'a str, index: usize) {
        let known = self.named.entry(name).or_insert(Some(index));
        if *known != Some(index) {
            *known = None;
        }
    }

    fn word(&self, token: Option<&ScriptToken>) -> &'a str {
        let range = token.map_or(0..0, |t| t.range.clone());
        let range = range.start + self.base..range.end + self.base;
        self.text.get(range).unwrap_or("")
    }

    /// The shader that starts in a literal.
    fn literal(&self, token: &ScriptToken) -> Option<usize> {
        if !matches!(
            token.kind,
            ScriptTokenKind::Quoted | ScriptTokenKind::Template(_)
        ) {
            return None;
        }
        let (start, end) = (token.range.start + self.base, token.range.end + self.base);
        let index = self.all.partition_point(|s| s.start < start);
        let shader = self.all.get(index)?;
        (shader.start <= end && end > start).then_some(index)
    }

    /// The variable that a literal initialises: `const NAME = glsl\`...\``.
    fn variable(&self, tokens: &[ScriptToken], literal: usize) -> Option<&'a str> {
        let mut before = tokens.get(literal.saturating_sub(6)..literal)?.iter().rev();
        let tags = |t: &&ScriptToken| {
            matches!(
                t.kind,
                ScriptTokenKind::Word | ScriptTokenKind::Comment | ScriptTokenKind::Mark(b'[')
            )
        };
        let equals = before.by_ref().find(|t| !tags(t))?;
        let name = before.next()?;
        let is_name =
            equals.kind == ScriptTokenKind::Mark(b'=') && name.kind == ScriptTokenKind::Word;
        is_name.then(|| self.word(Some(name)))
    }

    /// The shader that a token denotes.
    fn meant(&self, tokens: &[ScriptToken], at: usize) -> Option<usize> {
        let token = tokens.get(at)?;
        let mark = |at: Option<usize>, mark| {
            let token = at.and_then(|a| tokens.get(a));
            token.is_some_and(|t| t.kind == ScriptTokenKind::Mark(mark))
        };
        match token.kind {
            ScriptTokenKind::Quoted | ScriptTokenKind::Template(_) => {
                self.literal(token).or_else(|| {
                    let name = self.word(Some(token));
                    self.named
                        .get(name.trim_start_matches('#'))
                        .copied()
                        .flatten()
                })
            }
            // A key or a member is not a variable.
            ScriptTokenKind::Word if mark(Some(at + 1), b':') || mark(at.checked_sub(1), b'.') => {
                None
            }
            ScriptTokenKind::Word => self.named.get(self.word(Some(token))).copied().flatten(),
            _ => None,
        }
    }

    /// Finds the shaders in each pair of brackets.
    fn groups(&self, tokens: &[ScriptToken], found: &mut Vec<Vec<usize>>) {
        let mut open: Vec<Vec<usize>> = Vec::new();
        let add = |group: &mut Vec<usize>, index: usize| {
            if group.len() <= MAX_GROUP && !group.contains(&index) {
                group.push(index);
            }
        };
        for (at, token) in tokens.iter().enumerate() {
            match token.kind {
                ScriptTokenKind::Mark(b'(' | b'{' | b'[') => open.push(Vec::new()),
                ScriptTokenKind::Mark(b')' | b'}' | b']') => {
                    let mut closed = open.pop().unwrap_or_default();
                    if let Some(outer) = open.last_mut() {
                        closed.iter().for_each(|i| add(outer, *i));
                    }
                    if (2..=MAX_GROUP).contains(&closed.len()) {
                        closed.sort_unstable();
                        found.push(closed);
                    }
                }
                _ => {
                    if let (Some(group), Some(index)) = (open.last_mut(), self.meant(tokens, at)) {
                        add(group, index);
                    }
                }
            }
        }
    }
}

/// A uniform that a script refers to.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Asked {
    /// Name without index and members.
    pub name: String,
    /// Range of the name in the file.
    pub range: Range<usize>,
}

/// The uniforms that the scripts of a file refer to: `getUniformLocation(program, "name")`, and
/// keys of `uniforms: { ... }`.
pub fn asked(language: DocumentLanguage, text: &str) -> Vec<Asked> {
    let mut found = Vec::new();
    for script in scripts(language, text) {
        let content = text.get(script.clone()).unwrap_or("");
        let read = tokens(content);
        let word = |at: usize| {
            let range = read.get(at).map_or(0..0, |t| t.range.clone());
            content.get(range).unwrap_or("")
        };
        let mut at = 0;
        while at < read.len() {
            let (names, after) = match word(at) {
                "getUniformLocation" => {
                    let name = second_argument(&read, at + 1);
                    (name.into_iter().collect(), at + 1)
                }
                "uniforms" => keys(&read, at + 1),
                _ => (Vec::new(), at + 1),
            };
            at = after;
            for name in names {
                let text = content.get(name.range.clone()).unwrap_or("");
                let end = text.find(['[', '.']).unwrap_or(text.len());
                let name = (text.get(..end).unwrap_or(""), name.range.start);
                let is_plain = |c: char| c.is_ascii_alphanumeric() || c == '_';
                if !name.0.is_empty() && name.0.chars().all(is_plain) {
                    let start = script.start + name.1;
                    found.push(Asked {
                        name: name.0.to_string(),
                        range: start..start + end,
                    });
                }
            }
        }
    }
    found
}

/// The keys of the object after `uniforms:`, and the index of its last token.
fn keys(tokens: &[ScriptToken], at: usize) -> (Vec<&ScriptToken>, usize) {
    let mark = |at: usize, mark| {
        tokens
            .get(at)
            .is_some_and(|t| t.kind == ScriptTokenKind::Mark(mark))
    };
    let mut keys = Vec::new();
    if !mark(at, b':') || !mark(at + 1, b'{') {
        return (keys, at);
    }
    let mut depth = 0_u32;
    for (i, token) in tokens.iter().enumerate().skip(at + 1) {
        match token.kind {
            ScriptTokenKind::Mark(b'(' | b'[' | b'{') => depth += 1,
            ScriptTokenKind::Mark(b')' | b']' | b'}') if depth <= 1 => return (keys, i),
            ScriptTokenKind::Mark(b')' | b']' | b'}') => depth -= 1,
            ScriptTokenKind::Word | ScriptTokenKind::Quoted
                if depth == 1 && mark(i + 1, b':') && (mark(i - 1, b'{') || mark(i - 1, b',')) =>
            {
                keys.push(token);
            }
            _ => {}
        }
    }
    (keys, tokens.len())
}

/// The string that is the complete second argument of the call with its parenthesis at `open`.
fn second_argument(tokens: &[ScriptToken], open: usize) -> Option<&ScriptToken> {
    /// Maximum length of the first argument in tokens.
    const MAX_ARGUMENT: usize = 16;
    let mut depth = 0_u32;
    for at in open..open + MAX_ARGUMENT {
        match tokens.get(at)?.kind {
            ScriptTokenKind::Mark(b'(' | b'[') => depth += 1,
            ScriptTokenKind::Mark(b')' | b']') => depth = depth.checked_sub(1)?,
            ScriptTokenKind::Mark(b',') if depth == 1 => {
                let (name, close) = (tokens.get(at + 1)?, tokens.get(at + 2)?);
                let is_string = match &name.kind {
                    ScriptTokenKind::Quoted => true,
                    ScriptTokenKind::Template(holes) => holes.is_empty(),
                    _ => false,
                };
                let is_all = close.kind == ScriptTokenKind::Mark(b')');
                return (is_string && is_all).then_some(name);
            }
            _ => {}
        }
        if depth == 0 {
            return None;
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::super::extract;
    use super::*;

    /// Checks the groups of shaders in a script; each shader is `void main() { NAME; }`.
    #[track_caller]
    fn check(text: &str, expected: &str) {
        let language = if text.starts_with('<') {
            DocumentLanguage::Html
        } else {
            DocumentLanguage::Script
        };
        let all = extract(language, text);
        let name = |i: &usize| all[*i].code.split(['{', ';']).nth(1).unwrap().trim();
        let groups = together(language, text, &all);
        let groups: Vec<String> = groups
            .iter()
            .map(|g| g.iter().map(name).collect::<Vec<_>>().join("+"))
            .collect();
        assert_eq!(groups.join(" "), expected, "{text}");
    }

    #[test]
    fn shaders_used_by_the_same_call_are_paired() {
        check(
            "const v = `void main() { a; }`; const f = \"void main() { b; }\"; link(gl, v, f);",
            "a+b",
        );
        check(
            "x({ vertexShader: `void main() { a; }`, fragmentShader: glsl`void main() { b; }` });\
             x({ vertexShader: `void main() { c; }`, fragmentShader: `void main() { d; }` });",
            "a+b c+d",
        );
        check(
            "const v = `void main() { a; }`, f = `void main() { b; }`; x.v = f; x({ v: 1, f });",
            "",
        );
        check(
            "<script type=\"x-shader/x-vertex\" id=\"v\">void main() { a; }</script>\
             <script type=\"x-shader/x-fragment\" id=\"f\">void main() { b; }</script>\
             <script>link(get('v'), document.querySelector('#f'));</script>",
            "a+b",
        );
    }

    #[test]
    fn queried_uniforms_are_found() {
        let text = "m({ uniforms: { uA: { value: x ? y : z }, 'uB': b, ...c } });\
            a = gl.getUniformLocation(p[1], \"uTime\"); gl.getUniformLocation(p, name);\
            gl.getUniformLocation(p, 'uLight[0].color'); gl.getUniformLocation(p, 'u' + i);";
        let all = asked(DocumentLanguage::Script, text);
        let names: Vec<_> = all
            .iter()
            .map(|a| (a.name.as_str(), &text[a.range.clone()]))
            .collect();
        let expected = ["uA", "uB", "uTime", "uLight"];
        assert_eq!(names, expected.map(|n| (n, n)));
    }
}
