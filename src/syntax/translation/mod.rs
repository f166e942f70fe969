//! Translates constructs of other languages to GLSL, on tokens.
//!
//! If a shader has syntax errors, it is searched for constructs of other languages that are never
//! valid GLSL. Each is reported once with a fix, and the parser sees the GLSL equivalent.

mod declaration;
mod operator;
mod pointer;
mod statement;

use super::foreign::{Meaning, foreign};
use super::names::{Name, TypeWord, Version, WordClass, classify};
use super::token::{Token, TokenKind};
use shaderlint_diagnostic::{Diagnostic, Fix, error};
use shaderlint_text::{Edit, Sources, Span};
use std::cell::Cell;

/// Maximum number of translated constructs per shader.
const MAX_FORMS: usize = 100;
/// Maximum length of a header or statement that is scanned, in tokens.
const MAX_INSIDE: usize = 400;
/// Total number of tokens that may be scanned for matching brackets.
const MAX_PASSED: usize = 4_000_000;

/// A shader translated to GLSL.
pub struct Translation {
    /// The translated tokens.
    pub tokens: Vec<Token>,
    /// Errors and names lost in the translation.
    pub translated: Translated,
}

/// Foreign constructs found in a shader.
#[derive(Default)]
pub struct Translated {
    /// Errors for constructs that GLSL does not have.
    pub diagnostics: Vec<Diagnostic>,
    /// Names whose declarations were dropped.
    pub lost: Vec<Name>,
}

/// Translates the foreign constructs among `tokens`; `None` if there are none.
pub fn translate(sources: &Sources, tokens: &[Token], version: Version) -> Option<Translation> {
    let mut translator = Translator {
        sources,
        tokens,
        version,
        at: 0,
        here: (usize::MAX, ""),
        braces: 0,
        parens: 0,
        questions: 0,
        start: 0,
        ends: Vec::new(),
        aliases: Vec::new(),
        out: Vec::with_capacity(tokens.len()),
        diagnostics: Vec::new(),
        lost: Vec::new(),
        changed: false,
        passed: Cell::new(0),
        pointer: None,
    };
    while translator.at < tokens.len() {
        translator.step();
    }
    // Keep the end token whatever was removed.
    if let Some(&end) = tokens.last()
        && translator.before() != end.kind
    {
        translator.out.push(end);
    }
    let Translator {
        out: tokens,
        diagnostics,
        lost,
        changed,
        ..
    } = translator;
    (changed || !diagnostics.is_empty()).then_some(Translation {
        tokens,
        translated: Translated { diagnostics, lost },
    })
}

struct Translator<'a> {
    sources: &'a Sources,
    tokens: &'a [Token],
    version: Version,
    /// Index of the next token.
    at: usize,
    /// Index and text of the first token of the current step, cached for all checks.
    here: (usize, &'a str),
    /// Open braces, open parentheses and brackets, and `?` of the current statement.
    braces: u32,
    parens: u32,
    questions: u32,
    /// Index in `out` of the first token of the current statement.
    start: usize,
    /// Indices of the `end` words that close a `then`.
    ends: Vec<usize>,
    /// Type names introduced by `typedef`.
    aliases: Vec<(u32, TypeWord)>,
    out: Vec<Token>,
    diagnostics: Vec<Diagnostic>,
    lost: Vec<Name>,
    /// Whether something was translated without a report.
    changed: bool,
    passed: Cell<usize>,
    /// Index of the error about the last parameter that is a pointer.
    pointer: Option<usize>,
}

impl<'a> Translator<'a> {
    /// Processes one token or one foreign construct.
    fn step(&mut self) {
        self.here = (self.at, self.sources.text(self.token(0).span));
        let may = self.diagnostics.len() < MAX_FORMS && self.token(0).is_direct();
        if may && (self.operator() || self.statement() || self.declaration() || self.pointer()) {
            return;
        }
        self.keep();
    }

    /// Copies the next token unchanged.
    fn keep(&mut self) {
        let token = self.token(0);
        self.at += 1;
        self.push(token);
    }

    fn push(&mut self, token: Token) {
        use TokenKind as T;
        self.out.push(token);
        match token.kind {
            T::LeftParen | T::LeftBracket => self.parens += 1,
            T::RightParen | T::RightBracket => self.parens = self.parens.saturating_sub(1),
            T::Question => self.questions += 1,
            T::Colon => self.questions = self.questions.saturating_sub(1),
            T::LeftBrace => self.braces += 1,
            T::RightBrace => self.braces = self.braces.saturating_sub(1),
            _ => {}
        }
        let ends = matches!(token.kind, T::LeftBrace | T::RightBrace);
        if ends || (token.kind == T::Semicolon && self.parens == 0) {
            self.start = self.out.len();
            self.questions = 0;
            if ends {
                self.parens = 0;
            }
        }
    }

    /// Emits a GLSL token in place of foreign text.
    fn put(&mut self, kind: TokenKind, value: u32, span: Span) {
        self.push(Token::direct(kind, value, span));
    }

    fn put_type(&mut self, word: TypeWord, span: Span) {
        self.put(TokenKind::Type, word as u32, span);
    }

    fn token(&self, ahead: usize) -> Token {
        let token = self.tokens.get(self.at + ahead).or(self.tokens.last());
        token.copied().unwrap_or(Token::END)
    }

    fn kind(&self, ahead: usize) -> TokenKind {
        self.token(ahead).kind
    }

    fn text(&self, ahead: usize) -> &'a str {
        match self.here {
            (at, text) if at == self.at + ahead => text,
            _ => self.sources.text(self.token(ahead).span),
        }
    }

    /// The identifier at an offset; empty for other tokens.
    fn word(&self, ahead: usize) -> &'a str {
        match self.kind(ahead) {
            TokenKind::Identifier => self.text(ahead),
            _ => "",
        }
    }

    /// Kind of the last token emitted.
    fn before(&self) -> TokenKind {
        self.out.last().map_or(TokenKind::End, |t| t.kind)
    }

    fn starts_statement(&self) -> bool {
        self.start == self.out.len()
    }

    /// Whether a token is directly followed by the next one, without whitespace.
    fn touches_next(&self, ahead: usize) -> bool {
        self.token(ahead).span.end == self.token(ahead + 1).span.start
    }

    /// Whether a line break separates a token from the one before it.
    fn starts_line(&self, ahead: usize) -> bool {
        let Some(before) = (self.at + ahead).checked_sub(1) else {
            return true;
        };
        let before = self.tokens.get(before).map_or(0, |t| t.span.end);
        let span = Span::new(before, self.token(ahead).span.start);
        span.start > span.end || self.sources.text(span).contains(['\n', '\r'])
    }

    /// Offset after the bracket that closes the one at `open`, relative to the next token.
    fn after(&self, open: usize) -> Option<usize> {
        use TokenKind as T;
        let mut depth = 0_u32;
        for ahead in open.. {
            if self.passed.get() >= MAX_PASSED {
                return None;
            }
            self.passed.set(self.passed.get() + 1);
            match self.kind(ahead) {
                T::LeftParen | T::LeftBracket | T::LeftBrace => depth += 1,
                T::RightParen | T::RightBracket | T::RightBrace => {
                    depth = depth.checked_sub(1)?;
                    if depth == 0 {
                        return Some(ahead + 1);
                    }
                }
                T::End => return None,
                _ if depth == 0 => return None,
                _ => {}
            }
        }
        None
    }

    /// Parses a type, including foreign ones and `vec3<f32>`, and returns the offset after it.
    fn type_at(&self, ahead: usize) -> Option<(TypeWord, usize)> {
        let word = match self.kind(ahead) {
            TokenKind::Type => *TypeWord::ALL.get(self.token(ahead).value as usize)?,
            TokenKind::Identifier | TokenKind::Reserved => self.foreign_type(self.text(ahead))?,
            _ => return None,
        };
        if self.kind(ahead + 1) != TokenKind::Less || self.kind(ahead + 3) != TokenKind::Greater {
            return Some((word, ahead + 1));
        }
        let (scalar, _) = self.plain_type(ahead + 2)?;
        let prefix = match scalar {
            TypeWord::Int => "i",
            TypeWord::Uint => "u",
            TypeWord::Bool => "b",
            _ => "",
        };
        match classify(&format!("{prefix}{}", word.name()), self.version) {
            WordClass::Type(word) => Some((word, ahead + 4)),
            _ => None,
        }
    }

    fn plain_type(&self, ahead: usize) -> Option<(TypeWord, usize)> {
        match self.kind(ahead) {
            TokenKind::Type => Some((
                *TypeWord::ALL.get(self.token(ahead).value as usize)?,
                ahead + 1,
            )),
            _ => Some((self.foreign_type(self.text(ahead))?, ahead + 1)),
        }
    }

    fn foreign_type(&self, word: &str) -> Option<TypeWord> {
        let Meaning::Type(word) = foreign(word, self.version)?.meaning else {
            return None;
        };
        match classify(word, self.version) {
            WordClass::Type(word) => Some(word),
            _ => None,
        }
    }

    /// The span from one upcoming token to just before another.
    fn span(&self, from: usize, after: usize) -> Span {
        self.token(from)
            .span
            .to(self.token(after.saturating_sub(1)).span)
    }

    /// Reports a construct of another language.
    fn report(&mut self, span: Span, message: impl Into<String>, fix: Option<Fix>) {
        let d = Diagnostic::error(error::FOREIGN_SYNTAX, span, message);
        self.diagnostics.push(d.fix(fix));
    }

    fn note(&mut self, note: &str) {
        if let Some(d) = self.diagnostics.last_mut() {
            d.notes.push(note.to_string());
        }
    }

    /// A fix that replaces `span` with `text`.
    fn write(span: Span, text: &str) -> Option<Fix> {
        Some(Fix::safe_replacement(span, text))
    }

    /// Removes text together with the blanks after it.
    fn remove(&self, from: usize, after: usize) -> Option<Fix> {
        let span = self.span(from, after);
        let next = self.token(after).span.start;
        let blank = Span::new(span.end, next.max(span.end));
        let file = self.sources.file_at(span.start);
        // The next token may be in another file.
        let is_blank = file.is_some_and(|f| f.span().contains(blank))
            && self
                .sources
                .text(blank)
                .bytes()
                .all(|b| matches!(b, b' ' | b'\t'));
        let span = if is_blank { span.to(blank) } else { span };
        Some(Fix::safe("remove it", vec![Edit::delete(span)]))
    }
}
