//! Detects shader fragments without `main` in strings of programs.

use super::evidence::{Evidence, has_main, is_type};
use super::scan::{ScanKind, ScanToken, tokens};
use std::cell::OnceCell;

/// How certain it is that a text is a shader fragment.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Chunk {
    /// Certain: it defines functions or declares an interface as only GLSL does.
    Clear,
    /// Likely: it does, and is GLSL if the name of the file or variable agrees.
    Likely,
    /// Unlikely.
    No,
}

/// The text of a string, tokenised once for several checks.
pub struct Scanned<'a> {
    text: &'a str,
    all: Vec<ScanToken<'a>>,
    evidence: OnceCell<Evidence<'a>>,
}

impl<'a> Scanned<'a> {
    /// Tokenises a text.
    pub fn of(text: &'a str) -> Scanned<'a> {
        Scanned {
            text,
            all: tokens(text),
            evidence: OnceCell::new(),
        }
    }

    /// The evidence for each language.
    pub fn evidence(&self) -> &Evidence<'a> {
        let read = || Evidence::read(self.text, &self.all);
        self.evidence.get_or_init(read)
    }

    /// How certain it is that the text is a shader fragment of functions and declarations, without
    /// statements.
    pub fn chunk(&self) -> Chunk {
        let (functions, interface) = (has_function(&self.all), has_interface(&self.all));
        let may_be_part = self.text.contains([';', '{']) && (functions || interface);
        match () {
            () if !may_be_part => Chunk::No,
            () if functions && self.evidence().is_glsl() => Chunk::Clear,
            () if self.evidence().may_be_part() => Chunk::Likely,
            () => Chunk::No,
        }
    }

    /// Whether it contains only directives and comments.
    pub fn is_bare(&self) -> bool {
        let mut goes_on = false;
        let mut in_directive = false;
        self.all.iter().all(|token| {
            if token.is_first && !goes_on {
                in_directive = token.text == "#";
            }
            goes_on = token.text == "\\";
            in_directive
        })
    }

    /// Whether it clearly is a complete shader: it starts with `#version` or has a `main`, and is
    /// not another language.
    pub fn is_shader(&self) -> bool {
        let is_candidate = self.text.trim_start().starts_with("#version") || has_main(self.text);
        is_candidate && self.evidence().may_be_glsl()
    }
}

/// The tokens outside of directives, with the number of open brackets.
fn outside<'t, 'a>(
    all: &'t [ScanToken<'a>],
) -> impl Iterator<Item = (usize, u32, &'t ScanToken<'a>)> {
    let mut depth = 0_u32;
    let mut in_directive = false;
    all.iter().enumerate().filter_map(move |(at, token)| {
        if token.is_first {
            in_directive = token.text == "#";
        }
        if in_directive {
            return None;
        }
        match token.text {
            "{" | "(" => depth += 1,
            "}" | ")" => depth = depth.saturating_sub(1),
            _ => {}
        }
        Some((at, depth, token))
    })
}

/// Whether a function is defined: `type name(...) {`.
fn has_function(all: &[ScanToken]) -> bool {
    let text = |at: usize| all.get(at).map_or("", |t| t.text);
    let is_word = |at: usize| all.get(at).is_some_and(|t| t.kind == ScanKind::Word);
    outside(all).any(|(at, depth, token)| {
        let is_head = depth == 0 && is_type(token.text) && is_word(at + 1) && text(at + 2) == "(";
        if !is_head {
            return false;
        }
        let close = (at + 3..all.len()).find(|i| matches!(text(*i), ")" | ";" | "{"));
        close.is_some_and(|c| text(c) == ")" && text(c + 1) == "{")
    })
}

/// Whether an input, output or uniform is declared.
fn has_interface(all: &[ScanToken]) -> bool {
    let text = |at: usize| all.get(at).map_or("", |t| t.text);
    let is_precision = |word: &str| matches!(word, "highp" | "mediump" | "lowp");
    outside(all).any(|(at, depth, token)| {
        let is_qualifier = matches!(
            token.text,
            "uniform" | "varying" | "attribute" | "in" | "out"
        );
        let after = at + 1 + usize::from(is_precision(text(at + 1)));
        depth == 0 && token.is_first && is_qualifier && is_type(text(after))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(text: &str, expected: Chunk) {
        assert_eq!(Scanned::of(text).chunk(), expected, "{text}");
    }

    #[test]
    fn shader_fragments_are_distinguished_from_other_code() {
        check("vec3 f(vec2 p) { return vec3(p, 1.); }", Chunk::Clear);
        check("#define A 1\nuniform vec3 a;\n", Chunk::Likely);
        check("float f(float p) { return p; }", Chunk::Likely);
        check("float a = 1.;\nvec3 b = vec3(a);", Chunk::No);
        check("int main(int a) { printf(\"x\"); }", Chunk::No);
        check("function f(a) { return a; }", Chunk::No);
        check("in vec2 of the text there; are words", Chunk::No);
    }

    #[test]
    fn texts_with_directives_only_are_bare() {
        let is_bare = |text| Scanned::of(text).is_bare();
        assert!(is_bare("#version 300 es\n// x\n#define A \\\n 1\n"));
        assert!(is_bare(""));
        assert!(!is_bare("#version 300 es\nfloat a;"));
    }
}
