//! Colours by meaning: what each name is, and what the compiler does not see.

use super::document::Document;
use super::index::NameUse;
use super::symbol::{Symbol, SymbolKind};
use shaderlint_semantic::Program;
use shaderlint_syntax::{RawKind, tokenize};
use shaderlint_text::Span;

/// What a stretch of the text is.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum SemanticKind {
    /// What a name means.
    Symbol(TokenClass),
    /// What the compiler does not see.
    Inactive,
}

/// The classes of names that editors colour.
#[expect(missing_docs, reason = "the variants are words of the protocol")]
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum TokenClass {
    Variable,
    Parameter,
    Property,
    Function,
    Struct,
    Macro,
}

/// A stretch with a colour.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct SemanticToken {
    /// Where, on one line of the text of the document.
    pub span: Span,
    /// What it is.
    pub kind: SemanticKind,
    /// Whether it is declared here.
    pub is_declaration: bool,
    /// Whether it cannot be written to.
    pub is_readonly: bool,
    /// Whether it is written to here.
    pub is_modification: bool,
    /// Whether the language or a host defines it.
    pub is_library: bool,
}

/// The stretches of a text that have a colour, in their order; none overlaps another.
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
    // Passes share a text: the first that reads it colours it.
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

/// The lines of a group that is left out.
fn unseen(document: &Document, span: Span, found: &mut Vec<SemanticToken>) {
    let text = document.report.sources.text(span);
    for raw in tokenize(text, span.start) {
        if matches!(raw.kind, RawKind::Whitespace | RawKind::Newline) {
            continue;
        }
        // A comment may go over several lines.
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
