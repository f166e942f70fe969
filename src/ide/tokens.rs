//! Semantic tokens: the kind of each name, and inactive code.

use super::document::Document;
use super::index::NameUse;
use super::symbol::{Symbol, SymbolKind};
use shaderlint_semantic::Program;
use shaderlint_syntax::{RawKind, tokenize};
use shaderlint_text::Span;

/// The kind of a semantic token.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum SemanticKind {
    /// A symbol of this class.
    Symbol(TokenClass),
    /// Inactive code.
    Inactive,
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
        for occurrence in index.all().iter().filter(|o| o.access != NameUse::Unseen) {
            if let Some(span) = document.report.in_input(occurrence.span) {
                found.push(token(program, occurrence.symbol, occurrence.access, span));
            }
        }
        for span in inactive.iter().filter(|s| program.is_user(**s)) {
            unseen(document, *span, &mut found);
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

/// The lines of an inactive group.
fn unseen(document: &Document, span: Span, found: &mut Vec<SemanticToken>) {
    let text = document.report.sources.text(span);
    for raw in tokenize(text, span.start) {
        if matches!(raw.kind, RawKind::Whitespace | RawKind::Newline) {
            continue;
        }
        // A comment may span several lines.
        let mut start = raw.span.start;
        for line in document.report.sources.text(raw.span).split_inclusive('\n') {
            let shown = line.trim_end_matches(['\n', '\r']).len() as u32;
            if let Some(span) = document.report.in_input(Span::new(start, start + shown)) {
                found.push(SemanticToken {
                    span,
                    kind: SemanticKind::Inactive,
                    is_declaration: false,
                    is_readonly: false,
                    is_modification: false,
                    is_library: false,
                });
            }
            start += line.len() as u32;
        }
    }
}
