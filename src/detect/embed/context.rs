//! The context of a literal in a script: the variable, property or call that receives it.

use super::token::{ScriptToken, ScriptTokenKind, is_literal, is_mark};
use std::collections::HashSet;

/// What the code before a literal says about it.
pub struct LiteralContext {
    /// A tag or comment marks it as GLSL.
    pub is_introduced: bool,
    /// Its variable, property or call is named like a shader, or compiles it.
    pub names_shader: bool,
    /// A name that contains "vert" receives it.
    pub is_vertex: bool,
    /// It is a search pattern or a replacement.
    pub is_pattern: bool,
    /// It is a message for a person.
    pub is_message: bool,
    /// Name of the variable or property that receives it.
    target: Option<String>,
}

impl LiteralContext {
    /// Analyses the code before a literal.
    pub fn of(text: &str, tokens: &[ScriptToken], literal: usize) -> LiteralContext {
        let read = ContextReader { text, tokens };
        let target = read.target(literal);
        let call = read.call(literal);
        let words = target.map_or(Vec::new(), words);
        let has = |all: &[&str]| words.iter().any(|w| all.contains(&w.as_str()));
        LiteralContext {
            is_introduced: read.is_introduced(literal),
            names_shader: has(&SHADERS) || call == Some("shaderSource"),
            is_vertex: has(&["vert", "vertex", "vs", "vsh"]) || read.is_named_vertex(literal),
            is_pattern: call.is_some_and(|c| PATTERNS.contains(&c)) || read.is_compared(literal),
            is_message: call.is_some_and(|c| c.ends_with("Error") || MESSAGES.contains(&c)),
            target: target.map(str::to_string),
        }
    }

    /// Whether one of some names receives the literal.
    pub fn is_given_to(&self, names: &HashSet<&str>) -> bool {
        self.target.as_deref().is_some_and(|t| names.contains(t))
    }
}

/// Variables of a script to which text is appended: `NAME += ...`.
pub fn grown<'a>(text: &'a str, tokens: &[ScriptToken]) -> HashSet<&'a str> {
    let name = |at: usize| {
        let name = tokens.get(at).filter(|t| t.kind == ScriptTokenKind::Word)?;
        let grows = is_mark(tokens, at + 1, b'+') && is_mark(tokens, at + 2, b'=');
        text.get(name.range.clone()).filter(|_| grows)
    };
    (0..tokens.len()).filter_map(name).collect()
}

/// Words in names of variables that hold shaders.
const SHADERS: [&str; 13] = [
    "shader", "shaders", "vert", "vertex", "frag", "fragment", "vs", "fs", "vsh", "fsh", "glsl",
    "webgl", "chunk",
];
/// String methods that search or replace.
const PATTERNS: [&str; 13] = [
    "replace",
    "replaceAll",
    "indexOf",
    "lastIndexOf",
    "includes",
    "startsWith",
    "endsWith",
    "split",
    "match",
    "matchAll",
    "search",
    "test",
    "RegExp",
];
/// Calls that show a text to a person.
const MESSAGES: [&str; 8] = [
    "log", "warn", "error", "info", "debug", "assert", "describe", "alert",
];

/// Whether the name of a file or of its folder indicates shaders.
pub fn is_file_of_shaders(name: &str) -> bool {
    let mut parts = name.rsplit(['/', '\\']);
    let file = parts.next().unwrap_or("");
    let file = file.rsplit_once('.').map_or(file, |(stem, _)| stem);
    let is_shader = |w: &String| SHADERS.contains(&w.as_str()) && w != "webgl" && w != "chunk";
    words(file).last().is_some_and(is_shader)
        || parts
            .next()
            .is_some_and(|f| words(f).iter().all(is_shader) && !words(f).is_empty())
}

/// The words of a name in lower case: `aVertexShader_FS2` has a, vertex, shader and fs.
fn words(name: &str) -> Vec<String> {
    let mut words: Vec<String> = Vec::new();
    let mut before = ' ';
    for c in name.chars() {
        if c.is_ascii_alphabetic() {
            let starts = !before.is_ascii_alphabetic()
                || c.is_ascii_uppercase() && before.is_ascii_lowercase();
            match words.last_mut().filter(|_| !starts) {
                Some(word) => word.push(c.to_ascii_lowercase()),
                None => words.push(c.to_ascii_lowercase().to_string()),
            }
        }
        before = c;
    }
    words
}

struct ContextReader<'a> {
    text: &'a str,
    tokens: &'a [ScriptToken],
}

impl<'a> ContextReader<'a> {
    fn word(&self, at: usize) -> &'a str {
        let range = self.tokens.get(at).map_or(0..0, |t| t.range.clone());
        self.text.get(range).unwrap_or("")
    }

    fn kind(&self, at: usize) -> Option<&ScriptTokenKind> {
        self.tokens.get(at).map(|t| &t.kind)
    }

    /// Whether a tag or comment marks a literal as GLSL.
    fn is_introduced(&self, literal: usize) -> bool {
        let Some(before) = literal.checked_sub(1) else {
            return false;
        };
        let words = self.word(before);
        match self.kind(before) {
            Some(ScriptTokenKind::Word) => {
                let starts = self.tokens.get(literal).map_or(0, |t| t.range.start);
                let touches = self
                    .tokens
                    .get(before)
                    .is_some_and(|t| t.range.end + 1 == starts);
                let tags = ["frag", "vert", "shader", "fs", "vs", "fragment", "vertex"];
                let tag = words.to_ascii_lowercase();
                touches && (tag.contains("glsl") || tags.contains(&tag.as_str()))
            }
            Some(ScriptTokenKind::Comment) => {
                let words = words
                    .trim_matches(['/', '*', ' ', '\t', '@'])
                    .to_ascii_lowercase();
                let words = words.strip_prefix("language=").unwrap_or(&words).trim();
                words == "glsl" || words.starts_with("glsl ") && words.len() < 20
            }
            _ => false,
        }
    }

    /// The name of the variable or property that receives a literal.
    fn target(&self, literal: usize) -> Option<&'a str> {
        /// Maximum distance in tokens.
        const FAR: usize = 12;
        let mut at = literal;
        for _ in 0..FAR {
            at = at.checked_sub(1)?;
            match self.kind(at)? {
                // The alternative of a conditional expression.
                ScriptTokenKind::Mark(b':') if self.is_case(at) => {}
                ScriptTokenKind::Mark(b'=' | b':') => break,
                ScriptTokenKind::Mark(b';' | b',' | b'{' | b'}' | b')') => return None,
                _ => {}
            }
        }
        let mut name = at.checked_sub(1)?;
        if is_mark(self.tokens, name, b'+') {
            name = name.checked_sub(1)?;
        }
        // `const name: string = "..."`
        let before = name.checked_sub(1)?;
        if is_mark(self.tokens, at, b'=') && is_mark(self.tokens, before, b':') {
            name = before.checked_sub(1)?;
        }
        if is_mark(self.tokens, name, b']') {
            name = name.checked_sub(1)?;
        }
        matches!(
            self.kind(name)?,
            ScriptTokenKind::Word | ScriptTokenKind::Quoted
        )
        .then(|| self.word(name))
    }

    /// Whether a `:` follows a `?` and one literal or word.
    fn is_case(&self, colon: usize) -> bool {
        colon
            .checked_sub(2)
            .is_some_and(|at| is_mark(self.tokens, at, b'?'))
    }

    /// The function that is called with the literal as an argument.
    fn call(&self, literal: usize) -> Option<&'a str> {
        /// Maximum distance in tokens.
        const FAR: usize = 40;
        let mut depth = 0_u32;
        for at in (literal.saturating_sub(FAR)..literal).rev() {
            match self.kind(at)? {
                ScriptTokenKind::Mark(b')' | b']' | b'}') => depth += 1,
                ScriptTokenKind::Mark(b'(') if depth == 0 => {
                    return Some(self.word(at.checked_sub(1)?));
                }
                ScriptTokenKind::Mark(b'[' | b'{' | b';') if depth == 0 => return None,
                ScriptTokenKind::Mark(b'(' | b'[' | b'{') => depth = depth.checked_sub(1)?,
                _ => {}
            }
        }
        None
    }

    /// Whether a literal is compared: `a === "..."`, or in a list of such expressions.
    fn is_compared(&self, literal: usize) -> bool {
        let mark = |back: usize, mark: u8| {
            literal
                .checked_sub(back)
                .is_some_and(|at| is_mark(self.tokens, at, mark))
        };
        mark(1, b'=') && (mark(2, b'=') || mark(2, b'!'))
    }

    /// Whether a name that contains "vert" receives a literal.
    fn is_named_vertex(&self, literal: usize) -> bool {
        let from = literal.saturating_sub(6);
        let after = |at: &usize| {
            !matches!(
                self.kind(*at),
                None | Some(ScriptTokenKind::Mark(b';' | b',' | b'{' | b'(' | b')'))
            ) && !self.tokens.get(*at).is_some_and(is_literal)
        };
        let mut all = (from..literal).rev().take_while(after);
        all.any(|at| {
            let word = self.word(at).to_ascii_lowercase();
            self.kind(at) == Some(&ScriptTokenKind::Word) && (word.contains("vert") || word == "vs")
        })
    }
}

#[cfg(test)]
mod tests {
    use super::super::token::tokens;
    use super::*;

    /// Checks the context of the last literal in a script.
    #[track_caller]
    fn check(text: &str, expected: &str) {
        let all = tokens(text);
        let literal = all.iter().rposition(is_literal).unwrap();
        let context = LiteralContext::of(text, &all, literal);
        let reported = [
            (context.is_introduced, "introduced"),
            (context.names_shader, "named"),
            (context.is_vertex, "vertex"),
            (context.is_pattern, "pattern"),
            (context.is_message, "message"),
        ];
        let reported: Vec<&str> = reported.iter().filter(|t| t.0).map(|t| t.1).collect();
        assert_eq!(reported.join(" "), expected, "{text}");
    }

    #[test]
    fn file_names_indicate_shaders() {
        let all = [
            "a/blur.frag.js",
            "BlurShader.ts",
            "src/shaders/blur.js",
            "vs2.js",
        ];
        assert!(all.iter().all(|n| is_file_of_shaders(n)));
        let none = [
            "shader-park.js",
            "a.js",
            "shader_tools/a.js",
            "fragments.js",
        ];
        assert!(!none.iter().any(|n| is_file_of_shaders(n)));
    }

    #[test]
    fn the_code_around_a_literal_shows_whether_it_is_glsl() {
        check("glsl`x`", "introduced");
        check("/* glsl */ `x`", "introduced");
        check("// language=GLSL\n`x`", "introduced");
        check("const blurFragShader: string = `x`", "named");
        check("a = { 'vertexShader': 'x'", "named vertex");
        check("gl.shaderSource(f(a), 'x')", "named");
        check("a.vs += 'x'", "named vertex");
        check("shader.replace(/a/, 'x')", "pattern");
        check("if (a === 'x')", "pattern");
        check("throw new TypeError('x')", "message");
        check("const a = { shaders: 1, b: 'x' }", "");
        check("const shader = a ? '' : 'x'", "named");
    }
}
