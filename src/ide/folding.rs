//! Folding ranges: blocks, comments, preprocessor groups. Based on tokens, so that they work in
//! incomplete code.

use super::document::Document;
use shaderlint_syntax::{RawKind, RawToken, TokenKind, tokenize};
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
    let mut groups: Vec<u32> = Vec::new();
    let mut comments: Option<Span> = None;
    let mut at_start = true;
    for (i, token) in tokens.iter().enumerate() {
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
            RawKind::Hash if at_start => match directive(text, base, tokens.get(i..)) {
                "if" | "ifdef" | "ifndef" => groups.push(line_end(&lines, text, base, token)),
                "else" | "elif" => {
                    if let Some(start) = groups.pop() {
                        add(start, token.span.start, FoldKind::Group);
                    }
                    groups.push(line_end(&lines, text, base, token));
                }
                "endif" => {
                    if let Some(start) = groups.pop() {
                        add(start, token.span.start, FoldKind::Group);
                    }
                }
                _ => {}
            },
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
}

/// The name of the directive at the start of some tokens.
fn directive<'t>(text: &'t str, base: u32, tokens: Option<&[RawToken]>) -> &'t str {
    let mut words = tokens.unwrap_or(&[]).iter().skip(1).take(2);
    let word = words.find(|t| t.kind == RawKind::Word);
    let span = word.map(|t| (t.span.start - base) as usize..(t.span.end - base) as usize);
    span.and_then(|span| text.get(span)).unwrap_or("")
}

/// The end of the line of a token.
fn line_end(lines: &LineIndex, text: &str, base: u32, token: &RawToken) -> u32 {
    let (start, end) = lines.bounds(token.span.start - base, text.len() as u32);
    let line = text.get(start as usize..end as usize).unwrap_or("");
    base + start + line.trim_end_matches(['\n', '\r']).len() as u32
}
