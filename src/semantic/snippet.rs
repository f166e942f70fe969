//! Splits shader snippets from documents: statements outside functions, names declared elsewhere.
//! Such a snippet can still be checked in part.

use shaderlint_syntax::{RawKind, TokenKind, written_tokens};
use std::ops::Range;

/// An item of a snippet, as a byte range.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum SnippetItem {
    /// A directive, a function, a struct or a declaration at global scope.
    Global(Range<usize>),
    /// A declaration that is or may be inside a function.
    Declaration(Range<usize>),
    /// Any other statement.
    Statement(Range<usize>),
}

/// Splits a snippet into items. The text between items is whitespace or comments.
pub fn items(text: &str) -> Vec<SnippetItem> {
    let mut splitter = Splitter {
        text,
        tokens: significant(text),
        at: 0,
    };
    let mut items = Vec::new();
    while let Some(item) = splitter.item() {
        items.push(item);
    }
    items
}

/// Whether a snippet is part of a function body: it has statements outside functions.
pub fn is_body(text: &str) -> bool {
    let all = items(text);
    let defines = |item: &SnippetItem| match item {
        SnippetItem::Global(range) => {
            let code = text.get(range.clone()).unwrap_or("");
            !code.starts_with('#')
        }
        _ => false,
    };
    all.iter().any(|i| matches!(i, SnippetItem::Statement(_))) && !all.iter().any(defines)
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    Word,
    Hash,
    Open,
    Close,
    OpenBrace,
    CloseBrace,
    Semicolon,
    Newline,
    Other,
}

struct Splitter<'a> {
    text: &'a str,
    tokens: Vec<(Kind, Range<usize>)>,
    at: usize,
}

/// The tokens except whitespace and comments; line breaks are kept.
fn significant(text: &str) -> Vec<(Kind, Range<usize>)> {
    let mut found = Vec::new();
    for (raw, range, _) in written_tokens(text) {
        let kind = match raw {
            blank if blank.is_blank() => continue,
            RawKind::Newline => Kind::Newline,
            RawKind::Word | RawKind::ForeignWord => Kind::Word,
            RawKind::Hash => Kind::Hash,
            RawKind::Operator(TokenKind::LeftParen | TokenKind::LeftBracket) => Kind::Open,
            RawKind::Operator(TokenKind::RightParen | TokenKind::RightBracket) => Kind::Close,
            RawKind::Operator(TokenKind::LeftBrace) => Kind::OpenBrace,
            RawKind::Operator(TokenKind::RightBrace) => Kind::CloseBrace,
            RawKind::Operator(TokenKind::Semicolon) => Kind::Semicolon,
            _ => Kind::Other,
        };
        found.push((kind, range));
    }
    found
}

/// Keywords that start a declaration that is or may be at global scope.
const GLOBAL: &str = "\
    struct uniform in out varying attribute layout precision const flat centroid smooth invariant";
/// Keywords that start a statement other than a declaration.
const STATEMENT: &[&str] = &[
    "return", "else", "if", "for", "while", "do", "switch", "case", "default", "break", "continue",
    "discard",
];

impl Splitter<'_> {
    fn kind(&self, at: usize) -> Option<Kind> {
        self.tokens.get(at).map(|t| t.0)
    }

    fn word(&self, at: usize) -> &str {
        let range = self.tokens.get(at).map_or(0..0, |t| t.1.clone());
        self.text.get(range).unwrap_or("")
    }

    /// Index of the next token at or after an index that is not a line break.
    fn solid(&self, mut at: usize) -> usize {
        while self.kind(at) == Some(Kind::Newline) {
            at += 1;
        }
        at
    }

    fn item(&mut self) -> Option<SnippetItem> {
        let first = self.solid(self.at);
        let start = self.tokens.get(first)?.1.start;
        if self.kind(first) == Some(Kind::Hash) {
            self.at = first;
            while self.kind(self.at).is_some_and(|k| k != Kind::Newline) {
                self.at += 1;
            }
            return Some(SnippetItem::Global(start..self.end()));
        }
        let second = self.solid(first + 1);
        let third = self.solid(second + 1);
        let word = self.word(first);
        let names = self.kind(first) == Some(Kind::Word)
            && self.kind(second) == Some(Kind::Word)
            && !STATEMENT.contains(&word);
        let is_global = GLOBAL.split(' ').any(|keyword| keyword == word);
        let calls = names && self.kind(third) == Some(Kind::Open) && self.word(third) == "(";
        self.at = first;
        let ends_with_brace = self.pass_statement();
        let range = start..self.end();
        Some(match () {
            () if is_global || calls && (ends_with_brace || self.ends_with_semicolon()) => {
                SnippetItem::Global(range)
            }
            () if names => SnippetItem::Declaration(range),
            () => SnippetItem::Statement(range),
        })
    }

    fn ends_with_semicolon(&self) -> bool {
        self.at
            .checked_sub(1)
            .is_some_and(|last| self.kind(last) == Some(Kind::Semicolon))
    }

    /// Where the last skipped token ends.
    fn end(&self) -> usize {
        let last = self
            .at
            .checked_sub(1)
            .and_then(|last| self.tokens.get(last));
        last.map_or(self.text.len(), |t| t.1.end)
    }

    /// Skips one statement; returns whether it ends with a `}`.
    fn pass_statement(&mut self) -> bool {
        let mut depth = 0_u32;
        let mut has_equal = false;
        let is_block_word = matches!(self.word(self.at), "struct" | "uniform" | "do" | "layout");
        while let Some(kind) = self.kind(self.at) {
            let opens = self.word(self.at) == "=";
            self.at += 1;
            match kind {
                Kind::Open | Kind::OpenBrace => depth += 1,
                Kind::Close => depth = depth.saturating_sub(1),
                Kind::CloseBrace => {
                    depth = depth.saturating_sub(1);
                    let goes_on =
                        has_equal || is_block_word || self.word(self.solid(self.at)) == "else";
                    if depth == 0 && !goes_on {
                        return true;
                    }
                }
                Kind::Semicolon if depth == 0 && self.word(self.solid(self.at)) != "else" => {
                    return false;
                }
                Kind::Other if depth == 0 => has_equal |= opens,
                _ => {}
            }
        }
        false
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn statements_and_declarations_of_a_snippet_are_distinguished() {
        let text = "#define A 1\nfloat f(float x) { return x; }\nfloat a = f(1.0);\na += 2.0;\n\
            if (a > 1.0) { a = 1.0; } else a = 2.0;\nfor (int i = 0; i < 3; i++) { a++; }\n\
            struct S { float x; };\nconst float B = 1.0;\nreturn a;\nvec3 g(vec3 p);\nfloat b";
        let kinds: Vec<(char, &str)> = items(text)
            .into_iter()
            .map(|item| match item {
                SnippetItem::Global(r) => ('g', &text[r]),
                SnippetItem::Declaration(r) => ('d', &text[r]),
                SnippetItem::Statement(r) => ('s', &text[r]),
            })
            .collect();
        let expected = [
            ('g', "#define A 1"),
            ('g', "float f(float x) { return x; }"),
            ('d', "float a = f(1.0);"),
            ('s', "a += 2.0;"),
            ('s', "if (a > 1.0) { a = 1.0; } else a = 2.0;"),
            ('s', "for (int i = 0; i < 3; i++) { a++; }"),
            ('g', "struct S { float x; };"),
            ('g', "const float B = 1.0;"),
            ('s', "return a;"),
            ('g', "vec3 g(vec3 p);"),
            ('d', "float b"),
        ];
        assert_eq!(kinds, expected);
    }
}
