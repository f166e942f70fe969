//! Semantic tokens: the kind of each name, and inactive code; in strings that no grammar of an
//! editor highlights, also all other tokens.

use super::document::Document;
use super::index::NameUse;
use super::symbol::{Symbol, SymbolKind};
use shaderlint_detect::embed::{Embedded, Wrapping};
use shaderlint_semantic::Program;
use shaderlint_syntax::{RawKind, RawToken, TokenKind, WordClass, classify, tokenize};
use shaderlint_text::Span;

/// The kind of a semantic token.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum SemanticKind {
    /// A symbol of this class.
    Symbol(TokenClass),
    /// Inactive code.
    Inactive,
    /// Any other token.
    Plain(PlainClass),
}

/// Classes of tokens by their spelling.
#[expect(missing_docs, reason = "variants are named as in the protocol")]
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum PlainClass {
    Comment,
    Function,
    Keyword,
    Number,
    Operator,
    Type,
    Variable,
}

/// Classes of names for highlighting.
#[expect(missing_docs, reason = "variants are named as in the protocol")]
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum TokenClass {
    Variable,
    Parameter,
    Property,
    Function,
    Struct,
    Macro,
}

/// A semantic token.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct SemanticToken {
    /// Span on a single line of the document.
    pub span: Span,
    /// Kind of the token.
    pub kind: SemanticKind,
    /// Whether it is a declaration.
    pub is_declaration: bool,
    /// Whether it is read-only.
    pub is_readonly: bool,
    /// Whether it is an assignment.
    pub is_modification: bool,
    /// Whether it is built in or declared by a host.
    pub is_library: bool,
}

/// The semantic tokens of a document in source order; they do not overlap.
pub fn semantic_tokens(document: &Document) -> Vec<SemanticToken> {
    let mut found = Vec::new();
    for (program, index) in document.shaders() {
        let inactive = &program.tokens.inactive;
        for occurrence in index.all.iter().filter(|o| o.access != NameUse::Unseen) {
            if let Some(span) = document.report.in_input(occurrence.span) {
                found.push(token(program, occurrence.symbol, occurrence.access, span));
            }
        }
        for span in inactive.iter().filter(|s| program.is_user(**s)) {
            unseen(document, *span, &mut found);
        }
    }
    for embedded in document.report.embedded() {
        if !is_highlighted(&document.text, embedded) {
            plain_tokens(document, embedded, &mut found);
        }
    }
    found.sort_unstable();
    let mut end = 0;
    // Several passes may contain the same text: the first determines its tokens.
    found.retain(|token| {
        let is_free = token.span.start >= end && !token.span.is_empty();
        if is_free {
            end = token.span.end;
        }
        is_free
    });
    found
}

fn token(program: &Program, symbol: Symbol, access: NameUse, span: Span) -> SemanticToken {
    let kind = symbol.kind(program);
    let class = match kind {
        SymbolKind::Parameter => TokenClass::Parameter,
        SymbolKind::Field => TokenClass::Property,
        SymbolKind::Function => TokenClass::Function,
        SymbolKind::Struct => TokenClass::Struct,
        SymbolKind::Macro => TokenClass::Macro,
        _ => TokenClass::Variable,
    };
    let declared = super::symbol::declared_at(program, symbol);
    let is_own = declared.is_some_and(|at| program.is_user(at));
    SemanticToken {
        span,
        kind: SemanticKind::Symbol(class),
        is_declaration: matches!(access, NameUse::Declared | NameUse::Defined),
        is_readonly: matches!(
            kind,
            SymbolKind::Constant | SymbolKind::Uniform | SymbolKind::Input
        ),
        is_modification: matches!(access, NameUse::Written | NameUse::Changed),
        is_library: !is_own && !matches!(symbol, Symbol::MacroParameter(..)),
    }
}

/// A token without modifiers.
fn unmodified(span: Span, kind: SemanticKind) -> SemanticToken {
    SemanticToken {
        span,
        kind,
        is_declaration: false,
        is_readonly: false,
        is_modification: false,
        is_library: false,
    }
}

/// The lines of a text that starts at an address, without line breaks; a comment may have several.
fn lines(text: &str, mut start: u32) -> impl Iterator<Item = Span> {
    text.split_inclusive('\n').map(move |line| {
        let shown = line.trim_end_matches(['\n', '\r']).len() as u32;
        let span = Span::new(start, start + shown);
        start += line.len() as u32;
        span
    })
}

/// The lines of an inactive group.
fn unseen(document: &Document, span: Span, found: &mut Vec<SemanticToken>) {
    let sources = &document.report.sources;
    for raw in tokenize(sources.text(span), span.start) {
        if matches!(raw.kind, RawKind::Whitespace | RawKind::Newline) {
            continue;
        }
        let all = lines(sources.text(raw.span), raw.span.start);
        let own = all.filter_map(|line| document.report.in_input(line));
        found.extend(own.map(|span| unmodified(span, SemanticKind::Inactive)));
    }
}

/// Whether the grammar of an editor highlights a shader: it is not a string, or one with a tag, with a
/// comment that names the language, or with `#version` at its start.
fn is_highlighted(text: &str, embedded: &Embedded) -> bool {
    let before = text.get(..embedded.start).unwrap_or("");
    match embedded.wrapping {
        Wrapping::Quotes | Wrapping::Raw => false,
        Wrapping::Template => {
            let before = before.trim_end().trim_end_matches('`').trim_end();
            let is_tag = before.ends_with(|c: char| c.is_alphanumeric() || c == '_');
            let has_comment = before.ends_with("*/");
            let code = embedded.code.trim_start();
            is_tag && !before.ends_with("return") || has_comment || code.starts_with("#version")
        }
        Wrapping::Element | Wrapping::Fence | Wrapping::Listing => true,
    }
}

/// All tokens of a shader in a string; what the string's language inserts is left out.
fn plain_tokens(document: &Document, embedded: &Embedded, found: &mut Vec<SemanticToken>) {
    let base = embedded.start as u32;
    let Some(spot) = document.spot(base) else {
        return;
    };
    let tokens = tokenize(&embedded.code, base);
    let word = |raw: &RawToken| {
        let range = (raw.span.start - base) as usize..(raw.span.end - base) as usize;
        embedded.code.get(range).unwrap_or("")
    };
    let mut is_directive = false;
    for (i, raw) in tokens.iter().enumerate() {
        let is_name = std::mem::replace(&mut is_directive, raw.kind == RawKind::Hash);
        let class = match raw.kind {
            RawKind::LineComment | RawKind::BlockComment | RawKind::OpenComment => {
                PlainClass::Comment
            }
            RawKind::Integer | RawKind::Float => PlainClass::Number,
            RawKind::Operator(_) => PlainClass::Operator,
            RawKind::Hash => PlainClass::Keyword,
            RawKind::Word if is_name => PlainClass::Keyword,
            RawKind::Word => match classify(word(raw), spot.program().version) {
                WordClass::Keyword(_) => PlainClass::Keyword,
                WordClass::Type(_) => PlainClass::Type,
                _ => match tokens.get(i + 1).map(|next| next.kind) {
                    Some(RawKind::Operator(TokenKind::LeftParen)) => PlainClass::Function,
                    _ => PlainClass::Variable,
                },
            },
            _ => continue,
        };
        let spans = lines(word(raw), raw.span.start);
        let own = spans.filter(|span| embedded.is_verbatim(&document.text, *span));
        found.extend(own.map(|span| unmodified(span, SemanticKind::Plain(class))));
    }
}
