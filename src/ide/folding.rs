//! Folding ranges: blocks, comments, preprocessor groups. Based on tokens, so that they work in
//! incomplete code.

use super::document::Document;
use shaderlint_syntax::{ConditionalGroups, RawKind, TokenKind, tokenize};
use shaderlint_text::{LineIndex, Span};

/// A folding range.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct FoldingSpan {
    /// Start and end of the folded text in the document.
    pub span: Span,
    /// Kind of folding range.
    pub kind: FoldKind,
}

/// Kinds of folding ranges.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum FoldKind {
    /// Between brackets.
    Block,
    /// A block comment, or consecutive line comments.
    Comment,
    /// From `#if` to `#endif`.
    Group,
}

/// The folding ranges of a document.
pub fn folds(document: &Document) -> Vec<FoldingSpan> {
    let mut found = Vec::new();
    let mut seen: Vec<u32> = Vec::new();
    let sources = &document.report.sources;
    for (program, _) in document.shaders() {
        let Some(end) = program.tokens.tokens.last() else {
            continue;
        };
        let Some(code) = sources.code_at(end.span.start) else {
            continue;
        };
        if !seen.contains(&code.base) {
            seen.push(code.base);
            in_code(document, code.text, code.base, &mut found);
        }
    }
    found.sort_unstable();
    found.dedup();
    found
}

fn in_code(document: &Document, text: &str, base: u32, found: &mut Vec<FoldingSpan>) {
    let lines = LineIndex::new(text);
    let mut add = |start: u32, end: u32, kind| {
        if lines.line(start - base) < lines.line(end - base)
            && let Some(span) = document.report.in_input(Span::new(start, end))
        {
            found.push(FoldingSpan { span, kind });
        }
    };
    let tokens = tokenize(text, base);
    let mut open: Vec<u32> = Vec::new();
    let mut comments: Option<Span> = None;
    let mut at_start = true;
    for token in &tokens {
        if token.kind == RawKind::LineComment && at_start {
            comments = Some(comments.map_or(token.span, |c| c.to(token.span)));
        } else if !matches!(token.kind, RawKind::Whitespace | RawKind::Newline)
            || (token.kind == RawKind::Newline && at_start)
        {
            // An empty line separates groups of line comments.
            if let Some(run) = comments.take() {
                add(run.start, run.end, FoldKind::Comment);
            }
        }
        match token.kind {
            RawKind::BlockComment => add(token.span.start, token.span.end, FoldKind::Comment),
            RawKind::Operator(TokenKind::LeftBrace | TokenKind::LeftParen) => {
                open.push(token.span.end);
            }
            RawKind::Operator(TokenKind::RightBrace | TokenKind::RightParen) => {
                if let Some(start) = open.pop() {
                    add(start, token.span.start, FoldKind::Block);
                }
            }
            _ => {}
        }
        at_start = match token.kind {
            RawKind::Newline => true,
            RawKind::Whitespace => at_start,
            RawKind::LineComment => false,
            _ => false,
        };
    }
    if let Some(run) = comments {
        add(run.start, run.end, FoldKind::Comment);
    }
    for group in ConditionalGroups::of(text, base).all {
        for (from, to) in group.directives().zip(group.directives().skip(1)) {
            add(from.span.end, to.span.start, FoldKind::Group);
        }
    }
}
